#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/parallel.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace matpoint {

/// Equal parts of a box, each seen at its middle.
class BoxSamples {
  public:
    /// `counts` along each axis; 1 along those that the space lacks, where the box is flat.
    BoxSamples(const Geometry::Bounds& box, const std::array<Index, 3>& counts) : box_(box), counts_(counts) {
        for (int a = 0; a < 3; ++a)
            size_[a] = (box.max[a] - box.min[a]) / static_cast<double>(counts[static_cast<std::size_t>(a)]);
    }

    Index count() const { return counts_[0] * counts_[1] * counts_[2]; }
    /// Length, area or volume of a part.
    double part(int dimension) const { return size_.head(dimension).prod(); }

    /// Sum of what `measure` says of the middles, which it gets some at a time, on several threads.
    double sum(const std::function<double(std::span<const Eigen::Vector3d>)>& measure) const {
        constexpr Index per_piece = 8192;
        const Index pieces = (count() + per_piece - 1) / per_piece;
        std::vector<double> sums(static_cast<std::size_t>(pieces));
        parallel_for(pieces, count(), [&](Index piece) {
            std::vector<Eigen::Vector3d> middles;
            for (Index k = piece * per_piece; k < std::min(count(), (piece + 1) * per_piece); ++k)
                middles.push_back(middle(k));
            sums[static_cast<std::size_t>(piece)] = measure(middles);
        });
        return std::accumulate(sums.begin(), sums.end(), 0.0);
    }

  private:
    Eigen::Vector3d middle(Index k) const {
        const Index row = k / counts_[0];
        const Eigen::Vector3d number(static_cast<double>(k % counts_[0]),
                                     static_cast<double>(row % counts_[1]),
                                     static_cast<double>(row / counts_[1]));
        return box_.min + size_.cwiseProduct(number + Eigen::Vector3d::Constant(0.5));
    }

    Geometry::Bounds box_;
    std::array<Index, 3> counts_;
    Eigen::Vector3d size_;
};

}  // namespace matpoint
