#pragma once

#include "config/scene.hpp"
#include "registry/catalogue.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

/// Names of the files that the outputs of an earlier run, whose resolved.json is in the folder, wrote there
/// and those of this scene do not write anew; sorted.
std::vector<std::string> left_over(const std::filesystem::path& folder, const Scene& scene,
                                   PluginCatalogue& catalogue);

}  // namespace matpoint
