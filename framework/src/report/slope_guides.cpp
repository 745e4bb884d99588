#include "report/slope_guides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace matpoint {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Logarithms {
    double x, y;
};
using Line = std::vector<Logarithms>;  // in the order of x

std::vector<Line> lines_through(const std::vector<PlotSeries>& series) {
    std::vector<Line> lines;
    for (const PlotSeries& one : series) {
        Line& line = lines.emplace_back();
        for (const auto& [x, y, text] : one.points) {
            if (x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y))
                line.push_back({std::log10(x), std::log10(y)});
        }
        std::sort(line.begin(), line.end(),
                  [](const Logarithms& a, const Logarithms& b) { return a.x < b.x; });
    }
    return lines;
}

/// The height at x = 1 of the highest guide that has no point of the lines below it from `from` to `to`.
double highest_offset(const std::vector<Line>& lines, double slope, double from, double to) {
    double offset = infinity;
    for (const Line& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Logarithms& a = line[i];
            if (a.x >= from && a.x <= to) offset = std::min(offset, a.y - slope * a.x);
            if (i + 1 == line.size()) continue;
            const Logarithms& b = line[i + 1];
            for (const double x : {from, to}) {  // within, a straight line is lowest at an end
                if (!(a.x < x && x < b.x)) continue;
                offset = std::min(offset, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) - slope * x);
            }
        }
    }
    return offset;
}

}  // namespace

std::vector<SlopeGuide> slope_guides(const std::vector<PlotSeries>& series,
                                     const std::vector<double>& slopes) {
    const std::vector<Line> lines = lines_through(series);
    double left = infinity, right = -infinity, lowest = infinity, highest = -infinity;
    for (const Line& line : lines) {
        for (const auto& [x, y] : line) {
            left = std::min(left, x);
            right = std::max(right, x);
            lowest = std::min(lowest, y);
            highest = std::max(highest, y);
        }
    }
    std::vector<SlopeGuide> guides;
    if (!(right > left)) return guides;
    const double window = (right - left) / static_cast<double>(slopes.size());
    const double width = std::min(0.75 * window, 0.4 * (right - left));
    const double gap = 0.06 * (highest - lowest) + 0.05;  // decades
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const double slope = slopes[i], middle = left + window * (static_cast<double>(i) + 0.5);
        const double from = middle - width / 2, to = middle + width / 2;
        const double offset = highest_offset(lines, slope, from, to);
        if (!std::isfinite(offset)) continue;  // no line comes by
        const auto y_at = [&](double x) { return std::pow(10.0, slope * x + offset - gap); };
        guides.push_back({slope, std::pow(10.0, from), y_at(from), std::pow(10.0, to), y_at(to)});
    }
    return guides;
}

}  // namespace matpoint
