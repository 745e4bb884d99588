#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/grid.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace matpoint {

/// A lattice of places for particles, equally many in every cell of the grid, as far as a box reaches. It is
/// handed out in pieces, so that the list of all places never exists.
template <class S>
class CellLattice {
  public:
    /// Throws std::invalid_argument if there are more places than the particles' numbers can tell apart.
    CellLattice(const Patch<S>& patch, const Geometry::Bounds& box, const std::array<int, 3>& per_cell);

    /// A piece is some rows of cells along x. Piece by piece, places go cell by cell.
    Index pieces() const { return (rows() + rows_per_piece_ - 1) / rows_per_piece_; }
    std::vector<Eigen::Vector3d> piece(Index number) const;
    /// Calls `take` with the places of a piece, one after the other.
    template <class Take>
    void for_each(Index piece, const Take& take) const;
    /// Places in all.
    Index size() const { return rows() * row_size(); }
    /// Half-lengths of a place's part of its cell, m, and its length, area or volume, m^D.
    const Eigen::Vector3d& half_size() const { return half_size_; }
    double area() const { return area_; }

  private:
    /// The lattice's coordinates along an axis in cells first … last - 1, and nothing for missing axes.
    struct Axis {
        int first = 0, last = 1;
        int per_cell = 1;
        std::vector<double> coordinates{0.0};

        Index cells() const { return last - first; }
        double at(int cell, int k) const {
            const int place = (cell - first) * per_cell + k;
            return coordinates[static_cast<std::size_t>(place)];
        }
    };

    static Axis make_axis(const Patch<S>& patch, const Geometry::Bounds& box, int a, int per_cell);
    Index rows() const { return axes_[1].cells() * axes_[2].cells(); }
    Index row_size() const {
        return axes_[0].cells() * axes_[0].per_cell * axes_[1].per_cell * axes_[2].per_cell;
    }

    std::array<Axis, 3> axes_;
    Eigen::Vector3d half_size_ = Eigen::Vector3d::Zero();
    double area_ = 1;
    Index rows_per_piece_ = 1;
};

template <class S>
template <class Take>
void CellLattice<S>::for_each(Index piece, const Take& take) const {
    const auto& [x, y, z] = axes_;
    const Index begin = piece * rows_per_piece_, end = std::min(rows(), begin + rows_per_piece_);
    for (Index row = begin; row < end; ++row) {
        const int cy = y.first + static_cast<int>(row % y.cells()),
                  cz = z.first + static_cast<int>(row / y.cells());
        for (int cx = x.first; cx < x.last; ++cx)
            for (int kz = 0; kz < z.per_cell; ++kz)
                for (int ky = 0; ky < y.per_cell; ++ky)
                    for (int kx = 0; kx < x.per_cell; ++kx)
                        take(Eigen::Vector3d(x.at(cx, kx), y.at(cy, ky), z.at(cz, kz)));
    }
}

}  // namespace matpoint
