#include "config/describe.hpp"

#include "config/expected.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace matpoint {
namespace {

std::string presence(const Parameter& p) {
    if (p.default_value && !p.default_value->is_null()) return "default " + shown(*p.default_value);
    return p.optional || p.default_value ? "optional" : "required";
}

std::string with_paper(const std::string& doc, const std::string& paper) {
    return paper.empty() ? doc : doc.empty() ? paper : doc + " " + paper;
}

std::string table(const std::vector<const Parameter*>& parameters, const std::string& indent) {
    std::string text;
    for (const Parameter* p : parameters) {
        text += fmt::format("{}{}: {}; {}\n", indent, p->name, expected(*p), presence(*p));
        const std::string doc = with_paper(p->doc, p->paper);
        if (!doc.empty()) text += fmt::format("{}    {}\n", indent, doc);
        if (!p->nested) continue;
        std::vector<const Parameter*> inner;
        for (const Parameter& q : p->nested->parameters()) inner.push_back(&q);
        text += table(inner, indent + "    ");
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
        if (p->nested) {
            std::vector<const Parameter*> inner;
            for (const Parameter& q : p->nested->parameters()) inner.push_back(&q);
            one["parameters"] = to_json(inner);
        }
        all.push_back(std::move(one));
    }
    return all;
}

std::vector<const Rule*> rules_of(const Kind& kind, const Schema& schema) {
    std::vector<const Rule*> rules;
    for (const Rule& rule : kind.common.rules()) rules.push_back(&rule);
    for (const Rule& rule : schema.rules()) rules.push_back(&rule);
    return rules;
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
    const std::vector<const Rule*> rules = rules_of(kind, schema);
    if (!rules.empty()) text += "\nRules\n";
    for (const Rule* rule : rules) {
        text += fmt::format("  {}: {}\n", rule->refuses ? "refused" : "warned of", rule->reason);
    }
    return text;
}

Json describe_json(const Kind& kind, const std::string& type, const Schema& schema) {
    Json rules = Json::array();
    for (const Rule* rule : rules_of(kind, schema)) {
        rules.push_back({{"refuses", rule->refuses}, {"at", rule->pointer}, {"reason", rule->reason}});
    }
    return {{"kind", kind.name},
            {"type", type},
            {"doc", schema.doc()},
            {"paper", schema.paper()},
            {"dimensions", schema.dimensions()},
            {"parameters", to_json(parameters_of(kind, schema))},
            {"files", schema.files()},
            {"rules", rules}};
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

}  // namespace matpoint
