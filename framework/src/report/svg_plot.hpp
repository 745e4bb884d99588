#pragma once

#include "report/plot_style.hpp"

#include <optional>
#include <string>
#include <vector>

namespace matpoint {

struct PlotPoint {
    double x = 0;
    double y = 0;
    std::string text = {};  ///< shown when the pointer rests on it
};

struct PlotSeries {
    std::string name;
    PlotStyle style = {};
    std::vector<PlotPoint> points = {};
    std::vector<PlotPoint> broken = {};  ///< have no y: crosses in a strip above the plot
};

struct Plot {
    struct Axis {
        std::string label;
        bool logarithmic = true;
    };
    std::string title;
    Axis x, y;
    std::vector<PlotSeries> series = {};
    bool lines = false;               ///< joins the points of a series in the order of x, unless an x repeats
    std::vector<double> slopes = {};  ///< guides; on two logarithmic axes only
    std::vector<PlotPoint> front = {};  ///< a line through these
    std::optional<double> target = {};  ///< a level of y
    std::optional<PlotPoint> best = {};
};

/// A picture that stands alone. Points that a logarithmic axis can't show (error 0) are hollow marks
/// at its lower end.
std::string svg(const Plot& plot);

}  // namespace matpoint
