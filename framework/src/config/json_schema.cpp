#include "config/json_schema.hpp"

#include "config/expected.hpp"
#include "config/kinds.hpp"
#include "config/scene.hpp"

namespace matpoint {
namespace {

Json reference_to(const std::string& definition) {
    return {{"$ref", "#/definitions/" + definition}};
}

Json any_of(std::initializer_list<Json> alternatives) {
    return {{"anyOf", Json(Json::array_t(alternatives))}};
}

Json list_of(const Json& items) {
    return {{"type", "array"}, {"items", items}};
}

/// One item per dimension.
Json axes_of(const Json& items) {
    return {{"type", "array"}, {"items", items}, {"minItems", 1}, {"maxItems", 3}};
}

Json bare_number(const ParameterOptions& o, const char* type) {
    Json schema{{"type", type}};
    if (o.at_least) schema["minimum"] = *o.at_least;
    if (o.at_most) schema["maximum"] = *o.at_most;
    if (o.greater_than) schema["exclusiveMinimum"] = *o.greater_than;
    if (o.less_than) schema["exclusiveMaximum"] = *o.less_than;
    return schema;
}

Json number(const ParameterOptions& o) {
    return any_of({bare_number(o, "number"), reference_to("quantity")});
}

Json profile(const ParameterOptions& o) {
    const Json table{{"type", "object"},
                     {"properties", {{"times", list_of(number({}))}, {"values", list_of(number(o))}}},
                     {"required", {"times", "values"}},
                     {"additionalProperties", false}};
    return any_of({bare_number(o, "number"), {{"type", "string"}}, table});
}

Json object(const std::vector<const Parameter*>& parameters, bool is_component);

Json object(const Schema& schema) {
    std::vector<const Parameter*> parameters;
    for (const Parameter& p : schema.parameters()) parameters.push_back(&p);
    return object(parameters, false);
}

/// What a parameter takes, or one of the words that may stand in its place.
Json or_word(const Parameter& p, Json schema) {
    return p.choices.empty() ? schema : any_of({{{"enum", p.choices}}, std::move(schema)});
}

Json value(const Parameter& p) {
    const Json text{{"type", "string"}};
    switch (p.type) {
        case ParameterType::number:
            return or_word(p, number(p));
        case ParameterType::integer:
            return bare_number(p, "integer");
        case ParameterType::boolean:
            return {{"type", "boolean"}};
        case ParameterType::choice:
            return {{"enum", p.choices}};
        case ParameterType::vector:
            return axes_of(number(p));
        case ParameterType::per_axis:
            return any_of({number(p), axes_of(number(p))});
        case ParameterType::numbers:
            return list_of(number(p));
        case ParameterType::texts:
        case ParameterType::references:
            return any_of({text, list_of(text)});
        case ParameterType::profile:
            return profile(p);
        case ParameterType::profiles:
            return axes_of(any_of({profile(p), {{"type", "null"}}}));
        case ParameterType::text:
        case ParameterType::file:
        case ParameterType::reference:
            return text;
        case ParameterType::place: {
            const Json face{{"enum", face_names(0)}};
            Json faces = list_of(face);
            faces["minItems"] = 1;
            return any_of({face, std::move(faces), reference_to("geometry"), object(part_schema())});
        }
        case ParameterType::component:
            return reference_to(p.kind);
        case ParameterType::components:
            return list_of(reference_to(p.kind));
        case ParameterType::object:
            return or_word(p, object(*p.nested));
        case ParameterType::objects:
            return list_of(object(*p.nested));
        case ParameterType::map:
            return {{"type", "object"},
                    {"additionalProperties", p.nested ? object(*p.nested) : reference_to(p.kind)},
                    {"propertyNames", {{"minLength", 1}}},
                    {"minProperties", static_cast<long>(p.at_least.value_or(0))}};
        case ParameterType::any:
            break;
    }
    return p.unit.empty() ? Json::object() : Json{{"type", "array"}};
}

Json object(const std::vector<const Parameter*>& parameters, bool is_component) {
    Json properties = Json::object();
    Json required = Json::array();
    if (is_component) properties["type"] = Json::object();
    for (const Parameter* p : parameters) {
        // Draft 7 ignores what stands beside a $ref.
        Json described{{"description", p->doc + (p->unit.empty() ? "" : " (" + p->unit + ")")},
                       {"allOf", Json::array({value(*p)})}};
        if (p->default_value) described["default"] = *p->default_value;
        properties[p->name] = std::move(described);
        if (!p->default_value && !p->optional) required.push_back(p->name);
    }
    Json schema{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) schema["required"] = required;
    return schema;
}

Json component(const Kind& kind, Catalogue& catalogue) {
    Json types = Json::array();
    Json cases = Json::array();
    for (const std::string& type : catalogue.types(kind.name)) {
        const Schema* schema = catalogue.find(kind.name, type);
        if (!schema) continue;
        types.push_back(type);
        Json then = object(parameters_of(kind, *schema), true);
        then["description"] = schema->doc();
        cases.push_back({{"if", {{"properties", {{"type", {{"const", type}}}}}}}, {"then", std::move(then)}});
    }
    // Without a type there is none to choose; `false` allows nothing.
    Json schema{{"description", kind.doc},
                {"type", "object"},
                {"properties", {{"type", types.empty() ? Json(false) : Json{{"enum", types}}}}},
                {"required", Json::array({"type"})}};
    if (!cases.empty()) schema["allOf"] = cases;
    return schema;
}

}  // namespace

Json json_schema(Catalogue& catalogue) {
    Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"title", "Matpoint scene, version 1"}};
    schema.update(object(scene_schema()));
    schema["definitions"]["quantity"] = {
        {"description", "A number with a unit, \"70 GPa\""},
        {"type", "string"},
        {"pattern", R"(^\s*-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*([^0-9\s.+-].*|1/.+)?$)"}};
    for (const Kind& kind : kinds()) schema["definitions"][kind.name] = component(kind, catalogue);
    return schema;
}

}  // namespace matpoint
