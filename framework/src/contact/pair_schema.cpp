// The parameters that every law between bodies has.
#include "contact/placed_contact.hpp"

#include <cmath>

namespace matpoint {

namespace {

bool is_normal(const Json& given, int dimension) {
    if (given.is_string()) return given == "average" || given == "regression";
    if (!given.is_object() || given.size() != 1 || !given.contains("fixed")) return false;
    const Json& direction = given.at("fixed");
    if (!direction.is_array() || static_cast<int>(direction.size()) != dimension) return false;
    double square = 0;
    for (const Json& component : direction) {
        if (!component.is_number()) return false;
        square += component.get<double>() * component.get<double>();
    }
    return square > 0 && std::isfinite(square);
}

}  // namespace

void declare_contact_pair(Schema& schema) {
    schema
        .add("between", ParameterType::references,
             {.doc = "Two or more bodies, each of which meets each other one; or \"all\"",
              .start_only = true,
              .choices = {"all"},
              .section = "bodies"})
        .add("normal", ParameterType::any,
             {.doc = "Direction from one body into the other at a node: \"average\" (from the centroid of "
                     "what one has around the node to the other's), \"regression\" (across the plane that "
                     "parts their particles best), or {\"fixed\": [0, 1]} from the first body named into the "
                     "others",
              .default_value = "average"})
        .choice("gap",
                {.doc = "How far apart their surfaces are: by the moments of what is around a node, by "
                        "the faces of the closest particles, or as soon as they share a node",
                 .default_value = "moment",
                 .choices = {"moment", "particles", "none"}})
        .refuse("/normal",
                "expected \"average\", \"regression\" or {\"fixed\": [0, 1]} with one number per axis, "
                "not all 0",
                [](const Json& own, const Json& scene) {
                    return !is_normal(own.at("normal"), scene.at("/space/dimension"_json_pointer).get<int>());
                });
}

PairRule PairRule::of(const Json& law) {
    PairRule rule;
    if (const Json& normal = law.at("normal"); normal.is_object()) {
        rule.normal = Normal::fixed;
        Eigen::Index a = 0;
        for (const Json& component : normal.at("fixed")) rule.fixed[a++] = component.get<double>();
        rule.fixed.normalize();
    } else if (normal == "regression") {
        rule.normal = Normal::regression;
    }
    const std::string gap = law.at("gap");
    rule.gap = gap == "particles" ? Gap::particles : gap == "none" ? Gap::none : Gap::moment;
    return rule;
}

}  // namespace matpoint
