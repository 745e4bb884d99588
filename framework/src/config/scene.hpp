#pragma once

#include "config/catalogue.hpp"
#include "config/document.hpp"

#include <matpoint/schema.hpp>
#include <matpoint/space.hpp>

#include <filesystem>
#include <vector>

namespace matpoint {

/// A scene without mistakes.
struct Scene {
    Json resolved;      ///< every default filled in, SI units; resolves again to itself
    Document document;  ///< what the user wrote
    SpaceId space;
    std::vector<Diagnostic> warnings;
    std::vector<std::string> start_only;  ///< JSON pointers of what only the start of a run reads
    std::filesystem::path folder;         ///< absolute; files are relative to it
};

/// The whole scene file, version 1.
const Schema& scene_schema();

/// Throws InputError with all mistakes. Plugins that the scene names by file must have been opened.
Scene resolve_scene(Document document, Catalogue& catalogue);

/// The absolute paths in the scene's `plugins`; what is wrong there is left to resolve_scene.
std::vector<std::filesystem::path> plugin_files(const Document& document);

}  // namespace matpoint
