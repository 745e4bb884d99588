#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/grid.hpp>

#include "grid/levels.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace matpoint {

/// The cells of a grid along an axis.
struct CellAxis {
    double min, cell_size;  ///< m
    int cells;
};

/// One for each axis of the space.
template <class S>
std::vector<CellAxis> cell_axes(const Patch<S>& patch) {
    std::vector<CellAxis> axes;
    for (int a = 0; a < S::dimension; ++a)
        axes.push_back({patch.min()[a], patch.cell_size()[a], patch.cells()[static_cast<std::size_t>(a)]});
    return axes;
}

/// Of a level.
template <class S>
std::vector<CellAxis> cell_axes(const Levels<S>& levels, int level) {
    std::vector<CellAxis> axes;
    const auto cells = levels.cells_along(level);
    for (int a = 0; a < S::dimension; ++a)
        axes.push_back({levels.patch(0).min()[a], levels.patch(level).cell_size()[a],
                        cells[static_cast<std::size_t>(a)]});
    return axes;
}

/// A lattice of places for particles, equally many in every cell of the grid, as far as a box reaches. It is
/// handed out in pieces, so that the list of all places never exists.
class CellLattice {
  public:
    /// Counted along each axis of the lattice, 0 along axes that the space lacks.
    using Place = std::array<int, 3>;

    /// Throws std::invalid_argument if there are more places than the particles' numbers can tell apart.
    CellLattice(const std::vector<CellAxis>& cells, const Geometry::Bounds& box,
                const std::array<int, 3>& per_cell);

    int dimension() const { return dimension_; }

    /// A piece is some rows of cells along x. Piece by piece, places are numbered cell by cell.
    Index pieces() const { return (rows() + rows_per_piece_ - 1) / rows_per_piece_; }
    Index begin(Index piece) const { return std::min(rows(), piece * rows_per_piece_) * row_size(); }
    Index piece_of(Index number) const { return number / (rows_per_piece_ * row_size()); }
    /// Places in all.
    Index size() const { return rows() * row_size(); }
    int size(int axis) const { return axes_[static_cast<std::size_t>(axis)].size(); }
    bool has(const Place& place) const {
        for (std::size_t a = 0; a < 3; ++a)
            if (place[a] < 0 || place[a] >= axes_[a].size()) return false;
        return true;
    }

    Index number(const Place& place) const;
    Place place(Index number) const;
    /// The cell of the grid that a place is in.
    Place cell(const Place& place) const {
        Place cell;
        for (std::size_t a = 0; a < 3; ++a) cell[a] = axes_[a].first + place[a] / axes_[a].per_cell;
        return cell;
    }
    /// The middle of a place's part of its cell, m.
    Eigen::Vector3d middle(const Place& place) const {
        return {axes_[0].at(place[0]), axes_[1].at(place[1]), axes_[2].at(place[2])};
    }
    std::vector<Eigen::Vector3d> middles(Index piece) const;
    /// Calls `take` with the middles of a piece, one after the other.
    template <class Take>
    void for_each(Index piece, const Take& take) const;
    /// The first places of a piece's lines along x.
    std::vector<Place> lines(Index piece) const;

    /// Ends of the places' parts along an axis, m: one more than places.
    std::vector<double> planes(int axis) const;
    /// Edges of a place's part of its cell, m, and its length, area or volume, m^D.
    const Eigen::Vector3d& edges() const { return edges_; }
    double area() const { return area_; }

  private:
    /// The lattice's coordinates along an axis; one that is 0 where the space lacks the axis.
    struct Axis {
        double min = 0, cell_size = 0;  ///< of the grid, m
        int first = 0;                  ///< cell
        int per_cell = 1;
        std::vector<double> coordinates{0.0};

        int size() const { return static_cast<int>(coordinates.size()); }
        int cells() const { return size() / per_cell; }
        double at(int place) const { return coordinates[static_cast<std::size_t>(place)]; }
        /// m, `part` of the way through the part of a place.
        double within(int place, double part) const {
            return min + (first + place / per_cell + (place % per_cell + part) / per_cell) * cell_size;
        }
    };

    static Axis make_axis(const CellAxis& cells, double min, double max, int per_cell);
    Index rows() const { return Index{axes_[1].cells()} * axes_[2].cells(); }
    Index row_size() const { return Index{axes_[0].size()} * axes_[1].per_cell * axes_[2].per_cell; }

    int dimension_;
    std::array<Axis, 3> axes_;
    Eigen::Vector3d edges_ = Eigen::Vector3d::Zero();
    double area_ = 1;
    Index rows_per_piece_ = 1;
};

template <class Take>
void CellLattice::for_each(Index piece, const Take& take) const {
    const auto& [x, y, z] = axes_;
    const Index begin = piece * rows_per_piece_, end = std::min(rows(), begin + rows_per_piece_);
    for (Index row = begin; row < end; ++row) {
        const int cy = static_cast<int>(row % y.cells()), cz = static_cast<int>(row / y.cells());
        for (int cx = 0; cx < x.cells(); ++cx)
            for (int kz = 0; kz < z.per_cell; ++kz)
                for (int ky = 0; ky < y.per_cell; ++ky)
                    for (int kx = 0; kx < x.per_cell; ++kx)
                        take(Eigen::Vector3d(x.at(cx * x.per_cell + kx), y.at(cy * y.per_cell + ky),
                                             z.at(cz * z.per_cell + kz)));
    }
}

}  // namespace matpoint
