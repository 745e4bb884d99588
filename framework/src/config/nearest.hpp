#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace matpoint {

/// The candidate that `name` was probably meant to be: the one at the smallest Damerau-Levenshtein
/// distance, if that is at most max(2, length / 3); the first of equals.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& candidates);

/// The end of a message about a name that isn't there: `; did you mean "disk"?`, or when nothing is
/// near `; expected one of a, b, c` (of at most 20), or nothing.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace matpoint
