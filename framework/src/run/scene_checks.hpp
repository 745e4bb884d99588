#pragma once

#include "contact/placed_contact.hpp"
#include "run/findings.hpp"
#include "step/walls.hpp"

#include <matpoint/shape_function.hpp>

#include <memory>
#include <span>
#include <vector>

namespace matpoint {

/// What a scene's checks look at: its parts, made for a space. Bodies and geometries are in the same order.
template <class S>
struct SceneParts {
    const Json& scene;  ///< resolved
    const Patch<S>& patch;
    const ShapeFunction<S>& shape;
    const std::vector<PlacedCondition<S>>& conditions;
    const std::vector<std::shared_ptr<Geometry>>& geometries;
    const std::vector<Particles<S>>& bodies;
};

/// Conditions that hold at no node, that no body is at, or that contradict each other.
template <class S>
Findings check_conditions(const SceneParts<S>& parts);

/// Parts of bodies whose conditions hold no node, or prescribe a component twice.
template <class S>
Findings check_parts(const SceneParts<S>& parts);

/// Bodies that the grid cuts.
template <class S>
Findings check_extents(const SceneParts<S>& parts);

/// Space that two bodies fill.
template <class S>
Findings check_overlaps(const SceneParts<S>& parts);

/// Bodies that are too thin for how a contact measures gaps, or that it can't stop.
template <class S>
Findings check_contacts(const SceneParts<S>& parts, std::span<const PlacedContact<S>> contacts);

/// Motion along the radius that an axisymmetric space can't have.
template <class S>
Findings check_axis(const SceneParts<S>& parts);

/// An exact solution that is compared with nothing: `within` may be null.
template <class S>
Findings check_measured(const SceneParts<S>& parts, const Geometry* within);

}  // namespace matpoint
