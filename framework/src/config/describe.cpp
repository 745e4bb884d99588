#include "config/describe.hpp"

#include "config/expected.hpp"
#include "config/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace matpoint {
namespace {

std::string presence(const Parameter& p) {
    if (p.default_value && !p.default_value->is_null()) return "default " + shown(*p.default_value);
    return p.optional || p.default_value ? "optional" : "required";
}

std::string with_paper(const std::string& doc, const std::string& paper) {
    return paper.empty() ? doc : doc.empty() ? paper : doc + " " + paper;
}

std::vector<const Parameter*> pointers(const Schema& schema) {
    std::vector<const Parameter*> all;
    for (const Parameter& p : schema.parameters()) all.push_back(&p);
    return all;
}

std::string table(const std::vector<const Parameter*>& parameters, const std::string& indent) {
    std::string text;
    for (const Parameter* p : parameters) {
        text += fmt::format("{}{}: {}; {}\n", indent, p->name, expected(*p), presence(*p));
        const std::string doc = with_paper(p->doc, p->paper);
        if (!doc.empty()) text += fmt::format("{}    {}\n", indent, doc);
        if (p->nested) text += table(pointers(*p->nested), indent + "    ");
    }
    return text;
}

Json to_json(const std::vector<const Parameter*>& parameters) {
    Json all = Json::array();
    for (const Parameter* p : parameters) {
        Json one{{"name", p->name},
                 {"type", type_name(p->type)},
                 {"expected", expected(*p)},
                 {"unit", p->unit},
                 {"required", !p->optional && !p->default_value},
                 {"doc", p->doc}};
        if (!p->paper.empty()) one["paper"] = p->paper;
        if (p->default_value) one["default"] = *p->default_value;
        if (p->at_least) one["at_least"] = *p->at_least;
        if (p->at_most) one["at_most"] = *p->at_most;
        if (p->greater_than) one["greater_than"] = *p->greater_than;
        if (p->less_than) one["less_than"] = *p->less_than;
        if (!p->choices.empty()) one["choices"] = p->choices;
        if (p->start_only) one["start_only"] = true;
        if (!p->section.empty()) one["section"] = p->section;
        if (!p->kind.empty()) one["kind"] = p->kind;
        if (p->nested) one["parameters"] = to_json(pointers(*p->nested));
        all.push_back(std::move(one));
    }
    return all;
}

std::vector<const Rule*> pointers(const std::vector<Rule>& rules) {
    std::vector<const Rule*> all;
    for (const Rule& rule : rules) all.push_back(&rule);
    return all;
}

std::vector<const Rule*> rules_of(const Kind& kind, const Schema& schema) {
    std::vector<const Rule*> rules = pointers(kind.common.rules());
    for (const Rule* rule : pointers(schema.rules())) rules.push_back(rule);
    return rules;
}

std::string rules_text(const std::vector<const Rule*>& rules) {
    std::string text;
    for (const Rule* rule : rules) {
        if (rule->tabled) continue;
        const std::string parameter = rule->pointer.empty() ? "" : " (" + rule->pointer.substr(1) + ")";
        text += fmt::format("  {}{}: {}\n", rule->refuses ? "refused" : "warned of", parameter, rule->reason);
    }
    return text.empty() ? "" : "\nRules\n" + text;
}

Json rules_json(const std::vector<const Rule*>& rules) {
    Json all = Json::array();
    for (const Rule* rule : rules)
        all.push_back({{"refuses", rule->refuses}, {"at", rule->pointer}, {"reason", rule->reason}});
    return all;
}

const char* word(Use use) {
    return use == Use::needed ? "needed" : use == Use::possible ? "possible" : "-";
}

std::string uses_text(const UseTable& uses) {
    std::size_t width = uses.chooser.size();
    for (const UseTable::Row& row : uses.rows) width = std::max(width, row.choice.size());
    std::string text = fmt::format("\nWhat goes with each {}\n  {:{}}", uses.chooser, uses.chooser, width);
    for (const std::string& parameter : uses.parameters) text += fmt::format("  {:8}", parameter);
    for (const UseTable::Row& row : uses.rows) {
        text += fmt::format("\n  {:{}}", row.choice, width);
        for (std::size_t k = 0; k < row.uses.size(); ++k)
            text += fmt::format("  {:{}}", word(row.uses[k]),
                                std::max<std::size_t>(8, uses.parameters[k].size()));
    }
    return text + "\n";
}

Json uses_json(const UseTable& uses) {
    Json rows = Json::object();
    for (const UseTable::Row& row : uses.rows) {
        Json& own = rows[row.choice] = Json::object();
        for (std::size_t k = 0; k < row.uses.size(); ++k)
            if (row.uses[k] != Use::refused) own[uses.parameters[k]] = word(row.uses[k]);
    }
    return {{"chooser", uses.chooser}, {"rows", rows}};
}

}  // namespace

std::string describe_text(const Kind& kind, const std::string& type, const Schema& schema) {
    std::string text =
        fmt::format("{} ({}; in {} dimensions)\n", type, kind.name, fmt::join(schema.dimensions(), ", "));
    const std::string doc = with_paper(schema.doc(), schema.paper());
    if (!doc.empty()) text += doc + "\n";
    const std::string parameters = table(parameters_of(kind, schema), "  ");
    if (!parameters.empty()) text += "\nParameters\n" + parameters;
    if (!schema.files().empty()) text += fmt::format("\nFiles: {}\n", fmt::join(schema.files(), ", "));
    if (kind.decides_accuracy)
        text += "\nWhat it costs and gains beside the others: framework/docs/what_accuracy_costs.md\n";
    if (schema.table()) text += uses_text(*schema.table());
    return text + rules_text(rules_of(kind, schema));
}

Json describe_json(const Kind& kind, const std::string& type, const Schema& schema) {
    Json described{{"kind", kind.name},
                   {"type", type},
                   {"doc", schema.doc()},
                   {"paper", schema.paper()},
                   {"dimensions", schema.dimensions()},
                   {"parameters", to_json(parameters_of(kind, schema))},
                   {"files", schema.files()},
                   {"rules", rules_json(rules_of(kind, schema))}};
    if (schema.table()) described["uses"] = uses_json(*schema.table());
    return described;
}

std::string describe_text(const Kind& kind, const Catalogue& catalogue) {
    std::string text = fmt::format("{}: {}\n", kind.name, kind.doc);
    text += fmt::format("Types: {}\n", fmt::join(catalogue.types(kind.name), ", "));
    const std::string parameters = table(parameters_of(kind, Schema()), "  ");
    return parameters.empty() ? text : text + "\nParameters of every type\n" + parameters;
}

Json describe_json(const Kind& kind, const Catalogue& catalogue) {
    return {{"kind", kind.name},
            {"section", kind.section},
            {"doc", kind.doc},
            {"types", catalogue.types(kind.name)},
            {"parameters", to_json(parameters_of(kind, Schema()))}};
}

std::vector<const Parameter*> own_keys() {
    std::vector<const Parameter*> keys = pointers(scene_schema());
    std::erase_if(keys, [](const Parameter* key) { return !key->kind.empty(); });
    return keys;
}

std::string describe_scene_text() {
    return "scene: The keys of a scene\n\n" + table(pointers(scene_schema()), "  ");
}

Json describe_scene_json() {
    return {{"kind", "scene"}, {"parameters", to_json(pointers(scene_schema()))}};
}

std::string describe_text(const Parameter& key) {
    std::string text = fmt::format("{} (key of a scene): {}; {}\n", key.name, expected(key), presence(key));
    if (!key.nested) return text + key.doc + "\n";
    text += key.nested->doc() + "\n\nParameters\n" + table(pointers(*key.nested), "  ");
    return text + rules_text(pointers(key.nested->rules()));
}

Json describe_json(const Parameter& key) {
    Json described{{"kind", "scene"}, {"type", key.name}, {"doc", key.nested ? key.nested->doc() : key.doc}};
    if (key.nested) {
        described["parameters"] = to_json(pointers(*key.nested));
        described["rules"] = rules_json(pointers(key.nested->rules()));
    }
    return described;
}

}  // namespace matpoint
