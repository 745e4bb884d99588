#include "new_plugin.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>

#include "config/kinds.hpp"
#include "config/nearest.hpp"
#include "config/scene.hpp"
#include "options.hpp"
#include "registry/plugin_index.hpp"
#include "templates.hpp"
#include "verbs.hpp"

namespace matpoint {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view common = "common";  // the templates for plugins of every kind

std::string_view folder_of(const TemplateFile& file) {
    return file.path.substr(0, file.path.find('/'));
}

std::vector<std::string> kinds_of_plugins() {
    std::set<std::string> kinds;
    for (const TemplateFile& file : template_files())
        if (folder_of(file) != common) kinds.emplace(folder_of(file));
    return {kinds.begin(), kinds.end()};
}

/// tait_water -> TaitWater
std::string upper_camel_case(const std::string& snake_case) {
    std::string result;
    bool first = true;
    for (const char c : snake_case) {
        if (c != '_') result += first ? static_cast<char>(std::toupper(c)) : c;
        first = c == '_';
    }
    return result;
}

std::string filled_in(std::string text, const std::string& kind, const std::string& name) {
    boost::replace_all(text, "{{kind}}", kind);
    boost::replace_all(text, "{{name}}", name);
    boost::replace_all(text, "{{Name}}", upper_camel_case(name));
    return text;
}

/// Files of the same name are put together: README.md tells about the kind first, then how to build.
void write_project(const fs::path& folder, const std::string& kind, const std::string& name) {
    fs::create_directories(folder);
    for (const std::string_view source : {std::string_view(kind), common})
        for (const TemplateFile& file : template_files()) {
            if (folder_of(file) != source) continue;
            const std::string path(file.path.substr(source.size() + 1));
            const fs::path target = folder / boost::replace_all_copy(path, "NAME", name);
            std::ofstream stream(target, std::ios::app);
            stream << filled_in(std::string(file.text), kind, name);
            if (!stream.flush()) throw std::runtime_error("can't write " + target.string());
        }
}

/// Whether the template of a kind uses a name, so that its class can't have it.
bool uses(const std::string& kind, const std::string& name) {
    static const std::regex words(R"(//.*|"[^"]*"|\{\{\w+\}\}|(\w+))");
    for (const TemplateFile& file : template_files()) {
        if (folder_of(file) != kind || !file.path.ends_with(".cpp")) continue;
        std::cregex_iterator word(file.text.begin(), file.text.end(), words), end;
        if (std::any_of(word, end, [&](const std::cmatch& match) { return match[1] == name; })) return true;
    }
    return false;
}

/// Why a plugin can't have a name in snake_case; empty if it can.
std::string reason_against(const std::string& name, const std::string& kind, const PluginIndex& index) {
    // add_library refuses the first ones, as the names of its own targets.
    static const std::set<std::string> reserved{"all",
                                                "clean",
                                                "edit_cache",
                                                "help",
                                                "install",
                                                "package",
                                                "package_source",
                                                "rebuild_cache",
                                                "test",
                                                "preinstall",
                                                "list_install_components",
                                                "matpoint"};
    if (reserved.contains(name)) return "CMake, or the SDK, has a target of this name";
    const std::string own = upper_camel_case(name);
    const auto sdk = sdk_names();
    if (std::find(sdk.begin(), sdk.end(), own) != sdk.end() || uses(kind, own))
        return fmt::format("the plugin's class would be called {}, which the SDK uses", own);
    if (name == "scene" || find_kind(name) || scene_schema().find(name))
        return fmt::format("`matpoint describe {}` tells of something else", name);
    for (const PluginRecord& plugin : index.plugins())
        if (plugin.plugin == name || plugin.offers(kind, name))
            return fmt::format("a plugin of this name exists already ({})", plugin.library.string());
    return {};
}

void check(const std::string& kind, const std::string& name, const fs::path& folder) {
    const std::vector<std::string> known = kinds_of_plugins();
    if (std::find(known.begin(), known.end(), kind) == known.end())
        throw UsageError(fmt::format("there is no template for plugins of kind \"{}\"{}", kind,
                                     did_you_mean(kind, known)));
    static const std::regex snake_case("[a-z][a-z0-9]*(_[a-z0-9]+)*");
    constexpr std::size_t longest = 60;  // the binary stamp has room for 63
    if (!std::regex_match(name, snake_case) || name.size() > longest)
        throw UsageError(fmt::format(
            "\"{}\" is not a name for a plugin: use snake_case, at most {} letters, as in \"tait_water\"",
            name, longest));
    const std::string reason = reason_against(name, kind, PluginIndex(plugin_folders()));
    if (!reason.empty())
        throw UsageError(
            fmt::format("\"{}\" can't be the name of a plugin: {}; choose another, such as \"my_{}\"", name,
                        reason, name));
    if (fs::exists(folder))
        throw UsageError(fmt::format("{} exists already: remove it, or choose another folder with --output",
                                     folder.string()));
}

}  // namespace

int new_plugin(const std::vector<std::string>& arguments) {
    VerbOptions verb;
    verb.usage = "matpoint new_plugin KIND NAME [--output DIR]";
    verb.doc = fmt::format("Writes a project for a plugin of your own, with a scene and tests. Kinds: {}.",
                           fmt::join(kinds_of_plugins(), ", "));
    verb.options.add_options()("output", po::value<std::string>()->value_name("DIR"),
                               "folder of the project; by default NAME");
    verb.least_arguments = verb.most_arguments = 2;
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;

    const std::string kind = arguments_of(*values)[0], name = arguments_of(*values)[1];
    const fs::path folder = values->count("output") ? (*values)["output"].as<std::string>() : name;
    check(kind, name, folder);
    write_project(folder, kind, name);
    std::cout << fmt::format(
        "{0}: a project for the {1} \"{2}\". Next:\n"
        "  cmake -S {0} -B {0}/build && cmake --build {0}/build && ctest --test-dir {0}/build\n"
        "  MATPOINT_PLUGIN_PATH={0}/build/plugins matpoint run {0}/{2}.json\n",
        folder.string(), kind, name);
    return exit_done;
}

}  // namespace matpoint
