// What every material must satisfy, in every space: see matpoint/conformance/material_conformance.hpp.

#include <matpoint/conformance/material_conformance.hpp>

extern "C" void matpoint_plugin_register(matpoint::Registry& registry);

TEST({{Name}}, IsAMaterial) {
    matpoint::Registry registry;
    matpoint_plugin_register(registry);
    matpoint::conformance::check_material(
        registry, {{"type", "{{name}}"}, {"density", 1000}, {"bulk_modulus", 2e6}, {"exponent", 2}});
}
