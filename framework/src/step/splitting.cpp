#include "step/splitting.hpp"

#include "grid/level_fields.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace matpoint {

namespace {

template <class S>
using Edges = Eigen::Matrix<double, S::dimension, S::dimension>;

/// What leads from a particle to the middles of the halves of its domain, along each of its edges, m.
template <class S>
Edges<S> quarter_edges(const Particles<S>& particles, Index p, Field half_size) {
    Edges<S> edges = Edges<S>::Zero();
    if (particles.has(half_size)) {
        edges.diagonal() = particles.vector(half_size, p).template cast<double>() / 2;
        return edges;
    }
    double volume = particles.value(Field::volume, 0, p);
    if constexpr (S::axisymmetric) volume /= 2 * std::numbers::pi * particles.position(p)[0];
    edges.diagonal().setConstant(std::pow(volume, 1.0 / S::dimension) / 4);
    return edges;
}

template <class S>
Edges<S> deformed_quarter_edges(const Particles<S>& particles, Index p) {
    if (!particles.has(Field::initial_half_size) || !particles.has(Field::displacement_gradient))
        return quarter_edges(particles, p, Field::half_size);
    const Edges<S> f =
        ParticleBatch<S>::load_deformation_gradient(particles, p).plane.template cast<double>();
    return f * quarter_edges(particles, p, Field::initial_half_size);
}

/// Children stay on the grid.
template <class S>
void keep_within(const Patch<S>& patch, const typename S::Position& x, Edges<S>& edges) {
    constexpr double most = 0.9;  // of the way to a face
    for (int a = 0; a < S::dimension; ++a) {
        const double end = patch.node_position(patch.cells())[a];
        const double room = most * std::min(x[a] - patch.min()[a], end - x[a]);
        const double reach = edges.row(a).cwiseAbs().sum();
        if (reach > room) edges.row(a) *= std::max(0.0, room) / reach;
    }
}

template <class S>
void copy(Particles<S>& particles, Index from, Index to) {
    for (int slot = 0; slot < particles.field_count(); ++slot)
        for (int c = 0; c < particles.components(slot); ++c)
            particles.column(slot, c)[to] = particles.column(slot, c)[from];
}

template <class S>
void halve(Particles<S>& particles, Index p) {
    for (const Field field : {Field::half_size, Field::initial_half_size})
        if (particles.has(field))
            for (int a = 0; a < S::dimension; ++a) particles.column(field, a)[p] /= 2;
    particles.column(particles.slot(refinement_field), 0)[p] += 1;
}

template <class S>
void split(const Patch<S>& patch, Particles<S>& particles, const std::vector<Index>& parents) {
    using Real = typename S::Real;
    constexpr int children = 1 << S::dimension;
    const Index old = particles.size();
    std::uint32_t next_id = 0;
    if (particles.has(Field::id))
        for (const std::uint32_t id : particles.ids()) next_id = std::max(next_id, id + 1);
    particles.resize(old + static_cast<Index>(parents.size()) * (children - 1));
    Index last = old;
    for (const Index parent : parents) {
        Edges<S> edges = deformed_quarter_edges(particles, parent);
        const Edges<S> initial = quarter_edges(particles, parent, Field::initial_half_size);
        const typename S::Position x = particles.position(parent);
        keep_within(patch, x, edges);
        halve(particles, parent);
        for (int k = 1; k < children; ++k) copy(particles, parent, last + k - 1);
        for (int k = children - 1; k >= 0; --k) {
            const Index p = k == 0 ? parent : last + k - 1;
            typename S::Position side;
            for (int a = 0; a < S::dimension; ++a) side[a] = (k >> a & 1) != 0 ? 1 : -1;
            const typename S::Position own = x + edges * side;
            double part = 1.0 / children;
            if constexpr (S::axisymmetric) part *= own[0] / x[0];  // of a ring
            particles.set_value(Field::volume, 0, p, part * particles.value(Field::volume, 0, parent));
            particles.column(Field::mass)[p] =
                static_cast<Real>(part * static_cast<double>(particles.column(Field::mass)[parent]));
            for (int a = 0; a < S::dimension; ++a) particles.set_value(Field::position, a, p, own[a]);
            if (particles.has(Field::initial_position)) {
                const typename S::Position start =
                    particles.position(parent, Field::initial_position) + initial * side;
                for (int a = 0; a < S::dimension; ++a)
                    particles.set_value(Field::initial_position, a, p, start[a]);
            }
            if (k > 0 && particles.has(Field::id)) particles.ids()[static_cast<std::size_t>(p)] = next_id++;
        }
        last += children - 1;
    }
}

}  // namespace

template <class S>
void split_arrived(const Levels<S>& levels, Particles<S>& particles) {
    for (;;) {
        std::vector<Index> arrived;
        const auto* const splits = particles.column(particles.slot(refinement_field), 0);
        for (Index p = 0; p < particles.size(); ++p)
            if (particles.divisible(p) && static_cast<double>(splits[p]) < levels.at(particles.position(p)))
                arrived.push_back(p);
        if (arrived.empty()) break;
        split(levels.patch(0), particles, arrived);
    }
    auto* const level = particles.column(particles.slot(level_field), 0);
    for (Index p = 0; p < particles.size(); ++p)
        level[p] = static_cast<typename S::Real>(levels.at(particles.position(p)));
}

#define MATPOINT_INSTANTIATE(S) template void split_arrived(const Levels<S>&, Particles<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
