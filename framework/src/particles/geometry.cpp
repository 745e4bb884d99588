#include <matpoint/geometry.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matpoint {

namespace {

/// Points that are asked for at a time, about.
constexpr std::size_t points_at_a_time = 65536;

/// Where the region begins or ends between two points of a line, of which only `inside` is in it.
struct Crossing {
    std::size_t line;
    double inside, outside;
};

/// Halves the distance of all crossings' points until there is no number between them.
void narrow(const Geometry& region, std::span<const Eigen::Vector2d> lines,
            std::vector<Crossing>& crossings) {
    std::vector<Eigen::Vector3d> middles(crossings.size());
    for (bool any = true; any;) {
        any = false;
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            const Crossing& c = crossings[i];
            middles[i] << (c.inside + c.outside) / 2, lines[c.line];
        }
        const std::vector<char> inside = region.contains(middles);
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            double& end = inside[i] ? crossings[i].inside : crossings[i].outside;
            any = any || (middles[i][0] != crossings[i].inside && middles[i][0] != crossings[i].outside);
            end = middles[i][0];
        }
    }
}

void search(const Geometry& region, std::span<const Eigen::Vector2d> lines, Interval within,
            std::size_t steps, std::span<Intervals> found) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(lines.size() * (steps + 1));
    for (const Eigen::Vector2d& line : lines)
        for (std::size_t k = 0; k <= steps; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(steps);
            points.emplace_back(within.begin + share * (within.end - within.begin), line[0], line[1]);
        }
    const std::vector<char> inside = region.contains(points);
    std::vector<Crossing> crossings;
    for (std::size_t line = 0; line < lines.size(); ++line)
        for (std::size_t k = line * (steps + 1); k < line * (steps + 1) + steps; ++k) {
            const double x = points[k][0], next = points[k + 1][0];
            if (inside[k] && !inside[k + 1]) crossings.push_back({line, x, next});
            if (!inside[k] && inside[k + 1]) crossings.push_back({line, next, x});
        }
    narrow(region, lines, crossings);
    auto crossing = crossings.begin();
    for (std::size_t line = 0; line < lines.size(); ++line) {
        std::vector<double> ends;
        if (inside[line * (steps + 1)]) ends.push_back(within.begin);
        for (; crossing != crossings.end() && crossing->line == line; ++crossing)
            ends.push_back(std::max(crossing->inside, crossing->outside));
        if (inside[line * (steps + 1) + steps]) ends.push_back(within.end);
        for (std::size_t k = 0; k + 1 < ends.size(); k += 2) found[line].push_back({ends[k], ends[k + 1]});
    }
}

}  // namespace

std::vector<Intervals> Geometry::along_x(std::span<const Eigen::Vector2d> lines, Interval within,
                                         double step) const {
    const double steps = std::clamp(std::ceil((within.end - within.begin) / step), 1.0, 1e6);
    const auto count = static_cast<std::size_t>(steps);
    const std::size_t at_a_time = std::max<std::size_t>(1, points_at_a_time / (count + 1));
    std::vector<Intervals> found(lines.size());
    for (std::size_t first = 0; first < lines.size(); first += at_a_time) {
        const std::size_t size = std::min(at_a_time, lines.size() - first);
        search(*this, lines.subspan(first, size), within, count, std::span(found).subspan(first, size));
    }
    return found;
}

SignedDistance Geometry::signed_distance(const Eigen::Vector3d&) const {
    throw std::invalid_argument(
        "this geometry tells no distance from its surface, as a tool must: take one with a surface, such as "
        "\"box\", \"sphere\", \"wedge\" or \"stl\"");
}

}  // namespace matpoint
