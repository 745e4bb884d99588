#include "config/document.hpp"
#include "run/node_box.hpp"
#include "run/scene_checks.hpp"

#include <matpoint/profile.hpp>

#include <fmt/format.h>

#include <cmath>

namespace matpoint {

namespace {

constexpr const char* at_axis = "there the radius, x, is 0, and nothing moves along it";

/// Whether a particle of the body is in the cells at the axis.
template <class S>
bool is_at_axis(const SceneParts<S>& parts, const Particles<S>& particles) {
    const auto* const radius = particles.column(Field::position, 0);
    return parts.patch.min()[0] == 0 && particles.size() > 0 &&
           *std::min_element(radius, radius + particles.size()) < parts.patch.cell_size()[0];
}

template <class S>
void check_velocity(const SceneParts<S>& parts, const Particles<S>& particles, Findings& findings) {
    const Json& radial = parts.scene.at("bodies").at(particles.body()).at("velocity")[0];
    if (radial == 0 || radial.is_null()) return;
    const std::string pointer = join_pointer("/bodies", particles.body()) + "/velocity/0";
    if (is_at_axis(parts, particles)) {
        const Profile velocity(radial);
        const auto* const height = particles.column(Field::position, 1);
        const bool moves = std::any_of(height, height + particles.size(), [&](typename S::Real y) {
            return std::abs(velocity({0, static_cast<double>(y), 0}, 0)) > 0;
        });
        if (moves)
            findings.push_back({true, pointer,
                                fmt::format("the body reaches the axis of the axisymmetric space; {}: give a "
                                            "formula such as \"3*x\"",
                                            at_axis)});
    } else if (radial.is_number()) {
        findings.push_back(
            {false, pointer,
             fmt::format("x is the radius in an axisymmetric space: with this, rings widen and no "
                         "body travels. If that is meant, say it as a formula: \"{}\"",
                         radial.dump())});
    }
}

/// What conditions prescribe at nodes on the axis.
template <class S>
void check_condition(const SceneParts<S>& parts, std::size_t number, Findings& findings) {
    const PlacedCondition<S>& placed = parts.conditions[number];
    const std::string pointer = fmt::format("/boundary_conditions/{}", number);
    const bool on_face = holds_on(placed, 0, 0);
    if (!on_face && !placed.region) return;
    const auto prescribed = placed.condition->prescribes(on_face ? 0 : -1);
    const double end = parts.scene.at("/time/end"_json_pointer).template get<double>();
    Geometry::Bounds everywhere;
    everywhere.min.setConstant(-HUGE_VAL);
    everywhere.max.setConstant(HUGE_VAL);
    NodeBox<S> axis(parts.patch, on_face ? everywhere : placed.region->bounds());
    axis.keep_face(parts.patch, 0, 0);
    const bool moves = prescribed[0] && axis.any([&](const typename Patch<S>::Coordinates& node) {
        if (!on_face && !placed.region->contains(place_of(parts.patch, node))) return false;
        const auto place = parts.patch.node_position(node);
        return placed.condition->velocity(place, 0)[0] != 0 ||
               placed.condition->velocity(place, end / 3)[0] != 0 ||
               placed.condition->velocity(place, end)[0] != 0;
    });
    if (moves)
        findings.push_back(
            {true, pointer, fmt::format("holds on the axis of the axisymmetric space; {}", at_axis)});
    else if (on_face && (prescribed[1] || !prescribed[0]))
        findings.push_back(
            {false, pointer + "/on",
             "\"x_min\" is the axis of the axisymmetric space, no wall: bodies move along it and not "
             "through it with a \"slip\" condition"});
}

}  // namespace

template <class S>
Findings check_axis(const SceneParts<S>& parts) {
    Findings findings;
    if constexpr (S::axisymmetric) {
        for (const Particles<S>& particles : parts.bodies) check_velocity(parts, particles, findings);
        if (parts.patch.min()[0] == 0)
            for (std::size_t k = 0; k < parts.conditions.size(); ++k) check_condition(parts, k, findings);
    }
    return findings;
}

#define MATPOINT_INSTANTIATE(S) template Findings check_axis<S>(const SceneParts<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
