#include <matpoint/plugin.hpp>

namespace acme {
double yield_stress(double strain);
}

MATPOINT_PLUGIN("undefined_symbol", "0.0.1") {
    registry.set_current_plugin("undefined_symbol", std::to_string(acme::yield_stress(0.1)));
}
