#include "verify/load_scene.hpp"

#include "verify/check.hpp"

namespace matpoint {

Scene load_scene(Document document, const std::vector<std::string>& assignments, PluginCatalogue& catalogue) {
    Diagnostics mistakes;
    for (const std::string& assignment : assignments) apply_set(document, assignment, mistakes);
    if (document.json.is_object() && document.json.contains("checks")) {
        validate_checks(document, document.json.at("checks"), "/checks", mistakes);
    }
    for (const auto& file : plugin_files(document)) catalogue.open_file(file);
    try {
        Scene scene = resolve_scene(std::move(document), catalogue);
        if (!mistakes.has_errors()) return scene;
    } catch (const InputError& error) {
        mistakes.add(error.diagnostics());
    }
    throw InputError(mistakes);
}

Scene load_scene(const std::filesystem::path& file, const std::vector<std::string>& assignments,
                 PluginCatalogue& catalogue) {
    return load_scene(read_document(file), assignments, catalogue);
}

}  // namespace matpoint
