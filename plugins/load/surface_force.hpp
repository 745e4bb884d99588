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

/// The force N_i(x_p + d) F (N) of a boundary particle on the nodes that have mass, where d reaches from the
/// particle to the face: the stencil of a particle whose shape does not reach the surface may end before it.
/// Of particles that are points, a node with hardly any mass would turn the force into a velocity that does
/// work on nothing; its part goes to the others too.
template <class S>
void add_at_surface(LoadContext<S>& context, const Face<S>& face, const Particles<S>& particles, Index p,
                    const typename S::Vector& force) {
    using Real = typename S::Real;
    const typename S::Position place = face.surface_point(particles, p);
    Patch<S>& patch = context.nodes_at(particles, place);
    typename S::Vector half = present_half_size(particles, p);
    half[face.axis()] = 0;
    const auto stencil = context.shape.stencil(patch, place, half);
    const Real* mass = patch.column(NodeField::mass);
    // A particle's domain reaches to the surface, and its stress is in balance with the force at every node.
    const bool reaches_surface = particles.has(Field::half_size);
    const Real least = reaches_surface ? Real(0) : static_cast<Real>(0.01) * particles.column(Field::mass)[p];
    std::vector<std::pair<int, Real>> nodes;
    Real sum = 0;
    for (std::size_t k = 0; k < stencil.nodes.size(); ++k) {
        const int i = patch.node_index(stencil.nodes[k]);
        if (i < 0 || !(mass[i] > least)) continue;
        nodes.emplace_back(i, stencil.weights[k]);
        sum += stencil.weights[k];
    }
    if (!(sum > static_cast<Real>(1e-3))) {
        const PointSource<S> at_particle{particles.position(p), present_half_size(particles, p), force};
        context.spread(particles, {&at_particle, 1}, NodeField::external_force);
        return;
    }
    for (int a = 0; a < S::dimension; ++a) {
        Real* column = patch.column(NodeField::external_force, a);
        for (const auto& [i, weight] : nodes) column[i] += force[a] * weight / sum;
    }
}

}  // namespace matpoint
