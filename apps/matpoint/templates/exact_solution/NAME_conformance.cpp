// What every exact solution must satisfy: its velocity and F are derivatives of its displacement, its stress is the
// material's, and its body force balances momentum. See matpoint/conformance/exact_solution_conformance.hpp.

#include <matpoint/conformance/exact_solution_conformance.hpp>

using matpoint::Json;

extern "C" void matpoint_plugin_register(matpoint::Registry& registry);

TEST({{Name}}, IsAnExactSolution) {
    matpoint::Registry registry;
    matpoint_plugin_register(registry);
    const Json scene = {
        {"space", {{"dimension", 1}, {"mode", "bar"}}},
        {"materials",
         {{"rubber",
           {{"type", "neo_hookean"}, {"density", 2}, {"youngs_modulus", 3e4}, {"poissons_ratio", 0}}}}},
        {"bodies", {{"bar", {{"material", "rubber"}}}}},
        {"exact_solution",
         {{"type", "{{name}}"}, {"body", Json::array({"bar"})}, {"amplitude", 0.3}, {"length", 2}, {"period", 0.05}}}};
    matpoint::conformance::check_exact_solution(registry, scene, {.min = {0, 0, 0}, .max = {2, 0, 0}, .end = 0.1});
}
