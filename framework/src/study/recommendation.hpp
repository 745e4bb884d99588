#pragma once

#include "config/scene.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace matpoint {

/// Fronts of the shipped studies, one file a study, beside the installation's plugins.
std::filesystem::path fronts_folder();

/// What the nearest shipped study would take for the scene's `accuracy.target`; empty if the scene asks
/// for nothing. Nearest: of the same space, and as like as possible in solution, bodies and material.
std::optional<std::string> recommendation(const Scene& scene, const std::filesystem::path& fronts);

}  // namespace matpoint
