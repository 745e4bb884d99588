#pragma once

#include "config/scene.hpp"
#include "registry/catalogue.hpp"
#include "run/simulation.hpp"
#include "verify/load_scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace matpoint::conformance {

/// A scene given as JSON, simulated in memory.
struct Simulated {
    PluginCatalogue catalogue;
    Scene scene;
    std::unique_ptr<Simulation> simulation;

    explicit Simulated(const Json& json)
        : scene(load_scene(parse_document(json.dump(), "scene.json"), {}, catalogue)),
          simulation(Simulation::create(scene, catalogue)) {}

    Simulated& advance(long steps) {
        for (long i = 0; i < steps; ++i) simulation->advance();
        return *this;
    }
    Simulation* operator->() { return simulation.get(); }
};

/// A square of rubber, off-centre, spinning and drifting so that particles change cells, and tied at
/// its lower face.
inline Json busy_scene() {
    return Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [2, 2], "cell_size": 0.1},
        "shape_function": {"type": "gimp"},
        "time": {"end": 100, "cfl": 0.3},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}},
        "bodies": {"square": {"material": "rubber", "velocity": ["1 - 3*(y-0.6)", "0.5 + 3*(x-0.7)"],
                              "geometry": {"type": "box", "min": [0.3, 0.0], "max": [1.1, 0.8]}}},
        "loads": [{"type": "gravity", "acceleration": [0, -9.81]}],
        "boundary_conditions": [{"type": "slip", "on": ["y_min", "x_min", "x_max"]}],
        "outputs": [{"type": "csv", "fields": ["velocity"]}]
    })json");
}

}  // namespace matpoint::conformance
