#pragma once

#include <matpoint/shape_function.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace matpoint {

/// A particle's domain as a box along the axes.
template <class S>
struct DomainBox {
    typename S::Position centre, half_size;  ///< in cells, from node 0
    double volume;                           ///< m^D
};

/// The one with the second moments of the deformed domain along each axis, l_a^2 = sum_b (F_ab l0_b)^2:
/// itself where it is only stretched along the axes, and as large as before where it only turns. It reads
/// Field::initial_half_size and Field::displacement_gradient.
template <class S>
DomainBox<S> domain_box(const Patch<S>& patch, const Particles<S>& particles, Index p) {
    constexpr double least = 1e-3;  // cells; thinner domains count as so thick
    const auto f = ParticleBatch<S>::load_deformation_gradient(particles, p);
    const auto l = particles.vector(Field::initial_half_size, p);
    DomainBox<S> box{(particles.position(p) - patch.min()).cwiseProduct(patch.inverse_cell_size()),
                     S::Position::Zero(), particles.value(Field::volume, 0, p)};
    if constexpr (S::axisymmetric) box.volume /= 2 * std::numbers::pi * particles.position(p)[0];
    for (int a = 0; a < S::dimension; ++a) {
        double square = 0;
        for (int b = 0; b < S::dimension; ++b) {
            const double edge = static_cast<double>(f.plane(a, b)) * static_cast<double>(l[b]);
            square += edge * edge;
        }
        box.half_size[a] = std::max(std::sqrt(square) * patch.inverse_cell_size()[a], least);
    }
    return box;
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
