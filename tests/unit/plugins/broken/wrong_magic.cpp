#include <matpoint/plugin.hpp>

extern "C" __attribute__((visibility("default")))
const char matpoint_plugin_stamp[sizeof(matpoint_abi_stamp)];
const char matpoint_plugin_stamp[sizeof(matpoint_abi_stamp)] = "something else";
