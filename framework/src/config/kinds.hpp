#pragma once

#include <matpoint/schema.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace matpoint {

/// A kind of component, and the parameters that all components of the kind share.
struct Kind {
    std::string name;     ///< "boundary_condition"
    std::string section;  ///< the scene's key, "boundary_conditions"; "" if only parts of the scene use it
    std::string doc;
    Schema common;
    bool decides_accuracy = false;  ///< whether its components are chosen for accuracy against cost
};

/// All kinds, in the order of SCENE.md.
const std::vector<Kind>& kinds();
/// What ParameterType::place takes as a part of a body.
const Schema& part_schema();
/// nullptr if there is no such kind.
const Kind* find_kind(std::string_view name);

/// The kind's common parameters, then the type's own; an own one replaces a common one of its name.
std::vector<const Parameter*> parameters_of(const Kind& kind, const Schema& type);

/// Adds the rule that `every` and `every_steps` exclude each other.
Schema& refuse_two_intervals(Schema& schema);

}  // namespace matpoint
