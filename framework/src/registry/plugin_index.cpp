#include "registry/plugin_index.hpp"

#define BOOST_DLL_USE_STD_FS
#include <fmt/format.h>

#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <cstdlib>
#include <matpoint/input_file.hpp>
#include <matpoint/plugin.hpp>
#include <sstream>

#include "registry/plugin_library.hpp"

namespace matpoint {

namespace fs = std::filesystem;

namespace {

constexpr const char* index_suffix = ".plugin.json";
constexpr std::uintmax_t largest_index = std::uintmax_t{16} << 20;  // bytes

/// The library may be missing: that is told when one of its types is asked for.
PluginRecord read_index_file(const fs::path& file, const fs::path& library) {
    try {
        const Json json = Json::parse(read_whole(file, largest_index));
        PluginRecord record{library, json.at("plugin"), json.at("version"), json.at("abi"), {}};
        for (const Json& component : json.at("components"))
            record.components.push_back({component.at("kind"), component.at("type"), component.at("doc")});
        return record;
    } catch (const std::exception& error) {
        throw PluginError(
            fmt::format("the plugin index {} can't be read: rebuild the plugin, which writes it anew ({})",
                        file.string(), error.what()));
    }
}

/// The folder of the installation's kernel; that for a higher instruction set lies below it, in
/// glibc-hwcaps/<instruction set>.
fs::path library_folder() {
    const fs::path folder = fs::absolute(fs::path(boost::dll::this_line_location())).parent_path();
    const fs::path above = folder.parent_path();
    return above.filename() == "glibc-hwcaps" ? above.parent_path() : folder;
}

}  // namespace

bool PluginRecord::offers(const std::string& kind, const std::string& type) const {
    return std::any_of(components.begin(), components.end(),
                       [&](const Component& c) { return c.kind == kind && c.type == type; });
}

fs::path index_file_of(const fs::path& library) {
    return fs::path(library).replace_extension(index_suffix);
}

Json index_of(const PluginLibrary& library) {
    Json components = Json::array();
    const Registry registry = library.components();
    for (const auto& [key, entry] : registry.entries())
        components.push_back({{"kind", entry.kind}, {"type", entry.type}, {"doc", entry.schema.doc()}});
    return {{"plugin", library.name()},
            {"version", library.version()},
            {"abi", MATPOINT_ABI_VERSION},
            {"components", std::move(components)}};
}

PluginIndex::PluginIndex(const std::vector<fs::path>& folders) {
    std::vector<fs::path> seen;
    for (const fs::path& folder : folders) {
        const fs::path canonical = fs::weakly_canonical(folder);
        if (std::find(seen.begin(), seen.end(), canonical) != seen.end()) continue;
        seen.push_back(canonical);
        if (fs::is_directory(canonical)) add_folder(canonical);
    }
}

void PluginIndex::add_folder(const fs::path& folder) {
    std::vector<fs::path> libraries;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(index_suffix))
            libraries.push_back(
                folder / (name.substr(0, name.size() - std::string_view(index_suffix).size()) + ".so"));
        else if (name.ends_with(".so") && !fs::exists(index_file_of(entry.path())))
            throw PluginError(
                fmt::format("{} has no index file {} beside it: build the plugin with the CMake function "
                            "matpoint_add_plugin, which writes one, or move the library out of the folder",
                            entry.path().string(), index_file_of(entry.path()).filename().string()));
    }
    std::sort(libraries.begin(), libraries.end());
    for (const fs::path& library : libraries)
        plugins_.push_back(read_index_file(index_file_of(library), library));
}

std::vector<fs::path> plugin_folders() {
    std::vector<fs::path> folders;
    if (const char* variable = std::getenv("MATPOINT_PLUGIN_PATH")) {
        std::istringstream list(variable);
        for (std::string folder; std::getline(list, folder, ':');) {
            if (folder.empty()) continue;
            if (!fs::is_directory(folder))
                throw PluginError(
                    fmt::format("MATPOINT_PLUGIN_PATH names the folder {}, which does not exist: correct the "
                                "variable or unset it",
                                folder));
            folders.emplace_back(folder);
        }
    }
    folders.push_back(library_folder() / MATPOINT_PLUGIN_DIR_FROM_LIB);
    return folders;
}

}  // namespace matpoint
