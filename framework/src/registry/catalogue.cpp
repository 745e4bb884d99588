#include "registry/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <matpoint/plugin.hpp>
#include <set>

namespace matpoint {

namespace fs = std::filesystem;

const Schema* PluginCatalogue::find(const std::string& kind, const std::string& type) {
    if (const Registry::Entry* entry = registry_.find(kind, type)) return &entry->schema;
    const PluginRecord* found = nullptr;
    for (const PluginRecord& record : index_.plugins()) {
        if (!record.offers(kind, type)) continue;
        if (found)
            throw PluginError(
                fmt::format("{} \"{}\" is offered by two plugins: \"{}\" {} ({}) and \"{}\" {} ({}); "
                            "remove one, or name its file in the scene's \"plugins\"",
                            kind, type, found->plugin, found->version, found->library.string(), record.plugin,
                            record.version, record.library.string()));
        found = &record;
    }
    if (!found) return nullptr;
    open(*found);
    if (const Registry::Entry* entry = registry_.find(kind, type)) return &entry->schema;
    throw PluginError(
        fmt::format("plugin {} does not have the {} \"{}\" that its index file promises: rebuild it",
                    found->library.string(), kind, type));
}

std::vector<std::string> PluginCatalogue::types(const std::string& kind) const {
    std::set<std::string> types;
    for (const auto& [key, entry] : registry_.entries())
        if (entry.kind == kind) types.insert(entry.type);
    for (const PluginRecord& record : index_.plugins())
        for (const PluginRecord::Component& component : record.components)
            if (component.kind == kind) types.insert(component.type);
    return {types.begin(), types.end()};
}

std::string PluginCatalogue::origin(const std::string& kind, const std::string& type) const {
    const Registry::Entry& entry = *registry_.find(kind, type);
    return to_string(Origin{kind, type, entry.plugin, entry.version, ""});
}

void PluginCatalogue::open_file(const fs::path& file) {
    const fs::path canonical = fs::weakly_canonical(file);
    for (const PluginLibrary& library : opened_)
        if (library.file() == canonical) return;

    const PluginLibrary library(canonical);
    const Registry components = library.components();
    for (const auto& [key, entry] : components.entries()) {
        const Registry::Entry* first = registry_.find(entry.kind, entry.type);
        if (!first) continue;
        const auto owner = std::find_if(opened_.begin(), opened_.end(),
                                        [&](const PluginLibrary& l) { return l.name() == first->plugin; });
        throw PluginError(
            fmt::format("{} \"{}\" is registered twice: by plugin \"{}\" {} ({}) and by plugin \"{}\" {} "
                        "({}); remove one of them",
                        entry.kind, entry.type, first->plugin, first->version,
                        owner == opened_.end() ? "the kernel" : owner->file().string(), entry.plugin,
                        entry.version, canonical.string()));
    }
    for (const auto& [key, entry] : components.entries()) registry_.add(entry);
    opened_.push_back(library);
}

void PluginCatalogue::open_all() {
    for (const PluginRecord& record : index_.plugins()) open(record);
}

void PluginCatalogue::open(const PluginRecord& record) {
    // Told here because the dynamic linker would find symbols missing before the stamp can be read.
    if (record.abi != MATPOINT_ABI_VERSION)
        throw PluginError(
            fmt::format("plugin {} was built for ABI version {}, the kernel has {}: rebuild the plugin "
                        "against this installation's SDK",
                        record.library.string(), record.abi, MATPOINT_ABI_VERSION));
    open_file(record.library);
}

}  // namespace matpoint
