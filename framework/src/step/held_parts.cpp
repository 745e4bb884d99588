#include "step/held_parts.hpp"

#include <matpoint/parallel.hpp>

namespace matpoint {

namespace {

/// Spreads the mass of a range's particles that are in the part.
template <class S>
void spread(Patch<S>& patch, const Particles<S>& particles, const BlockRange& range, int slot,
            const ShapeFunction<S>& shape) {
    using Vector = typename S::Vector;
    thread_local std::vector<PointSource<S>> sources;
    sources.clear();
    const auto* const in_part = particles.column(slot, 0);
    for (Index p = range.begin; p < range.end; ++p)
        if (in_part[p] > 0)
            sources.push_back({particles.position(p),
                               particles.has(Field::half_size) ? particles.vector(Field::half_size, p)
                                                               : Vector(Vector::Zero()),
                               particles.column(Field::mass)[p] * Vector::Unit(0)});
    guarded(shape, "spread", [&] { shape.spread(patch, sources, NodeField::acceleration); });
}

}  // namespace

template <class S>
HeldParts<S>::HeldParts(const std::vector<PlacedCondition<S>>& conditions) {
    for (std::size_t k = 0; k < conditions.size(); ++k)
        if (const auto& part = conditions[k].part) parts_.push_back({k, part->body, part->slot});
}

template <class S>
void HeldParts<S>::hold(std::span<Patch<S>* const> nodes, const std::vector<char>& inside,
                        const std::vector<Particles<S>>& bodies, const Ordering<S>& ordering,
                        const ShapeFunction<S>& shape, Walls<S>& walls) const {
    walls.let_go();
    for (const Part& part : parts_) {
        Patch<S>& patch = *nodes[part.body];
        patch.clear(NodeField::acceleration);
        const auto& ranges = ordering.ranges(part.body);
        for (const std::vector<Index>& colour : ordering.colours(part.body))
            parallel_for(static_cast<Index>(colour.size()), bodies[part.body].size(), [&](Index k) {
                const BlockRange& range =
                    ranges[static_cast<std::size_t>(colour[static_cast<std::size_t>(k)])];
                Patch<S>& own = *nodes[static_cast<std::size_t>(range.level) * bodies.size() + part.body];
                spread(own, bodies[part.body], range, part.slot, shape);
            });
        const Real* const mass = patch.column(NodeField::mass);
        const Real* const own = patch.column(NodeField::acceleration, 0);
        for (int i = 0; i < static_cast<int>(patch.node_count()); ++i)
            if (own[i] > 0 && own[i] >= static_cast<Real>(least_share) * mass[i] &&
                inside[static_cast<std::size_t>(i)] != 0)
                walls.hold_node(patch, i, part.condition);
    }
}

#define MATPOINT_INSTANTIATE(S) template class HeldParts<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
