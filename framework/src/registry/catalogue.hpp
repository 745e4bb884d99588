#pragma once

#include "config/catalogue.hpp"
#include "registry/plugin_index.hpp"
#include "registry/plugin_library.hpp"

#include <matpoint/registry.hpp>

namespace matpoint {

/// The components of all plugins that can be found; a plugin is opened when one of its types is
/// asked for, and not before. Errors are PluginErrors.
class PluginCatalogue final : public Catalogue {
  public:
    explicit PluginCatalogue(PluginIndex index = PluginIndex(plugin_folders())) : index_(std::move(index)) {}

    /// Opens the plugin that has the type, if none of the opened ones has it; null if there is none.
    const Schema* find(const std::string& kind, const std::string& type) override;
    /// Opens nothing.
    std::vector<std::string> types(const std::string& kind) const override;
    std::string origin(const std::string& kind, const std::string& type) const override;

    /// A plugin that a scene names by its file.
    void open_file(const std::filesystem::path& file);
    void open_all();

    Registry& registry() { return registry_; }
    const Registry& registry() const { return registry_; }
    const PluginIndex& index() const { return index_; }
    /// The plugins that have been opened, in order.
    const std::vector<PluginLibrary>& opened() const { return opened_; }

  private:
    void open(const PluginRecord& record);

    PluginIndex index_;
    Registry registry_;
    std::vector<PluginLibrary> opened_;
};

}  // namespace matpoint
