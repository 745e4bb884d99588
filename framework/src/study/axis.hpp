#pragma once

#include <matpoint/schema.hpp>

#include <string>
#include <vector>

namespace matpoint {

/// One value of the scene that is varied, and the values that it takes.
struct Axis {
    std::string pointer;  ///< JSON pointer into the scene
    std::string label;    ///< the end of the pointer that tells it from the others: "cell_size"
    std::vector<Json> values;
    std::vector<std::string> value_labels;
};

/// {"from", "to", "step"} or {"from", "to", "factor"}.
Schema range_schema();
/// The values of a resolved range: from + i step, or from factor^i, as far as `to`. Rounded to 12 digits, so
/// that ten steps of 0.1 end at 1.
std::vector<Json> range_values(const Json& range);
/// How many there are, before they are made.
double range_count(const Json& range);

/// For each pointer the shortest end of it that none of the others has. The key "type" is named by its
/// object: "shape_function".
std::vector<std::string> pointer_labels(const std::vector<std::string>& pointers);

/// For each value a short text that none of the others has: 0.125, gimp, gimp(domain=uniform).
std::vector<std::string> value_labels(const std::vector<Json>& values);

}  // namespace matpoint
