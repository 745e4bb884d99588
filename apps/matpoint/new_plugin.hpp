#pragma once

#include <string>
#include <vector>

namespace matpoint {

/// `matpoint new_plugin KIND NAME [--output DIR]`: writes a project that builds a plugin out of
/// tree. `arguments` are those after the verb. Returns the exit status.
int new_plugin(const std::vector<std::string>& arguments);

}  // namespace matpoint
