#pragma once

#include "config/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace matpoint {

/// A handful of component types without any plugin behind them.
class FakeCatalogue final : public Catalogue {
  public:
    FakeCatalogue() {
        add("grid", "uniform",
            Schema()
                .vector("min", {.unit = "m"})
                .vector("max", {.unit = "m"})
                .add("cell_size", ParameterType::per_axis, {.unit = "m", .greater_than = 0}));
        add("shape_function", "bspline", Schema("Smooth functions"));
        add("shape_function", "gimp",
            Schema().choice("domain", {.default_value = "contiguous", .choices = {"contiguous", "uniform"}}));
        add("transfer", "flip",
            Schema().number("pic_fraction", {.default_value = 0, .at_least = 0, .at_most = 1}));
        add("transfer", "affine_flip", Schema());
        add("transfer", "apic",
            Schema().dimensions({2, 3}).warn("", "apic is dissipative with splines",
                                             [](const Json&, const Json& scene) {
                                                 return scene.at("shape_function").at("type") == "bspline";
                                             }));
        add("integrator", "central_difference", Schema());
        add("integrator", "usl", Schema());
        add("material", "neo_hookean",
            Schema("Compressible rubber", "[Author 2000, eq. 1]")
                .number("youngs_modulus", {.unit = "Pa", .doc = "E", .greater_than = 0})
                .number("poissons_ratio", {.greater_than = -1, .less_than = 0.5})
                .refuse("/poissons_ratio", "too stiff for this material", [](const Json& own, const Json&) {
                    return own.at("poissons_ratio").get<double>() > 0.49;
                }));
        add("geometry", "box", Schema().vector("min", {.unit = "m"}).vector("max", {.unit = "m"}));
        add("geometry", "union", Schema().add("of", ParameterType::components, {.kind = "geometry"}));
        add("geometry", "stl", Schema().add("file", ParameterType::file, {}));
        add("load", "gravity", Schema().vector("acceleration", {.unit = "m/s^2"}));
        add("contact", "coulomb",
            Schema()
                .add("between", ParameterType::references, {.section = "bodies"})
                .number("friction", {.default_value = 0, .at_least = 0}));
        add("boundary_condition", "fixed", Schema());
        add("boundary_condition", "velocity",
            Schema().add("value", ParameterType::profiles, {.unit = "m/s"}));
        add("output", "csv", Schema().add("fields", ParameterType::texts, {.default_value = "velocity"}));
        add("output", "probe", Schema().text("name", {}).writes("<name>.csv"));
        add("output", "tables",
            Schema()
                .text("name", {})
                .add("body", ParameterType::reference, {.optional = true, .section = "bodies"})
                .writes("<name>_<body>_<number>.csv")
                .writes("<name>_times.csv"));
    }
    const Schema* find(const std::string& kind, const std::string& type) override {
        const auto found = schemas_.find({kind, type});
        return found == schemas_.end() ? nullptr : &found->second;
    }
    std::vector<std::string> types(const std::string& kind) const override {
        std::vector<std::string> names;
        for (const auto& entry : schemas_) {
            if (entry.first.first == kind) names.push_back(entry.first.second);
        }
        return names;
    }

  private:
    void add(const std::string& kind, const std::string& type, Schema schema) {
        schemas_.emplace(std::pair(kind, type), std::move(schema));
    }
    std::map<std::pair<std::string, std::string>, Schema> schemas_;
};

inline const char* const example_scene = R"json({
  "matpoint": 1,
  "space": { "dimension": 2 },
  "grid": { "type": "uniform", "min": [0, 0], "max": ["200 cm", 1], "cell_size": 0.1 },
  "transfer": { "type": "flip", "pic_fraction": 0.1 },
  "time": { "end": "10 ms" },
  "materials": {
    // a comment
    "rubber": { "type": "neo_hookean", "density": 1000, "youngs_modulus": "4.2 MPa",
                "poissons_ratio": 0.4 }
  },
  "bodies": {
    "disk": { "material": "rubber", "particles_per_cell": 9,
              "geometry": { "type": "box", "min": [0, 0], "max": [1, 1] } },
    "plane": { "material": "rubber", "velocity": ["0.1*sin(pi*x)", "36 km/h"],
               "geometry": { "type": "union", "of": [ { "type": "stl", "file": "meshes/plane.stl" } ] } }
  },
  "contacts": [ { "type": "coulomb", "between": ["disk", "plane"], "friction": 0.5 } ],
  "boundary_conditions": [
    { "type": "fixed", "on": "y_min" },
    { "type": "velocity", "on": { "type": "box", "min": [0, 0], "max": [1, 1] }, "value": [null, "2 cm/s"] },
    { "type": "velocity", "on": "y_max", "value": [{ "times": [0, "1 ms"], "values": [0, "36 km/h"] }, null] }
  ],
  "outputs": [ { "type": "csv", "every": "1 ms", "fields": "stress" } ]
}
)json";

inline Document example(const std::vector<std::string>& settings = {}) {
    Document document = parse_document(example_scene, "scenes/example.json");
    for (const std::string& setting : settings) apply_set(document, setting, document.mistakes);
    return document;
}

/// What is said about the example after some changes: errors, or else warnings; one a line.
inline std::string complaints(const std::vector<std::string>& settings) {
    FakeCatalogue catalogue;
    try {
        std::string text;
        for (const Diagnostic& d : resolve_scene(example(settings), catalogue).warnings)
            text += to_string(d) + "\n";
        return text;
    } catch (const InputError& e) {
        return e.what();
    }
}

}  // namespace matpoint
