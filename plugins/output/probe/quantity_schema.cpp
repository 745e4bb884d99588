#include <algorithm>

#include "quantity.hpp"

using matpoint::Json;
using matpoint::ParameterType;
using matpoint::Schema;
using matpoint::Use;
using matpoint::UseTable;

namespace {

using enum Use;

/// Which keys go with a quantity.
const UseTable table{
    .chooser = "quantity",
    .parameters = {"body", "field", "component", "particle", "at", "boundary_condition", "contact"},
    .rows = {
        {"particle", {needed, needed, possible, possible, possible, refused, refused}},
        {"centroid", {possible, refused, possible, refused, refused, refused, refused}},
        {"reaction", {refused, refused, possible, refused, refused, needed, refused}},
        {"contact_force", {refused, refused, possible, refused, refused, refused, needed}},
        {"contact_torque", {refused, refused, possible, refused, refused, refused, needed}},
        {"position", {refused, refused, possible, refused, refused, refused, needed}},
        {"kinetic_energy", {possible, refused, refused, refused, refused, refused, refused}},
        {"strain_energy", {refused, refused, refused, refused, refused, refused, refused}},
        {"external_work", {refused, refused, refused, refused, refused, refused, refused}},
        {"total_energy", {refused, refused, refused, refused, refused, refused, refused}},
        {"damped_energy", {refused, refused, refused, refused, refused, refused, refused}},
        {"contact_energy", {refused, refused, refused, refused, refused, refused, refused}},
        {"unbalanced_force", {refused, refused, refused, refused, refused, refused, refused}},
        {"noise", {refused, refused, refused, refused, refused, refused, refused}},
        {"momentum", {possible, refused, possible, refused, refused, refused, refused}},
        {"mass", {possible, refused, refused, refused, refused, refused, refused}},
        {"min", {possible, needed, possible, refused, refused, refused, refused}},
        {"max", {possible, needed, possible, refused, refused, refused, refused}},
        {"mean", {possible, needed, possible, refused, refused, refused, refused}},
    }};

bool is_named(const Json& scene, const char* section, const std::string& name) {
    const Json& all = scene.at(section);
    return std::any_of(all.begin(), all.end(),
                       [&](const Json& one) { return one.value("name", "") == name; });
}

}  // namespace

void Quantity::describe(Schema& schema) {
    std::vector<std::string> quantities;
    for (const UseTable::Row& row : table.rows) quantities.push_back(row.choice);
    schema
        .choice(
            "quantity",
            {.doc = "What is measured: a particle's field; the centre of mass (m); the force of a boundary "
                    "condition on the bodies (N); the force (N) of a contact on the first of its bodies, or "
                    "on its "
                    "tool, with the tool's torque (N m) and position (m); energies (J), momentum (kg m/s) "
                    "and mass (kg); the force that "
                    "is not in balance, over the forces that should be; the share of the velocity that the "
                    "grid does not see; the least, greatest or mean value of a field over particles.",
             .choices = std::move(quantities)})
        .add("body", ParameterType::reference,
             {.doc = "The body that is measured; all together if absent.",
              .optional = true,
              .section = "bodies"})
        .text("field",
              {.doc = "Field of the particles, as \"stress\" or \"von_mises_stress\".", .optional = true})
        .choice("component",
                {.doc = "The only component that is written; all, each in its column, if absent.",
                 .optional = true,
                 .choices = {"x", "y", "z", "xx", "yy", "zz", "xy", "yx", "yz", "zy", "xz", "zx"}})
        .integer("particle", {.doc = "Number of the particle in its body, from 0 in the order of seeding.",
                              .optional = true,
                              .at_least = 0})
        .vector("at",
                {.unit = "m", .doc = "The particle nearest to this place at the start.", .optional = true})
        .text("boundary_condition", {.doc = "The `name` of the boundary condition.", .optional = true})
        .text("contact", {.doc = "The `name` of the contact.", .optional = true});

    schema.use(table);
    schema.refuse("", "the quantity \"particle\" needs either `particle` or `at`, and not both",
                  [](const Json& own, const Json&) {
                      return own.at("quantity") == "particle" &&
                             own.contains("particle") == own.contains("at");
                  });
    schema.refuse("/component",
                  "the quantity is a vector: its components are \"x\", \"y\" and \"z\", as many as the space "
                  "has dimensions (a torque in 2D has z alone)",
                  [](const Json& own, const Json& scene) {
                      const Json& quantity = own.at("quantity");
                      const std::vector<std::string> vectors{"centroid",      "momentum",       "reaction",
                                                             "contact_force", "contact_torque", "position"};
                      if (std::find(vectors.begin(), vectors.end(), quantity) == vectors.end()) return false;
                      if (!own.contains("component")) return false;
                      const auto dimension = scene.at("space").at("dimension").get<std::size_t>();
                      const std::string component = own.at("component");
                      if (quantity == "contact_torque" && dimension == 2) return component != "z";
                      return component.size() != 1 || std::string("xyz").find(component) >= dimension;
                  });
    schema.refuse("/boundary_condition", "no boundary condition has this name: give one the key `name`",
                  [](const Json& own, const Json& scene) {
                      return own.contains("boundary_condition") &&
                             !is_named(scene, "boundary_conditions",
                                       own.at("boundary_condition").get<std::string>());
                  });
    schema.refuse("/contact", "no contact has this name", [](const Json& own, const Json& scene) {
        return own.contains("contact") && !is_named(scene, "contacts", own.at("contact").get<std::string>());
    });
}
