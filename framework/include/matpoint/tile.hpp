#pragma once

#include <matpoint/grid.hpp>

#include <algorithm>

namespace matpoint {

/// The blocks around one block, as far as given particles reach: a small dense lattice with fixed strides, so
/// that the loops over a stencil need no look-up. Three blocks an axis hold the stencils that begin in the
/// middle one or a cell beside it.
template <class S>
class Tile {
  public:
    using Real = typename S::Real;
    using Coordinates = typename Patch<S>::Coordinates;
    static constexpr int D = S::dimension;
    static constexpr int edge = 3 * Patch<S>::block_edge;  ///< nodes an axis
    static constexpr int nodes = D == 1 ? edge : D == 2 ? edge * edge : edge * edge * edge;
    static constexpr int stride(int axis) { return axis == 0 ? 1 : axis == 1 ? edge : edge * edge; }

    /// Around the block of the first node of a stencil, for stencils of `width` nodes an axis.
    Tile(const Patch<S>& patch, const Coordinates& base, int width)
        : patch_(&patch), width_(width), lowest_(base), highest_(base) {
        for (std::size_t a = 0; a < D; ++a) {
            first_block_[a] = Patch<S>::block_of(base[a]) - 1;
            origin_[a] = first_block_[a] * Patch<S>::block_edge - 1;
        }
    }

    /// Whether the stencil from `base` on lies within.
    bool holds(const Coordinates& base) const {
        for (std::size_t a = 0; a < D; ++a)
            if (base[a] < origin_[a] || base[a] + width_ > origin_[a] + edge) return false;
        return true;
    }
    void include(const Coordinates& base) {
        for (std::size_t a = 0; a < D; ++a) {
            lowest_[a] = std::min(lowest_[a], base[a]);
            highest_[a] = std::max(highest_[a], base[a]);
        }
    }
    const Coordinates& origin() const { return origin_; }
    /// Of the first nodes of the stencils that were included.
    const Coordinates& lowest() const { return lowest_; }
    const Coordinates& highest() const { return highest_; }

    /// Calls visit(place in the tile, place in the patch's columns) for rows of nodes along the first axis,
    /// each of a whole block's edge, which together hold every stencil that was included.
    template <class Visit>
    void visit_rows(const Visit& visit) const {
        constexpr int b = Patch<S>::block_edge;
        Coordinates low, high, first, last;
        for (std::size_t a = 0; a < D; ++a) {
            low[a] = lowest_[a] - origin_[a];
            high[a] = highest_[a] - origin_[a] + width_;
            first[a] = low[a] / b;
            last[a] = (high[a] - 1) / b;
        }
        Coordinates block = first;
        do {
            Coordinates number = block;
            int local_low[3] = {0, 0, 0}, local_high[3] = {1, 1, 1};
            for (std::size_t a = 0; a < D; ++a) {
                number[a] += first_block_[a];
                local_low[a] = std::max(low[a] - block[a] * b, 0);
                local_high[a] = std::min(high[a] - block[a] * b, b);
            }
            const Index start = patch_->block_place(number);
            int corner = 0;
            for (std::size_t a = 0; a < D; ++a) corner += block[a] * b * stride(static_cast<int>(a));
            for (int z = local_low[2]; z < local_high[2]; ++z)
                for (int y = local_low[1]; y < local_high[1]; ++y) {
                    const int row = (z * b + y) * b;
                    visit(corner + z * edge * edge + y * edge, start + row);
                }
        } while (advance(block, first, last));
    }

  private:
    static bool advance(Coordinates& block, const Coordinates& first, const Coordinates& last) {
        for (std::size_t a = 0; a < D; ++a) {
            if (++block[a] <= last[a]) return true;
            block[a] = first[a];
        }
        return false;
    }

    const Patch<S>* patch_;
    int width_;
    Coordinates lowest_, highest_;
    Coordinates first_block_, origin_;  ///< of the tile's first node
};

}  // namespace matpoint
