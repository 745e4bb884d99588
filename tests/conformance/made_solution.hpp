#pragma once

#include "exact_solution_conformance.hpp"

#include "plugins.hpp"

#include <string>

namespace matpoint::conformance {

/// A solution and the parts of a scene that it knows: one body.
struct Made {
    PluginCatalogue catalogue;
    Json scene;
    std::shared_ptr<ExactSolution> solution;

    Made(const std::string& mode, const Json& material, const Json& own) {
        constexpr const char* by_dimension[] = {"", "bar", "plane_strain", "solid"};
        const auto dimension = std::ranges::find(by_dimension, mode) - std::begin(by_dimension);
        scene = {{"space", {{"dimension", dimension}, {"mode", mode}}},
                 {"materials", {{"rubber", material}}},
                 {"bodies", {{"body", {{"material", "rubber"}}}}},
                 {"loads", Json::array()},
                 {"exact_solution", own}};
        scene["exact_solution"]["body"] = Json::array({"body"});
        catalogue.find("exact_solution", own.at("type").get<std::string>());
        solution = catalogue.registry().make<ExactSolution>("exact_solution", scene.at("exact_solution"),
                                                            context_of(catalogue.registry(), scene));
    }
    ExactSolutionChecks checks(const ExactSolution& checked, const Samples& samples) const {
        return {checked, catalogue.registry(), scene, samples};
    }
    void check(const Samples& samples) const { checks(*solution, samples).all(); }

    /// Whether a rule of the type's refuses the scene, or warns about it.
    bool has_rule(bool refuses, const std::string& pointer) {
        const Json& own = scene.at("exact_solution");
        return conformance::has_rule(*catalogue.find("exact_solution", own.at("type").get<std::string>()),
                                     refuses, pointer, own, scene);
    }
};

inline Json rubber(const std::string& type, double density, double youngs_modulus, double poissons_ratio) {
    return {{"type", type},
            {"density", density},
            {"youngs_modulus", youngs_modulus},
            {"poissons_ratio", poissons_ratio}};
}
inline Json axis_aligned(double amplitude, double length = 1) {
    return {{"type", "axis_aligned_vibration"}, {"amplitude", amplitude}, {"length", length}};
}
inline Json ring(double inner, double outer, double amplitude, double length = 1) {
    return {{"type", "expanding_ring"},
            {"inner_radius", inner},
            {"outer_radius", outer},
            {"amplitude", amplitude},
            {"length", length}};
}
inline Json plate(double amplitude, const char* mode, double length = 1) {
    return {{"type", "plate_vibration"}, {"amplitude", amplitude}, {"mode", mode}, {"length", length}};
}

}  // namespace matpoint::conformance
