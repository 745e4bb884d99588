#include "components.hpp"
#include "options.hpp"
#include "verbs.hpp"

#include "config/describe.hpp"
#include "config/kinds.hpp"
#include "config/nearest.hpp"

#include <fmt/format.h>

#include <iostream>

namespace matpoint {
namespace {

constexpr const char* scene_kind = "scene";  // listed as a kind: its keys that choose no component

void print(const std::string& name, const std::string& doc) {
    std::cout << fmt::format("  {:24}{}\n", name, doc);
}

void print_own_keys() {
    std::cout << scene_kind << ": What a scene says beside its components\n";
    for (const Parameter* key : own_keys()) print(key->name, key->doc);
}

void print(const Kind& kind, AllComponents& components) {
    std::cout << kind.name << ": " << kind.doc << "\n";
    const std::vector<std::string> types = components.types(kind.name);
    if (types.empty()) std::cout << "  (none)\n";
    for (const std::string& type : types) {
        print(type, components.find(kind.name, type)->doc());
    }
}

Json to_json(const Kind& kind, AllComponents& components) {
    Json all = Json::array();
    for (const std::string& type : components.types(kind.name)) {
        all.push_back({{"type", type}, {"doc", components.find(kind.name, type)->doc()}});
    }
    return all;
}

}  // namespace

int list(const std::vector<std::string>& arguments) {
    VerbOptions verb{.usage = "matpoint list [KIND] [--json]",
                     .doc =
                         "Lists the components there are, of one kind or of all, and the keys that a scene "
                         "has beside them\n"
                         "(`matpoint list scene`).",
                     .most_arguments = 1};
    verb.options.add_options()("json", "for programs");
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;

    const std::vector<std::string> wanted = arguments_of(*values);
    if (!wanted.empty() && wanted.front() != scene_kind && !find_kind(wanted.front())) {
        std::vector<std::string> names{scene_kind};
        for (const Kind& kind : kinds()) names.push_back(kind.name);
        throw UsageError(
            fmt::format("unknown kind \"{}\"{}", wanted.front(), did_you_mean(wanted.front(), names)));
    }
    const bool json = values->count("json") > 0;
    AllComponents components;
    Json all = Json::object();
    if (wanted.empty() || wanted.front() == scene_kind) {
        if (json)
            for (const Parameter* key : own_keys())
                all[scene_kind].push_back({{"type", key->name}, {"doc", key->doc}});
        else
            print_own_keys();
    }
    for (const Kind& kind : kinds()) {
        if (!wanted.empty() && kind.name != wanted.front()) continue;
        if (json) {
            all[kind.name] = to_json(kind, components);
        } else {
            print(kind, components);
        }
    }
    if (json) std::cout << all.dump(2) << "\n";
    return components.exit_status();
}

}  // namespace matpoint
