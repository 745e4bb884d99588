#include "components.hpp"

#include "verbs.hpp"

#include "config/kinds.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace matpoint {

AllComponents::AllComponents() {
    std::vector<std::filesystem::path> folders;
    for (const auto& folder : plugin_folders()) {
        try {
            PluginIndex({folder});
            folders.push_back(folder);
        } catch (const PluginError& error) {
            report(error.what());
        }
    }
    plugins_.emplace(PluginIndex(folders));
    for (const Kind& kind : kinds()) {
        for (const std::string& type : plugins_->types(kind.name)) find(kind.name, type);
    }
}

const Schema* AllComponents::find(const std::string& kind, const std::string& type) {
    try {
        return plugins_->find(kind, type);
    } catch (const PluginError& error) {
        report(error.what());
        return nullptr;
    }
}

std::vector<std::string> AllComponents::types(const std::string& kind) const {
    std::vector<std::string> all = plugins_->types(kind);
    std::erase_if(all, [&](const std::string& type) { return !plugins_->registry().find(kind, type); });
    return all;
}

int AllComponents::exit_status() const {
    return reported_.empty() ? exit_done : exit_missing;
}

void AllComponents::report(const std::string& message) {
    if (reported_.insert(message).second) std::cerr << message << "\n";
}

}  // namespace matpoint
