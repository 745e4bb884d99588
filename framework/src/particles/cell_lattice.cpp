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

template <class S>
CellLattice<S>::CellLattice(const Patch<S>& patch, const Geometry::Bounds& box,
                            const std::array<int, 3>& per_cell) {
    double places = 1;
    for (int a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<std::size_t>(a);
        axes_[i] = make_axis(patch, box, a, per_cell[i]);
        half_size_[a] = static_cast<double>(patch.cell_size()[a]) / (2 * per_cell[i]);
        area_ *= 2 * half_size_[a];
        places *= static_cast<double>(axes_[i].coordinates.size());
    }
    if (places > most_places)
        throw std::invalid_argument(
            fmt::format("its box holds {:.3g} places for particles, more than {:.3g}: take larger cells",
                        places, most_places));
    rows_per_piece_ = std::max<Index>(1, piece_size / std::max<Index>(1, row_size()));
}

template <class S>
typename CellLattice<S>::Axis CellLattice<S>::make_axis(const Patch<S>& patch, const Geometry::Bounds& box,
                                                        int a, int per_cell) {
    Axis axis;
    const double min = static_cast<double>(patch.min()[a]), h = static_cast<double>(patch.cell_size()[a]);
    const double cells = patch.cells()[static_cast<std::size_t>(a)];
    // One cell more on both sides, for the rounding of bounds that lie on a cell's face.
    axis.first = static_cast<int>(std::clamp(std::floor((box.min[a] - min) / h) - 1, 0.0, cells));
    axis.last = static_cast<int>(std::clamp(std::floor((box.max[a] - min) / h) + 2, 0.0, cells));
    axis.last = std::max(axis.first, axis.last);
    axis.per_cell = per_cell;
    axis.coordinates.clear();
    for (int cell = axis.first; cell < axis.last; ++cell)
        for (int k = 0; k < per_cell; ++k)
            axis.coordinates.push_back(min + (cell + (k + 0.5) / per_cell) * h);
    return axis;
}

template <class S>
std::vector<Eigen::Vector3d> CellLattice<S>::piece(Index number) const {
    std::vector<Eigen::Vector3d> places;
    places.reserve(static_cast<std::size_t>(std::min(rows(), rows_per_piece_) * row_size()));
    for_each(number, [&](const Eigen::Vector3d& place) { places.push_back(place); });
    return places;
}

#define MATPOINT_INSTANTIATE(S) template class CellLattice<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
