#pragma once

#include <matpoint/schema.hpp>

#include <string>
#include <vector>

namespace matpoint {

/// A type's name, as `describe` and the reference pages call it: "per_axis".
std::string type_name(ParameterType type);

/// What a user may write, in words: "a number > -1 and < 0.5", "a list of 2 numbers (m)".
/// `dimension` 0: not known.
std::string expected(const Parameter& parameter, int dimension = 0);
/// The same for one number of a parameter that is made of numbers.
std::string expected_number(const ParameterOptions& options, bool whole = false);

/// Those of a profile's variables that a space of this dimension has.
std::string usable_variables(const ParameterOptions& options, int dimension);

/// A value as messages show it: JSON, cut if it is long.
std::string shown(const Json& value);

/// "x_min", "x_max", … of a space; all six if the dimension is 0.
std::vector<std::string> face_names(int dimension);

}  // namespace matpoint
