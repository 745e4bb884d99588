#include "config/describe.hpp"

#include "components.hpp"
#include "options.hpp"
#include "verbs.hpp"

#include "config/kinds.hpp"
#include "config/nearest.hpp"
#include "config/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <string_view>

namespace matpoint {
namespace {

struct Match {
    const Kind* kind;
    std::string type;
};

/// The components called `name`: a type, or kind/type.
std::vector<Match> matches(const std::string& name, const AllComponents& components) {
    std::vector<Match> found;
    for (const Kind& kind : kinds()) {
        for (const std::string& type : components.types(kind.name)) {
            if (name == type || name == kind.name + "/" + type) found.push_back({&kind, type});
        }
    }
    return found;
}

/// The key of a scene called `name`: "time", or "scene/time"; nullptr if there is none.
const Parameter* scene_key(std::string_view name) {
    constexpr std::string_view prefix = "scene/";
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
    return scene_schema().find(name);
}

std::string unknown(const std::string& name, const AllComponents& components) {
    std::vector<std::string> names{"scene"};
    for (const Parameter& key : scene_schema().parameters()) names.push_back(key.name);
    for (const Kind& kind : kinds()) {
        names.push_back(kind.name);
        for (const std::string& type : components.types(kind.name)) {
            names.push_back(name.find('/') == name.npos ? type : kind.name + "/" + type);
        }
    }
    return fmt::format("no component is called \"{}\"{}", name,
                       nearest(name, names) ? did_you_mean(name, names) : "; `matpoint list` names them all");
}

}  // namespace

int describe(const std::vector<std::string>& arguments) {
    VerbOptions verb{
        .usage = "matpoint describe TYPE [--json]",
        .doc =
            "Describes a component, by its type (or kind/type): parameters with units and defaults,\n"
            "its paper, what it does not go with. The name of a kind describes the kind, that of a key\n"
            "of scenes (time, bodies) the key, and `scene` all keys.",
        .least_arguments = 1,
        .most_arguments = 1};
    verb.options.add_options()("json", "for programs");
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;

    const std::string name = arguments_of(*values).front();
    const bool json = values->count("json") > 0;
    const auto print = [json](const auto&... of) {
        std::cout << (json ? describe_json(of...).dump(2) + "\n" : describe_text(of...));
    };
    if (name == "scene") {
        std::cout << (json ? describe_scene_json().dump(2) + "\n" : describe_scene_text());
        return exit_done;
    }
    const Parameter* const key = scene_key(name);
    if (key && key->kind.empty()) {
        print(*key);
        return exit_done;
    }
    AllComponents components;
    if (const Kind* kind = find_kind(key ? key->kind : name)) {
        print(*kind, components);
        return components.exit_status();
    }
    const std::vector<Match> found = matches(name, components);
    if (found.empty()) throw UsageError(unknown(name, components));
    if (found.size() > 1) {
        std::vector<std::string> full_names;
        for (const Match& match : found) full_names.push_back(match.kind->name + "/" + match.type);
        throw UsageError(
            fmt::format("several components are called \"{}\": {}", name, fmt::join(full_names, ", ")));
    }
    const auto& [kind, type] = found.front();
    print(*kind, type, *components.find(kind->name, type));
    return components.exit_status();
}

}  // namespace matpoint
