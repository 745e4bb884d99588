#include <matpoint/plugin.hpp>

extern "C" __attribute__((visibility("default"))) void matpoint_plugin_register(matpoint::Registry&) {}
