#include "particles/line_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace matpoint {

namespace {

/// Gauss-Legendre quadrature on [0, 1]: exact up to the seventh power.
struct Node {
    double at, weight;
};
constexpr std::array<Node, 4> gauss = {Node{0.06943184420297371, 0.17392742256872693},
                                       {0.33000947820757187, 0.32607257743127307},
                                       {0.66999052179242813, 0.32607257743127307},
                                       {0.93056815579702629, 0.17392742256872693}};

}  // namespace

LineRule::LineRule(std::span<const double> planes, std::vector<double> cuts, double resolution, int parts)
    : begins_{0} {
    std::ranges::sort(cuts);
    auto cut = cuts.begin();
    for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
        const double min = planes[i], max = planes[i + 1], length = max - min;
        std::vector<double> ends{min};
        for (; cut != cuts.end() && *cut < max - resolution; ++cut)
            if (*cut > ends.back() + resolution) ends.push_back(*cut);
        ends.push_back(max);
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            const double reach = ends[k + 1] - ends[k];
            const auto pieces = std::max(1, static_cast<int>(std::ceil(parts * reach / length)));
            for (int piece = 0; piece < pieces; ++piece)
                for (const Node& node : gauss) {
                    const double local = (ends[k] - min + (piece + node.at) / pieces * reach) / length;
                    points_.push_back(
                        {min + local * length, local - 0.5, node.weight / pieces * reach / length});
                }
        }
        begins_.push_back(points_.size());
    }
}

}  // namespace matpoint
