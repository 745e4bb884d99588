#include "run/left_over.hpp"

#include "config/output_files.hpp"

#include <algorithm>

namespace matpoint {
namespace {

namespace fs = std::filesystem;

std::vector<OutputFileNames> files_of(const Json& scene, Catalogue& catalogue) {
    std::vector<OutputFileNames> all;
    for (const Json& own : scene.at("outputs"))
        if (const Schema* schema = catalogue.find("output", own.at("type").get<std::string>()))
            for (OutputFileNames& files : output_files(own, scene, *schema)) all.push_back(std::move(files));
    return all;
}

}  // namespace

std::vector<std::string> left_over(const fs::path& folder, const Scene& scene, PluginCatalogue& catalogue) {
    std::vector<std::string> found;
    if (!fs::exists(folder / "resolved.json")) return found;
    try {
        PluginCatalogue of_old;  // the run tells which plugins its own has opened
        const Document earlier = read_document(folder / "resolved.json");
        for (const auto& file : plugin_files(earlier)) of_old.open_file(file);
        const auto old = files_of(earlier.json, of_old), present = files_of(scene.resolved, catalogue);
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            const auto holds = [&](const OutputFileNames& files) { return files.holds(name); };
            if (std::ranges::any_of(old, holds) && std::ranges::none_of(present, holds))
                found.push_back(name);
        }
    } catch (const std::exception&) {
        // Not a scene that this Matpoint can read: nothing is known of its files.
        return {};
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace matpoint
