#include "config/kinds.hpp"

#include <algorithm>

namespace matpoint {
namespace {

Schema with_density() {
    return Schema().number(
        "density",
        {.unit = "kg/m^3", .doc = "Initial mass per volume", .start_only = true, .greater_than = 0});
}

Schema with_light_nodes() {
    return Schema().number("light_nodes", {.doc = "Nodes with less than this share of a full node's mass "
                                                  "follow heavier neighbours; 0: none does, as "
                                                  "in the papers",
                                           .default_value = 0.1,
                                           .at_least = 0,
                                           .at_most = 0.1});
}

Schema with_place_and_name() {
    return Schema()
        .add("on", ParameterType::place,
             {.doc = "Grid faces, or the region, where the condition holds; or the body, or the part of it "
                     "within a geometry at the start, that carries it along"})
        .boolean("waits", {.doc = "In a region: whether it is meant that no body is there at the start",
                           .default_value = false})
        .text("name", {.doc = "What probes call the condition", .optional = true})
        .refuse("/waits", "a body has what it carries from the start: leave it out",
                [](const Json& own, const Json&) {
                    return own.at("on").is_object() && own.at("on").contains("body") &&
                           own.at("waits") == true;
                })
        .refuse(
            "/waits", "a face waits for bodies whatever is said: leave it out",
            [](const Json& own, const Json&) { return own.at("on").is_array() && own.at("waits") == true; });
}

Schema with_name() {
    return Schema().text("name", {.doc = "What probes call the load", .optional = true});
}

Schema with_contact_name() {
    return Schema().text("name",
                         {.doc = "What probes and the summary call the contact; by default its bodies, "
                                 "or its type",
                          .optional = true});
}

Schema with_measure() {
    Schema schema;
    schema
        .add("body", ParameterType::references,
             {.doc = "The body, or bodies, that it is the solution for", .section = "bodies"})
        .choice("quantity",
                {.doc = "What is compared: of the particles, or the velocity projected to the nodes",
                 .paper = "[Wallstedt & Guilkey 2008, eq. 64; eq. A.2 for nodes]",
                 .default_value = "displacement",
                 .choices = {"displacement", "velocity", "stress", "nodal_velocity"}})
        .boolean("relative", {.doc = "Whether deviations are divided by the exact value at their place",
                              .default_value = false})
        .add("within", ParameterType::component,
             {.doc = "Where it is measured: initial positions of particles, or nodes; by default everywhere",
              .optional = true,
              .kind = "geometry"});
    return schema;
}

Schema with_interval() {
    Schema schema;
    schema
        .number("every",
                {.unit = "s", .doc = "Simulated time between outputs", .optional = true, .greater_than = 0})
        .integer("every_steps", {.doc = "Steps between outputs", .optional = true, .at_least = 1});
    return refuse_two_intervals(schema);
}

Schema make_part_schema() {
    return Schema("A body, or a part of it")
        .add("body", ParameterType::reference,
             {.doc = "A name in /bodies", .start_only = true, .section = "bodies"})
        .add("within", ParameterType::component,
             {.doc = "Where the part is at the start; by default everywhere",
              .optional = true,
              .start_only = true,
              .kind = "geometry"});
}

std::vector<Kind> make_kinds() {
    return {
        {"grid", "grid", "Background grid", with_light_nodes()},
        {"shape_function", "shape_function", "Grid basis and particle domain", Schema(), true},
        {"transfer", "transfer", "How velocity goes to the grid and back", Schema(), true},
        {"integrator", "integrator", "Order of the phases of a step", Schema(), true},
        {"material", "materials", "Constitutive model", with_density()},
        {"geometry", "", "Region that a body fills or a condition holds in", Schema()},
        {"load", "loads", "Body force or traction", with_name()},
        {"contact", "contacts", "Law between bodies that meet, or a rigid tool", with_contact_name()},
        {"boundary_condition", "boundary_conditions",
         "Condition on grid faces, in a region or on a part of a body", with_place_and_name()},
        {"damping", "damping", "What leads a scene to rest", Schema()},
        {"exact_solution", "exact_solution", "Known solution that errors are measured against",
         with_measure()},
        {"output", "outputs", "Files written during a run", with_interval()},
    };
}

}  // namespace

Schema& refuse_two_intervals(Schema& schema) {
    return schema.refuse(
        "/every_steps", "give `every` or `every_steps`, not both",
        [](const Json& own, const Json&) { return own.contains("every") && own.contains("every_steps"); });
}

const Schema& part_schema() {
    static const Schema schema = make_part_schema();
    return schema;
}

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = make_kinds();
    return all;
}

const Kind* find_kind(std::string_view name) {
    const auto found =
        std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.name == name; });
    return found == kinds().end() ? nullptr : &*found;
}

std::vector<const Parameter*> parameters_of(const Kind& kind, const Schema& type) {
    std::vector<const Parameter*> all;
    for (const Parameter& p : kind.common.parameters()) {
        if (!type.find(p.name)) all.push_back(&p);
    }
    for (const Parameter& p : type.parameters()) all.push_back(&p);
    return all;
}

}  // namespace matpoint
