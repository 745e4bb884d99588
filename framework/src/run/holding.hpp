#pragma once

#include "run/scene_checks.hpp"

#include <optional>
#include <string>
#include <vector>

namespace matpoint {

/// Where a condition holds: in its region or its part of a body (axis -1), or on one of its faces.
struct Holding {
    std::size_t condition;
    int axis = -1;
    int side = 0;

    bool is_same_face(const Holding& other) const { return axis == other.axis && side == other.side; }
};

/// "/boundary_conditions/3"
std::string pointer_to(std::size_t condition);

/// In regions and on faces.
template <class S>
std::vector<Holding> holdings(const std::vector<PlacedCondition<S>>& conditions);

/// Which component two conditions prescribe differently at a place, at one of some moments of the run.
template <class S>
std::optional<std::string> difference(const SceneParts<S>& parts, const Holding& one, const Holding& other,
                                      const typename S::Position& place);

}  // namespace matpoint
