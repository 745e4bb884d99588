#pragma once

#include <matpoint/space.hpp>

#include <string>
#include <vector>

namespace matpoint {

/// What the components of a field are, which their number alone does not tell: in 1D a velocity, a
/// stress and a density have one component each.
enum class FieldShape {
    scalar,
    vector,     ///< x y z, as many as the space has
    symmetric,  ///< stored as Space::stress_size says: xx | xx yy zz xy | xx yy zz xy yz xz
    matrix,     ///< in-plane components by column, then the hoop (zz) where there is one
    list,       ///< numbers without directions
};

/// Shape of a field by its name; fields that the kernel does not know are scalars, vectors (as many
/// components as dimensions, beyond 1D) or lists.
FieldShape field_shape(const std::string& field, int components, SpaceId space);

/// "x", "xx", "yx", … in the order in which the components are stored; one empty name for a scalar.
std::vector<std::string> component_names(FieldShape shape, int components, SpaceId space);

/// Names of a field's columns in tables: "density", "velocity_x", "stress_xx", …
std::vector<std::string> column_names(const std::string& field, int components, SpaceId space);

}  // namespace matpoint
