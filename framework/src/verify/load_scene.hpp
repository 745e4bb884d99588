#pragma once

#include "config/scene.hpp"
#include "registry/catalogue.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

/// A scene from a file, changed by assignments `/json/pointer=VALUE`, with the plugins opened that it
/// names by file. Throws InputError with all mistakes: of the file, the assignments and the `checks`.
Scene load_scene(const std::filesystem::path& file, const std::vector<std::string>& assignments,
                 PluginCatalogue& catalogue);

/// The same for a document that has been read already.
Scene load_scene(Document document, const std::vector<std::string>& assignments, PluginCatalogue& catalogue);

}  // namespace matpoint
