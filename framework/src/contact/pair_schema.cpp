// The parameters that every law between bodies has.
#include "contact/placed_contact.hpp"

#include <algorithm>
#include <memory>

namespace matpoint {

namespace {

bool is_direction(const Json& given) {
    return std::ranges::any_of(given, [](const Json& component) { return component != 0; });
}

}  // namespace

void declare_contact_pair(Schema& schema) {
    schema
        .add("between", ParameterType::references,
             {.doc = "Two or more bodies, each of which meets each other one; or \"all\"",
              .start_only = true,
              .choices = {"all"},
              .section = "bodies"})
        .add("normal", ParameterType::object,
             {.doc = "Direction from one body into the other at a node: \"average\" (from the centroid of "
                     "what one has around the node to the other's), \"regression\" (across the plane that "
                     "parts their particles best), or {\"fixed\": [0, 1]} from the first body named into the "
                     "other",
              .default_value = "average",
              .choices = {"average", "regression"},
              .nested = std::make_shared<Schema>(
                  Schema("A direction that is known").vector("fixed", {.doc = "It; of any length but 0"}))})
        .choice("gap",
                {.doc = "How far apart their surfaces are: by the moments of what is around a node, by "
                        "the faces of the closest particles, or as soon as they share a node",
                 .default_value = "moment",
                 .choices = {"moment", "particles", "none"}})
        .refuse("/normal", "a fixed direction is from one body into one other: give two bodies",
                [](const Json& own, const Json& scene) {
                    const Json& between = own.at("between");
                    const std::size_t count = std::ranges::find(between, "all") != between.end()
                                                  ? scene.at("bodies").size()
                                                  : between.size();
                    return own.at("normal").is_object() && count > 2;
                })
        .refuse("/normal/fixed", "has no direction: not all of it can be 0",
                [](const Json& own, const Json&) {
                    return own.at("normal").is_object() && !is_direction(own.at("normal").at("fixed"));
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
