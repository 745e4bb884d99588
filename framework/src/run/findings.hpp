#pragma once

#include <string>
#include <vector>

namespace matpoint {

/// What a scene asks for that can't be, or that does nothing: it shows when components and particles are
/// made.
struct Finding {
    bool error;           ///< false: a warning, for what can be meant
    std::string pointer;  ///< JSON pointer into the scene
    std::string text;
};
using Findings = std::vector<Finding>;

}  // namespace matpoint
