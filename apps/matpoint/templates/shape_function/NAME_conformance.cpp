// What every shape function must satisfy, in every space: see
// matpoint/conformance/shape_function_conformance.hpp.

#include <matpoint/conformance/shape_function_conformance.hpp>

extern "C" void matpoint_plugin_register(matpoint::Registry& registry);

TEST({{Name}}, IsAShapeFunction) {
    matpoint::Registry registry;
    matpoint_plugin_register(registry);
    matpoint::conformance::check_shape_function(registry, {{"type", "{{name}}"}});
}
