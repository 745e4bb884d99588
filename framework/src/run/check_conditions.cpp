#include "run/holding.hpp"
#include "run/node_box.hpp"
#include "run/scene_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

namespace matpoint {

namespace {

/// Looks for what two conditions prescribe: on the same face, or, with different velocities, at a node of a
/// region and another place.
template <class S>
class Conflict {
  public:
    explicit Conflict(const SceneParts<S>& parts) : parts_(parts) {}

    std::optional<std::string> on_face(const Holding& one, const Holding& other) const {
        for (const std::size_t k : {one.condition, other.condition})
            if (friction_of(parts_.conditions[k]))
                return fmt::format(
                    "\"{}\" has a condition already, {}: beside one that does not pull there is "
                    "room for no other",
                    face_name(one.axis, one.side), pointer_to(other.condition));
        const auto prescribed = parts_.conditions[one.condition].condition->prescribes(one.axis),
                   there = parts_.conditions[other.condition].condition->prescribes(other.axis);
        for (std::size_t c = 0; c < S::dimension; ++c)
            if (prescribed[c] && there[c])
                return fmt::format("prescribes the {} component of velocity on \"{}\", and so does {}",
                                   "xyz"[c], face_name(one.axis, one.side), pointer_to(other.condition));
        return {};
    }

    std::optional<std::string> between(const Holding& region, const Holding& other) const {
        const Geometry& within = *parts_.conditions[region.condition].region;
        const Geometry* const also_within = parts_.conditions[other.condition].region.get();
        NodeBox<S> nodes(parts_.patch,
                         also_within ? common(within.bounds(), also_within->bounds()) : within.bounds());
        if (other.axis >= 0) nodes.keep_face(parts_.patch, other.axis, other.side);
        std::optional<std::string> found;
        nodes.any([&](const typename Patch<S>::Coordinates& node) {
            const Eigen::Vector3d place = place_of(parts_.patch, node);
            if (!within.contains(place) || (also_within && !also_within->contains(place))) return false;
            found = difference(parts_, region, other, parts_.patch.node_position(node));
            return found.has_value();
        });
        return found;
    }

  private:
    static Geometry::Bounds common(const Geometry::Bounds& a, const Geometry::Bounds& b) {
        return {a.min.cwiseMax(b.min), a.max.cwiseMin(b.max)};
    }

    const SceneParts<S>& parts_;
};

template <class S>
bool holds_a_node(const Patch<S>& patch, const Geometry& region) {
    const NodeBox<S> nodes(patch, region.bounds());
    return nodes.thinned() || nodes.any([&](const typename Patch<S>::Coordinates& node) {
        return region.contains(place_of(patch, node));
    });
}

/// Whether a particle gives mass to a node in the region.
template <class S>
bool reached(const SceneParts<S>& parts, const Geometry& region) {
    using Vector = typename S::Vector;
    const Eigen::Vector3d reach =
        parts.shape.width() * parts.patch.cell_size().maxCoeff() * Eigen::Vector3d::Ones();
    const Eigen::Vector3d low = region.bounds().min - reach, high = region.bounds().max + reach;
    const auto touches = [&](const Particles<S>& particles, Index p) {
        const typename S::Position x = particles.position(p);
        for (int a = 0; a < S::dimension; ++a)
            if (!(x[a] >= low[a] && x[a] <= high[a])) return false;
        const Vector half =
            particles.has(Field::half_size) ? particles.vector(Field::half_size, p) : Vector(Vector::Zero());
        const auto stencil = parts.shape.stencil(parts.patch, x, half);
        for (std::size_t k = 0; k < stencil.nodes.size(); ++k)
            if (stencil.weights[k] > 0 && parts.patch.inside(stencil.nodes[k]) &&
                region.contains(place_of(parts.patch, stencil.nodes[k])))
                return true;
        return false;
    };
    for (const Particles<S>& particles : parts.bodies)
        for (Index p = 0; p < particles.size(); ++p)
            if (touches(particles, p)) return true;
    return false;
}

}  // namespace

template <class S>
Findings check_conditions(const SceneParts<S>& parts) {
    Findings findings;
    for (std::size_t k = 0; k < parts.conditions.size(); ++k) {
        const Geometry* const region = parts.conditions[k].region.get();
        if (!region) continue;
        if (!holds_a_node(parts.patch, *region)) {
            const auto h = parts.patch.cell_size();
            findings.push_back({true, pointer_to(k) + "/on",
                                fmt::format("there is no node of the grid in this region, so that it holds "
                                            "nothing: let it reach over nodes, which are {:.6g} m apart",
                                            fmt::join(h.data(), h.data() + S::dimension, " and "))});
        } else if (!parts.scene.at("boundary_conditions")[k].at("waits").template get<bool>() &&
                   !reached(parts, *region)) {
            findings.push_back({false, pointer_to(k) + "/on",
                                "no body is there at the start: the condition holds nothing until one "
                                "arrives. If that is meant, say \"waits\": true"});
        }
    }
    const Conflict<S> conflict(parts);
    const std::vector<Holding> all = holdings(parts.conditions);
    for (const Holding& one : all)
        for (const Holding& other : all) {
            const bool in_order = other.condition < one.condition;
            if (one.axis < 0 ? other.axis >= 0 || in_order : in_order && one.is_same_face(other))
                if (const auto found =
                        one.axis < 0 ? conflict.between(one, other) : conflict.on_face(one, other))
                    findings.push_back({true, pointer_to(one.condition) + "/on", *found});
        }
    return findings;
}

template <class S>
Findings check_measured(const SceneParts<S>& parts, const Geometry* within) {
    if (!within) return {};
    const Json& own = parts.scene.at("exact_solution");
    const auto covered = [&](const Particles<S>& particles) {
        const Json& bodies = own.at("body");
        return std::find(bodies.begin(), bodies.end(), particles.body()) != bodies.end();
    };
    const auto measures = [&](const Particles<S>& particles) {
        if (!covered(particles)) return false;
        for (Index p = 0; p < particles.size(); ++p) {
            Eigen::Vector3d x = Eigen::Vector3d::Zero();
            x.head<S::dimension>() = particles.position(p);
            if (within->contains(x)) return true;
        }
        return false;
    };
    const bool nodes = own.at("quantity") == "nodal_velocity";
    if (nodes ? holds_a_node(parts.patch, *within)
              : std::any_of(parts.bodies.begin(), parts.bodies.end(), measures))
        return {};
    return {{true, "/exact_solution/within",
             fmt::format("there is no {} in this region: nothing would be measured",
                         nodes ? "node of the grid" : "particle of the solution's bodies")}};
}

#define MATPOINT_INSTANTIATE(S)                                  \
    template Findings check_conditions<S>(const SceneParts<S>&); \
    template Findings check_measured<S>(const SceneParts<S>&, const Geometry*);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
