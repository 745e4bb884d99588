#include "run/holding.hpp"
#include "run/node_box.hpp"
#include "step/held_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace matpoint {

namespace {

/// Nodes that get enough of their mass from the part to be held.
template <class S>
std::vector<typename Patch<S>::Coordinates> held_nodes(const SceneParts<S>& parts, const BodyPart& part) {
    using Vector = typename S::Vector;
    struct Mass {
        double part = 0, whole = 0;
    };
    std::map<typename Patch<S>::Coordinates, Mass> nodes;
    const auto add = [&](const Particles<S>& particles, Index p, bool in_part) {
        const Vector half =
            particles.has(Field::half_size) ? particles.vector(Field::half_size, p) : Vector(Vector::Zero());
        const auto stencil = parts.shape.stencil(parts.patch, particles.position(p), half);
        const auto mass = static_cast<double>(particles.column(Field::mass)[p]);
        for (std::size_t k = 0; k < stencil.nodes.size(); ++k) {
            if (!parts.patch.inside(stencil.nodes[k])) continue;
            // What the part doesn't reach is not asked about.
            const auto found =
                in_part ? nodes.try_emplace(stencil.nodes[k]).first : nodes.find(stencil.nodes[k]);
            if (found == nodes.end()) continue;
            const double own = mass * static_cast<double>(stencil.weights[k]);
            found->second.whole += own;
            if (in_part) found->second.part += own;
        }
    };
    const auto in_part = [&](const Particles<S>& particles, Index p) {
        return &particles == &parts.bodies[part.body] && particles.column(part.slot, 0)[p] > 0;
    };
    for (const bool own : {true, false})
        for (const Particles<S>& particles : parts.bodies)
            for (Index p = 0; p < particles.size(); ++p)
                if (in_part(particles, p) == own) add(particles, p, own);
    std::vector<typename Patch<S>::Coordinates> held;
    for (const auto& [node, mass] : nodes)
        if (mass.part > 0 && mass.part >= HeldParts<S>::least_share * mass.whole) held.push_back(node);
    return held;
}

template <class S>
bool have_a_common_particle(const Particles<S>& particles, const BodyPart& one, const BodyPart& other) {
    const auto *const in_one = particles.column(one.slot, 0), *const in_other =
                                                                  particles.column(other.slot, 0);
    for (Index p = 0; p < particles.size(); ++p)
        if (in_one[p] > 0 && in_other[p] > 0) return true;
    return false;
}

/// What two conditions of one body prescribe for the same particles.
template <class S>
std::optional<std::string> conflict(const SceneParts<S>& parts, std::size_t one, std::size_t other) {
    const auto &a = parts.conditions[one], &b = parts.conditions[other];
    if (!b.part || a.part->body != b.part->body) return {};
    const auto by_a = a.condition->prescribes(-1), by_b = b.condition->prescribes(-1);
    for (std::size_t c = 0; c < S::dimension; ++c)
        if (by_a[c] && by_b[c] && have_a_common_particle(parts.bodies[a.part->body], *a.part, *b.part))
            return fmt::format(
                "prescribes the {} component of velocity of particles for which /boundary_conditions/{} does",
                "xyz"[c], other);
    return {};
}

/// What a part's condition and one of a face or a region prescribe differently for a node.
template <class S>
std::optional<std::string> conflict(const SceneParts<S>& parts, std::size_t part, const Holding& other,
                                    const std::vector<typename Patch<S>::Coordinates>& held) {
    const Geometry* const region = parts.conditions[other.condition].region.get();
    for (const auto& node : held) {
        const auto axis = static_cast<std::size_t>(std::max(other.axis, 0));
        const bool there = other.axis < 0 ? region->contains(place_of(parts.patch, node))
                                          : node[axis] == (other.side == 0 ? 0 : parts.patch.cells()[axis]);
        if (!there) continue;
        if (auto found = difference(parts, Holding{part}, other, parts.patch.node_position(node)))
            return found;
    }
    return {};
}

}  // namespace

template <class S>
Findings check_parts(const SceneParts<S>& parts) {
    Findings findings;
    for (std::size_t k = 0; k < parts.conditions.size(); ++k) {
        const auto& part = parts.conditions[k].part;
        if (!part) continue;
        const std::string pointer = fmt::format("/boundary_conditions/{}/on", k);
        const auto held = held_nodes(parts, *part);
        if (held.empty())
            findings.push_back({true, pointer,
                                "no node of the grid gets 15 % of its mass from this part, so that it holds "
                                "nothing: let it be a cell thick"});
        for (std::size_t other = 0; other < k; ++other)
            if (const auto found = conflict(parts, k, other)) findings.push_back({true, pointer, *found});
        for (const Holding& other : holdings(parts.conditions))
            if (const auto found = conflict(parts, k, other, held))
                findings.push_back({true, pointer, *found});
    }
    return findings;
}

#define MATPOINT_INSTANTIATE(S) template Findings check_parts<S>(const SceneParts<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
