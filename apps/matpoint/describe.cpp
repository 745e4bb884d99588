#include "config/describe.hpp"

#include "components.hpp"
#include "options.hpp"
#include "verbs.hpp"

#include "config/kinds.hpp"
#include "config/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

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

std::string unknown(const std::string& name, const AllComponents& components) {
    std::vector<std::string> names;
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
            "its paper, what it does not go with. The name of a kind describes the kind.",
        .least_arguments = 1,
        .most_arguments = 1};
    verb.options.add_options()("json", "for programs");
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;

    const std::string name = arguments_of(*values).front();
    const bool json = values->count("json") > 0;
    AllComponents components;
    if (const Kind* kind = find_kind(name)) {
        std::cout << (json ? describe_json(*kind, components).dump(2) + "\n"
                           : describe_text(*kind, components));
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
    const Schema& schema = *components.find(kind->name, type);
    std::cout << (json ? describe_json(*kind, type, schema).dump(2) + "\n"
                       : describe_text(*kind, type, schema));
    return components.exit_status();
}

}  // namespace matpoint
