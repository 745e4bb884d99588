#include <matpoint/plugin.hpp>

extern "C" __attribute__((visibility("default"))) const matpoint_abi_stamp matpoint_plugin_stamp;
const matpoint_abi_stamp matpoint_plugin_stamp = MATPOINT_STAMP("missing_register", "0.0.1");
