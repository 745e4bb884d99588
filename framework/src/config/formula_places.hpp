#pragma once

#include <matpoint/profile.hpp>

#include <string>
#include <vector>

namespace matpoint {

/// JSON pointers to a formula in a scene; its checks are left out.
std::vector<std::string> formula_places(const Json& scene, const std::string& formula);

}  // namespace matpoint
