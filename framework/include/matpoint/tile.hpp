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

    /// Around the block of a node.
    Tile(const Patch<S>& patch, const Coordinates& node) : patch_(&patch) {
        for (std::size_t a = 0; a < D; ++a) {
            first_block_[a] = Patch<S>::block_of(node[a]) - 1;
            origin_[a] = first_block_[a] * Patch<S>::block_edge - 1;
            low_[a] = edge;
            high_[a] = 0;
        }
    }

    /// Whether a stencil of `width` nodes an axis from `base` on lies within.
    bool holds(const Coordinates& base, int width) const {
        for (std::size_t a = 0; a < D; ++a)
            if (base[a] < origin_[a] || base[a] + width > origin_[a] + edge) return false;
        return true;
    }
    void include(const Coordinates& base, int width) {
        for (std::size_t a = 0; a < D; ++a) {
            low_[a] = std::min(low_[a], base[a] - origin_[a]);
            high_[a] = std::max(high_[a], base[a] - origin_[a] + width);
        }
    }
    const Coordinates& origin() const { return origin_; }

    /// Calls visit(place in the tile, place in the patch's columns, count) for rows of nodes along the first
    /// axis, which together hold every stencil that was included.
    template <class Visit>
    void visit_rows(const Visit& visit) const {
        constexpr int b = Patch<S>::block_edge;
        Coordinates first{}, last{};
        for (std::size_t a = 0; a < D; ++a) {
            first[a] = low_[a] / b;
            last[a] = (high_[a] - 1) / b;
        }
        Coordinates block = first;
        do {
            Coordinates number = block;
            int local_low[3] = {0, 0, 0}, local_high[3] = {1, 1, 1};
            for (std::size_t a = 0; a < D; ++a) {
                number[a] += first_block_[a];
                local_low[a] = std::max(low_[a] - block[a] * b, 0);
                local_high[a] = std::min(high_[a] - block[a] * b, b);
            }
            const Index start = patch_->block_place(number);
            int corner = 0;
            for (std::size_t a = 0; a < D; ++a) corner += block[a] * b * stride(static_cast<int>(a));
            for (int z = local_low[2]; z < local_high[2]; ++z)
                for (int y = local_low[1]; y < local_high[1]; ++y)
                    visit(corner + z * edge * edge + y * edge + local_low[0],
                          start + (z * b + y) * b + local_low[0], local_high[0] - local_low[0]);
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
    Coordinates first_block_, origin_;  ///< of the tile's first node; in the patch
    Coordinates low_, high_;            ///< nodes in use, in the tile
};

}  // namespace matpoint
