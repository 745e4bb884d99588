// Affine velocities across the borders of levels.
#include <matpoint/parallel.hpp>

#include "step/phase_timer.hpp"

namespace matpoint {

namespace {

/// Spreads m A along an axis, of a range's particles.
template <class S>
void spread_affine(Patch<S>& patch, const Particles<S>& particles, const BlockRange& range, int affine_slot,
                   int axis, const ShapeFunction<S>& shape) {
    using Vector = typename S::Vector;
    thread_local std::vector<PointSource<S>> sources;
    sources.clear();
    for (Index p = range.begin; p < range.end; ++p) {
        Vector along;
        for (int c = 0; c < S::dimension; ++c)
            along[c] = particles.column(affine_slot, c + S::dimension * axis)[p];
        sources.push_back(
            {particles.position(p),
             particles.has(Field::half_size) ? particles.vector(Field::half_size, p) : Vector(Vector::Zero()),
             particles.column(Field::mass)[p] * along});
    }
    guarded(shape, "spread", [&] { shape.spread(patch, sources, NodeField::affine_momentum); });
}

}  // namespace

/// Particles extend their velocities to the nodes that they write to. What nodes at a border of levels give
/// to their parents has to be extended to those.
template <class S>
void Engine<S>::extend_to_parents(NodeField momentum) {
    for (int axis = 0; axis < S::dimension; ++axis) {
        patch_.clear(NodeField::affine_momentum);
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const int slot = bodies_[b].slot(*components_.transfer->affine());
            const auto& ranges = ordering_.ranges(b);
            for (const std::vector<Index>& colour : ordering_.colours(b))
                parallel_for(static_cast<Index>(colour.size()),
                             bodies_[b].size() / static_cast<Index>(ordering_.colours(b).size()),
                             [&](Index k) {
                                 const BlockRange& range =
                                     ranges[static_cast<std::size_t>(colour[static_cast<std::size_t>(k)])];
                                 if (range.level > 0 && borders_.borders(range.level, range.block))
                                     spread_affine(nodes(b, range.level), bodies_[b], range, slot, axis,
                                                   *components_.shape);
                             });
        }
        for (int level = 1; level < levels_.count(); ++level) borders_.extend(patch_, momentum, level, axis);
    }
}

#define MATPOINT_INSTANTIATE(S) template void Engine<S>::extend_to_parents(NodeField);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
