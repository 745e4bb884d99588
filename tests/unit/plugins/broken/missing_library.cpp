#include <matpoint/plugin.hpp>

namespace acme {
double melting_point();
}

MATPOINT_PLUGIN("missing_library", "0.0.1") {
    registry.set_current_plugin("missing_library", std::to_string(acme::melting_point()));
}
