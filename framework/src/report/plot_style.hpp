#pragma once

#include <cstddef>
#include <string>

namespace matpoint {

/// Colour and shape of a series' marks, counted from 0. Colours repeat after 7 and shapes after 8, so
/// that equal counts of both differ for the first 56.
struct PlotStyle {
    std::size_t colour = 0;
    std::size_t marker = 0;
};

/// Of the palette of Okabe & Ito (2008), which colour-blind readers can tell apart, without its yellow.
std::string colour_of(PlotStyle style);

/// SVG path data of a mark about (x, y) with the given radius in pixels.
std::string marker_path(PlotStyle style, double x, double y, double radius);

/// SVG path data of a × about (x, y).
std::string cross_path(double x, double y, double radius);

}  // namespace matpoint
