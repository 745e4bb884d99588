#pragma once

#include <matpoint/shape_function.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace matpoint {

/// Half of what a particle's deformed domain measures along an axis, m, l_a^2 = sum_b (F_ab l0_b)^2: of a box
/// with its second moment there. That box is the domain itself where it is only stretched along the axes, and
/// as large as before where it only turns. Reads Field::initial_half_size and Field::displacement_gradient.
template <class S>
double domain_half_size(const Particles<S>& particles, Index p, int axis) {
    double square = 0;
    for (int b = 0; b < S::dimension; ++b) {
        const double f = (axis == b ? 1 : 0) + static_cast<double>(particles.column(
                                                   Field::displacement_gradient, axis + S::dimension * b)[p]);
        const double edge = f * static_cast<double>(particles.column(Field::initial_half_size, b)[p]);
        square += edge * edge;
    }
    return std::sqrt(square);
}

/// A particle's domain as a box along the axes.
template <class S>
struct DomainBox {
    typename S::Position centre, half_size;  ///< in cells, from node 0
    double volume;                           ///< m^D

    /// Thinner or longer domains count as of 1e-3 and 2 cells on either side.
    DomainBox(const Patch<S>& patch, const Particles<S>& particles, Index p)
        : centre((particles.position(p) - patch.min()).cwiseProduct(patch.inverse_cell_size())),
          volume(particles.value(Field::volume, 0, p)) {
        if constexpr (S::axisymmetric) volume /= 2 * std::numbers::pi * particles.position(p)[0];
        for (int a = 0; a < S::dimension; ++a)
            half_size[a] =
                std::clamp(domain_half_size(particles, p, a) * patch.inverse_cell_size()[a], 1e-3, 2.0);
    }
};

/// Visits a domain and, behind the grid's faces within `reach` cells of it that mirror what is before them,
/// its images. `mirrors(axis, side)` says which do.
template <class S, class Mirrors, class Visit>
void visit_images(const Patch<S>& patch, const DomainBox<S>& own, double reach, const Mirrors& mirrors,
                  const Visit& visit) {
    const auto along = [&](const auto& self, int axis, DomainBox<S> box) -> void {
        if (axis == S::dimension) return visit(box);
        self(self, axis + 1, box);
        for (int side = 0; side < 2; ++side) {
            const double beyond = patch.centred() ? 0.5 : 0;
            const double wall = side == 0 ? -beyond : patch.cells()[static_cast<std::size_t>(axis)] + beyond;
            if (std::abs(own.centre[axis] - wall) > reach + own.half_size[axis] || !mirrors(axis, side))
                continue;
            box.centre[axis] = 2 * wall - own.centre[axis];
            self(self, axis + 1, box);
        }
    };
    along(along, 0, own);
}

/// Degree of the Spline that reaches as far as a shape function does: a point reaches one node more along an
/// axis.
template <class S>
int spline_degree(const Patch<S>& patch, const ShapeFunction<S>& shape) {
    const typename S::Position x =
        patch.min() + (patch.cells()[0] / 2 + 0.3) * patch.cell_size().minCoeff() * S::Position::Ones();
    const auto stencil =
        guarded(shape, "stencil", [&] { return shape.stencil(patch, x, S::Vector::Zero()); });
    std::vector<int> along;
    for (std::size_t k = 0; k < stencil.nodes.size(); ++k)
        if (stencil.weights[k] > typename S::Real(1e-6)) along.push_back(stencil.nodes[k][0]);
    std::ranges::sort(along);
    const auto count = std::ranges::distance(along.begin(), std::ranges::unique(along).begin());
    return std::clamp(static_cast<int>(count) - 1, 1, 3);
}

}  // namespace matpoint
