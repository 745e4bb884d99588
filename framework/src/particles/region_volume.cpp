#include "particles/region_volume.hpp"

#include <matpoint/parallel.hpp>
#include <matpoint/space.hpp>

#include "particles/line_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace matpoint {

namespace {

/// Parts of the bounds along an axis, each with four lines.
template <class S>
constexpr int rule_parts = S::dimension == 2 ? 256 : 32;
/// Points that are tried along a line where the geometry knows no better.
constexpr int steps = 100;
/// Rows of lines that are asked for at a time.
constexpr std::size_t rows_at_a_time = 16;

template <class S>
double section(const Interval& interval) {
    if constexpr (S::axisymmetric)
        return std::numbers::pi * (interval.end * interval.end - interval.begin * interval.begin);
    return interval.end - interval.begin;
}

}  // namespace

template <class S>
std::optional<double> volume_of(const Geometry& region) {
    const Geometry::Bounds bounds = region.bounds();
    if (region.points() || !bounds.min.allFinite() || !bounds.max.allFinite()) return {};
    const Interval within{S::axisymmetric ? std::max(0.0, bounds.min[0]) : bounds.min[0], bounds.max[0]};
    if (!(within.begin < within.end)) return 0;
    std::array<LineRule, 3> rules;
    double width = 1;
    for (int a = 1; a < S::dimension; ++a) {
        const std::array<double, 2> ends{bounds.min[a], bounds.max[a]};
        if (!(ends[0] < ends[1])) return 0;
        const double resolution =
            4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(ends[0]), std::abs(ends[1]));
        rules[static_cast<std::size_t>(a)] = LineRule(ends, region.breaks(a), resolution, rule_parts<S>);
        width *= ends[1] - ends[0];
    }

    const auto y = rules[1].points(0), z = rules[2].points(0);
    std::vector<double> sums((z.size() + rows_at_a_time - 1) / rows_at_a_time);
    parallel_for(std::ssize(sums), std::ssize(y) * std::ssize(z), [&](Index number) {
        const auto first = static_cast<std::size_t>(number) * rows_at_a_time;
        const auto rows = z.subspan(first, std::min(rows_at_a_time, z.size() - first));
        std::vector<Eigen::Vector2d> lines;
        for (const LineRule::Point& row : rows)
            for (const LineRule::Point& point : y) lines.emplace_back(point.coordinate, row.coordinate);
        const std::vector<Intervals> found =
            region.along_x(lines, within, (within.end - within.begin) / steps);
        double& sum = sums[static_cast<std::size_t>(number)];
        for (std::size_t i = 0; i < lines.size(); ++i)
            for (const Interval& interval : found[i]) {
                const Interval part{std::max(interval.begin, within.begin),
                                    std::min(interval.end, within.end)};
                if (part.begin < part.end)
                    sum += section<S>(part) * y[i % y.size()].weight * rows[i / y.size()].weight;
            }
    });
    double volume = 0;
    for (const double sum : sums) volume += sum * width;
    if (!std::isfinite(volume)) return {};
    return volume;
}

#define MATPOINT_INSTANTIATE(S) template std::optional<double> volume_of<S>(const Geometry&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
