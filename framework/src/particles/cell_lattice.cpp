#include "particles/cell_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace matpoint {

namespace {

/// Places in a piece, about.
constexpr Index piece_size = 65536;

/// What the particles' numbers can tell apart.
constexpr double most_places = std::numeric_limits<std::uint32_t>::max();

}  // namespace

CellLattice::CellLattice(const std::vector<CellAxis>& cells, const Geometry::Bounds& box,
                         const std::array<int, 3>& per_cell)
    : dimension_(static_cast<int>(cells.size())) {
    double places = 1;
    for (std::size_t a = 0; a < cells.size(); ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        axes_[a] = make_axis(cells[a], box.min[i], box.max[i], per_cell[a]);
        edges_[i] = axes_[a].cell_size / per_cell[a];
        area_ *= edges_[i];
        places *= axes_[a].size();
    }
    if (places > most_places)
        throw std::invalid_argument(
            fmt::format("its box holds {:.3g} places for particles, more than {:.3g}: take larger cells",
                        places, most_places));
    rows_per_piece_ = std::max<Index>(1, piece_size / std::max<Index>(1, row_size()));
}

CellLattice::Axis CellLattice::make_axis(const CellAxis& cells, double min, double max, int per_cell) {
    Axis axis;
    axis.min = cells.min;
    axis.cell_size = cells.cell_size;
    // One cell more on both sides, for the rounding of bounds that lie on a cell's face.
    const auto cell = [&](double bound, double more) {
        const double number = std::floor((bound - axis.min) / axis.cell_size) + more;
        return static_cast<int>(std::clamp(number, 0.0, double(cells.cells)));
    };
    axis.first = cell(min, -1);
    axis.per_cell = per_cell;
    const int places = std::max(0, cell(max, 2) - axis.first) * per_cell;
    axis.coordinates.clear();
    for (int place = 0; place < places; ++place) axis.coordinates.push_back(axis.within(place, 0.5));
    return axis;
}

Index CellLattice::number(const Place& place) const {
    const auto& [x, y, z] = axes_;
    const Index row = place[1] / y.per_cell + Index{place[2] / z.per_cell} * y.cells();
    const Index cell = row * x.cells() + place[0] / x.per_cell;
    return ((cell * z.per_cell + place[2] % z.per_cell) * y.per_cell + place[1] % y.per_cell) * x.per_cell +
           place[0] % x.per_cell;
}

CellLattice::Place CellLattice::place(Index number) const {
    Place place;
    const auto divide = [&](Index by) {
        const Index rest = number % by;
        number /= by;
        return static_cast<int>(rest);
    };
    for (std::size_t a = 0; a < 3; ++a) place[a] = divide(axes_[a].per_cell);
    for (std::size_t a = 0; a < 3; ++a) place[a] += axes_[a].per_cell * divide(axes_[a].cells());
    return place;
}

std::vector<Eigen::Vector3d> CellLattice::middles(Index piece) const {
    std::vector<Eigen::Vector3d> middles;
    middles.reserve(static_cast<std::size_t>(begin(piece + 1) - begin(piece)));
    for_each(piece, [&](const Eigen::Vector3d& middle) { middles.push_back(middle); });
    return middles;
}

std::vector<CellLattice::Place> CellLattice::lines(Index piece) const {
    const auto& [x, y, z] = axes_;
    std::vector<Place> lines;
    const Index end = std::min(rows(), (piece + 1) * rows_per_piece_);
    for (Index row = piece * rows_per_piece_; row < end; ++row)
        for (int kz = 0; kz < z.per_cell; ++kz)
            for (int ky = 0; ky < y.per_cell; ++ky)
                lines.push_back({0, static_cast<int>(row % y.cells()) * y.per_cell + ky,
                                 static_cast<int>(row / y.cells()) * z.per_cell + kz});
    return lines;
}

std::vector<double> CellLattice::planes(int axis) const {
    const Axis& along = axes_[static_cast<std::size_t>(axis)];
    std::vector<double> planes;
    for (int place = 0; place < along.size(); ++place) planes.push_back(along.within(place, 0));
    if (!planes.empty()) planes.push_back(along.within(along.size() - 1, 1));
    return planes;
}

}  // namespace matpoint
