#pragma once

#include "report/svg_plot.hpp"

#include <vector>

namespace matpoint {

/// A stretch of y ~ x^slope on logarithmic axes.
struct SlopeGuide {
    double slope;
    double from_x, from_y, to_x, to_y;
};

/// A guide for each slope, side by side below the points near it, so that none crosses the data.
std::vector<SlopeGuide> slope_guides(const std::vector<PlotSeries>& series,
                                     const std::vector<double>& slopes);

}  // namespace matpoint
