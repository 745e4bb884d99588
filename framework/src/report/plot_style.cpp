#include "report/plot_style.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace matpoint {
namespace {

constexpr std::array<const char*, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#000000"};

/// A regular polygon or star with its first corner at `angle` (degrees; 90 is up).
struct Corners {
    int count;
    double angle;
    double size;   // of the radius, so that all shapes look equally large
    double inner;  // of every second corner; 1 for a polygon
};
constexpr int marker_count = 8;
constexpr std::array<Corners, marker_count - 1> shapes{{{4, 45, 1.2, 1},
                                                        {3, 90, 1.4, 1},
                                                        {4, 90, 1.35, 1},
                                                        {3, -90, 1.4, 1},
                                                        {10, 90, 1.6, 0.45},
                                                        {6, 90, 1.2, 1},
                                                        {8, 90, 1.6, 0.35}}};

}  // namespace

std::string colour_of(PlotStyle style) {
    return colours[style.colour % colours.size()];
}

std::string marker_path(PlotStyle style, double x, double y, double radius) {
    const std::size_t shape = style.marker % marker_count;
    if (shape == 0) {
        return fmt::format(
            "M{0:.1f} {1:.1f}m-{2:.2f} 0a{2:.2f} {2:.2f} 0 1 0 {3:.2f} 0a{2:.2f} {2:.2f} 0 1 0 -{3:.2f} 0z",
            x, y, radius, 2 * radius);
    }
    const Corners& corners = shapes[shape - 1];
    std::string path = fmt::format("M{:.1f} {:.1f}m", x, y);
    double from_x = 0, from_y = 0;
    for (int i = 0; i < corners.count; ++i) {
        const double angle = (corners.angle + 360.0 * i / corners.count) * std::numbers::pi / 180;
        const double size = radius * corners.size * (i % 2 == 1 ? corners.inner : 1);
        const double to_x = size * std::cos(angle), to_y = -size * std::sin(angle);
        path += fmt::format("{:.1f} {:.1f}{}", to_x - from_x, to_y - from_y, i == 0 ? "l" : " ");
        from_x = to_x;
        from_y = to_y;
    }
    path.back() = 'z';
    return path;
}

std::string cross_path(double x, double y, double radius) {
    return fmt::format("M{0:.1f} {1:.1f}m-{2:.1f} -{2:.1f}l{3:.1f} {3:.1f}m0 -{3:.1f}l-{3:.1f} {3:.1f}", x, y,
                       radius, 2 * radius);
}

}  // namespace matpoint
