#pragma once

#include <matpoint/geometry.hpp>

#include "particles/filling.hpp"
#include "particles/line_rule.hpp"

#include <vector>

namespace matpoint {

/// The parts of a lattice's places along one line of places, as lines of a region through them fill them.
class FilledLine {
  public:
    /// `planes`: ends of the parts. What is nearer to a plane than `resolution` is on it.
    FilledLine(const std::vector<double>& planes, double resolution);

    void clear();
    /// What a line at two points of the rules across it has of the region.
    void add(const Intervals& intervals, const LineRule::Point& y, const LineRule::Point& z);
    /// Whether each of the lines fills the part from end to end.
    bool is_whole(std::size_t place) const { return whole_[place] == lines_; }
    /// What the lines fill of the parts that are not whole.
    const std::vector<Filling>& fill();

  private:
    struct Section {
        double begin, end;  ///< in places
        double y, z, weight;
    };

    double in_places(double x) const;

    const std::vector<double>& planes_;
    double resolution_;
    std::vector<Filling> fillings_;
    std::vector<std::size_t> whole_;  ///< lines that fill the part from end to end
    std::size_t lines_ = 0;
    std::vector<Section> sections_;
};

}  // namespace matpoint
