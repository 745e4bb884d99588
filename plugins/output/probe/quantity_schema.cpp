#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "quantity.hpp"

using matpoint::Json;
using matpoint::ParameterType;
using matpoint::Schema;

namespace {

enum class Use { refused, possible, needed };
using enum Use;

constexpr std::array keys{"body", "field", "component", "particle", "at", "boundary_condition"};

/// Which keys go with a quantity, in the order of `keys`.
struct Row {
    const char* quantity;
    std::array<Use, keys.size()> use;
};

constexpr std::array rows{
    Row{"particle", {needed, needed, possible, possible, possible, refused}},
    Row{"centroid", {possible, refused, possible, refused, refused, refused}},
    Row{"reaction", {refused, refused, possible, refused, refused, needed}},
    Row{"kinetic_energy", {possible, refused, refused, refused, refused, refused}},
    Row{"strain_energy", {refused, refused, refused, refused, refused, refused}},
    Row{"external_work", {refused, refused, refused, refused, refused, refused}},
    Row{"total_energy", {refused, refused, refused, refused, refused, refused}},
    Row{"momentum", {possible, refused, possible, refused, refused, refused}},
    Row{"mass", {possible, refused, refused, refused, refused, refused}},
    Row{"min", {possible, needed, possible, refused, refused, refused}},
    Row{"max", {possible, needed, possible, refused, refused, refused}},
    Row{"mean", {possible, needed, possible, refused, refused, refused}},
};

/// The rules that the table holds for one quantity and one key.
void add_rule(Schema& schema, const std::string& quantity, const std::string& key, Use use) {
    if (use == refused) {
        std::string takers;
        for (const Row& row : rows)
            for (std::size_t k = 0; k < keys.size(); ++k)
                if (keys[k] == key && row.use[k] != refused)
                    takers += (takers.empty() ? "" : ", ") + std::string(row.quantity);
        schema.refuse("/" + key,
                      fmt::format("the quantity \"{}\" takes no `{}`; these do: {}", quantity, key, takers),
                      [=](const Json& own, const Json&) {
                          return own.at("quantity") == quantity && own.contains(key);
                      });
    } else if (use == needed) {
        schema.refuse("", fmt::format("the quantity \"{}\" needs the key `{}`", quantity, key),
                      [=](const Json& own, const Json&) {
                          return own.at("quantity") == quantity && !own.contains(key);
                      });
    }
}

bool is_condition(const Json& scene, const std::string& name) {
    const Json& conditions = scene.at("boundary_conditions");
    return std::any_of(conditions.begin(), conditions.end(),
                       [&](const Json& condition) { return condition.value("name", "") == name; });
}

}  // namespace

void Quantity::describe(Schema& schema) {
    std::vector<std::string> quantities;
    for (const Row& row : rows) quantities.emplace_back(row.quantity);
    schema
        .choice(
            "quantity",
            {.doc = "What is measured: a particle's field; the centre of mass (m); the force of a boundary "
                    "condition on the bodies (N); energies (J), momentum (kg m/s) and mass (kg); the least, "
                    "greatest or mean value of a field over particles.",
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
        .text("boundary_condition", {.doc = "The `name` of the boundary condition.", .optional = true});

    for (const Row& row : rows)
        for (std::size_t k = 0; k < keys.size(); ++k) add_rule(schema, row.quantity, keys[k], row.use[k]);
    schema.refuse("", "the quantity \"particle\" needs either `particle` or `at`, and not both",
                  [](const Json& own, const Json&) {
                      return own.at("quantity") == "particle" &&
                             own.contains("particle") == own.contains("at");
                  });
    schema.refuse("/component",
                  "the quantity is a vector: its components are \"x\", \"y\" and \"z\", as many as the space "
                  "has dimensions",
                  [](const Json& own, const Json& scene) {
                      const Json& quantity = own.at("quantity");
                      if (quantity != "centroid" && quantity != "momentum" && quantity != "reaction")
                          return false;
                      if (!own.contains("component")) return false;
                      const auto dimension = scene.at("space").at("dimension").get<std::size_t>();
                      const std::string component = own.at("component");
                      return component.size() != 1 || std::string("xyz").find(component) >= dimension;
                  });
    schema.refuse("/boundary_condition", "no boundary condition has this name: give one the key `name`",
                  [](const Json& own, const Json& scene) {
                      return own.contains("boundary_condition") &&
                             !is_condition(scene, own.at("boundary_condition").get<std::string>());
                  });
}
