#pragma once

#include <matpoint/columns.hpp>

#include <span>
#include <vector>

namespace matpoint {

/// Where lines cross an axis to sum up a region's sections: for each interval between neighbouring planes,
/// points of Gauss quadrature, whose weights add up to 1. Intervals are cut where the section may change at
/// once, so that the sum is exact for boxes, and for all others their own faces are no source of error.
class LineRule {
  public:
    struct Point {
        double coordinate;  ///< m
        double local;       ///< from the interval's middle, in parts of it
        double weight;
    };

    /// Of an axis that the space lacks: one interval, one line, at 0.
    LineRule() : points_{{0, 0, 1}}, begins_{0, 1} {}
    /// `planes` ascend; `cuts` that are nearer than `resolution` to a plane, or to each other, are one. An
    /// interval has four points, or four in each of `parts` equal parts.
    LineRule(std::span<const double> planes, std::vector<double> cuts, double resolution, int parts);

    Index intervals() const { return std::ssize(begins_) - 1; }
    std::span<const Point> points(Index interval) const {
        const auto i = static_cast<std::size_t>(interval);
        return std::span(points_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
    }

  private:
    std::vector<Point> points_;
    std::vector<std::size_t> begins_;  ///< by interval, its first point; then the number of all
};

}  // namespace matpoint
