#pragma once

#include <matpoint/load.hpp>

#include "face.hpp"

#include <utility>
#include <vector>

namespace matpoint {

/// Half-lengths of a particle's domain as the shape function has it; the initial ones if it has none, m.
template <class S>
typename S::Vector present_half_size(const Particles<S>& particles, Index p) {
    return particles.vector(particles.has(Field::half_size) ? Field::half_size : Field::initial_half_size, p);
}

/// The force N_i(x_p + d) F (N) of a boundary particle on the nodes, where d reaches from the particle to the
/// face. A stencil there may reach one node beyond those that have mass: what it gives to that one the kernel
/// passes on to the nodes that it follows; what would be beyond goes to the others.
template <class S>
void add_at_surface(LoadContext<S>& context, const Face<S>& face, const Particles<S>& particles, Index p,
                    const typename S::Vector& force) {
    using Real = typename S::Real;
    Patch<S>& patch = context.patch;
    typename S::Vector half = present_half_size(particles, p);
    half[face.axis()] = 0;
    const auto stencil = context.shape.stencil(patch, face.surface_point(particles, p), half);
    const Real* mass = patch.column(NodeField::mass);
    const auto has_mass = [&](int i) { return i >= 0 && mass[i] > Real(0); };
    std::vector<std::pair<int, Real>> nodes;
    Real sum = 0;
    for (std::size_t k = 0; k < stencil.nodes.size(); ++k) {
        auto inner = stencil.nodes[k];
        inner[static_cast<std::size_t>(face.axis())] -= static_cast<int>(face.sign());
        const int i = patch.node_index(stencil.nodes[k]);
        if (i < 0 || !(has_mass(i) || has_mass(patch.node_index(inner)))) continue;
        nodes.emplace_back(i, stencil.weights[k]);
        sum += stencil.weights[k];
    }
    if (!(sum > static_cast<Real>(1e-3))) {
        const PointSource<S> at_particle{particles.position(p), present_half_size(particles, p), force};
        context.shape.spread(patch, {&at_particle, 1}, NodeField::external_force);
        return;
    }
    for (int a = 0; a < S::dimension; ++a) {
        Real* column = patch.column(NodeField::external_force, a);
        for (const auto& [i, weight] : nodes) column[i] += force[a] * weight / sum;
    }
}

}  // namespace matpoint
