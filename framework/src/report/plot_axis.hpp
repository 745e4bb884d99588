#pragma once

#include <string>
#include <vector>

namespace matpoint {

/// An axis of a plot: the range that holds its values, their pixels, its ticks.
class PlotAxis {
  public:
    struct Tick {
        double pixel;
        std::string label;  ///< SVG markup; empty: a minor tick
    };

    /// Runs from the pixel `first` to the pixel `last`, wide enough for all values that it shows.
    PlotAxis(bool logarithmic, const std::vector<double>& values, double first, double last);

    /// A logarithmic axis has no place for zero and negative numbers, none has for NaN and infinity.
    bool shows(double value) const;
    /// Of a value that it shows.
    double pixel(double value) const { return at(coordinate(value)); }
    std::vector<Tick> ticks() const;

  private:
    double coordinate(double value) const;
    double at(double coordinate) const;
    std::vector<Tick> decades() const;
    std::vector<Tick> parts_of_decades() const;
    std::vector<Tick> even_steps() const;

    bool logarithmic_;
    bool empty_ = false;
    double first_, last_;
    double low_, high_;  // of the value or, on a logarithmic axis, of its decimal logarithm
};

}  // namespace matpoint
