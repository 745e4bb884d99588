#pragma once

#include "config/scene.hpp"

#include <matpoint/registry.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace matpoint {

/// Fronts of the shipped studies, one file a study, beside the installation's plugins.
std::filesystem::path fronts_folder();

/// What the nearest shipped study would take for the scene's `accuracy.target`; empty if the scene asks
/// for nothing. Nearest: of the same space, and as like as possible in solution, bodies and material. Cells
/// are those across the scene's own bodies, whose geometries the registry makes.
std::optional<std::string> recommendation(const Scene& scene, const Registry& registry,
                                          const std::filesystem::path& fronts);

}  // namespace matpoint
