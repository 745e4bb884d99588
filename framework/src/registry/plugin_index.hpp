#pragma once

#include <matpoint/schema.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

class PluginLibrary;

/// What a plugin offers, as its index file `<name>.plugin.json` beside the library says.
struct PluginRecord {
    struct Component {
        std::string kind, type, doc;
    };
    std::filesystem::path library;
    std::string plugin, version;
    int abi = 0;
    std::vector<Component> components;

    bool offers(const std::string& kind, const std::string& type) const;
};

/// The index file of a plugin: written at build time, so that a scene's types find their plugins
/// without opening the others.
std::filesystem::path index_file_of(const std::filesystem::path& library);
Json index_of(const PluginLibrary& library);

/// The plugins in some folders, known from their index files alone. Throws PluginError if a library
/// has no index file, or one that can't be read.
class PluginIndex {
  public:
    explicit PluginIndex(const std::vector<std::filesystem::path>& folders);

    const std::vector<PluginRecord>& plugins() const { return plugins_; }

  private:
    void add_folder(const std::filesystem::path& folder);

    std::vector<PluginRecord> plugins_;
};

/// Where plugins are looked for: the folders in the environment variable MATPOINT_PLUGIN_PATH
/// (separated by colons), then the installation's own. Throws PluginError if the variable names a
/// folder that does not exist.
std::vector<std::filesystem::path> plugin_folders();

}  // namespace matpoint
