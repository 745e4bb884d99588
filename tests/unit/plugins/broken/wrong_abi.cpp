// As if built for an older kernel, by another compiler, with other libraries. Registering would abort.
#include <matpoint/plugin.hpp>

#include <cstdlib>

extern "C" __attribute__((visibility("default"))) const matpoint_abi_stamp matpoint_plugin_stamp;
const matpoint_abi_stamp matpoint_plugin_stamp = {"matpoint-plugin",
                                                  sizeof(matpoint_abi_stamp),
                                                  0,
                                                  "Brand X 9.8",
                                                  "libstdc++ 4 cxx11-abi 0",
                                                  30399,
                                                  16,
                                                  20102,
                                                  "wrong_abi",
                                                  "0.0.1"};
extern "C" __attribute__((visibility("default"))) void matpoint_plugin_register(matpoint::Registry&) {
    std::abort();
}
