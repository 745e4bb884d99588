#include <matpoint/plugin.hpp>

#include <stdexcept>

MATPOINT_PLUGIN("throws", "0.0.1") {
    throw std::runtime_error("no licence for this Tuesday");
}
