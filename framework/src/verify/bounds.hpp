#pragma once

#include "verify/check.hpp"

#include <string>

namespace matpoint {

/// Adds `below`, `above` and `equals` with its tolerances; at least one of them must be given.
void describe_bounds(Schema& schema);
/// Whether a resolved check's bounds hold for a value; what is not a number is within none.
CheckResult within_bounds(const Json& check, const std::string& subject, double value);

}  // namespace matpoint
