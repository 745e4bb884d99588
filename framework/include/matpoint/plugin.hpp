#pragma once

#include <matpoint/registry.hpp>

/// Version of the binary interface between kernel and plugins; raised whenever a class that both
/// see changes its layout or its virtual functions.
#define MATPOINT_ABI_VERSION 9

extern "C" {
/// Plain data that the loader reads before it calls into a plugin. Its own layout never changes.
struct matpoint_abi_stamp {
    char magic[16];  ///< "matpoint-plugin"
    int stamp_size;
    int abi_version;            ///< MATPOINT_ABI_VERSION
    char compiler[64];          ///< __VERSION__ of the compiler
    char standard_library[64];  ///< libstdc++ release and ABI flag
    int eigen_version;          ///< world * 10000 + major * 100 + minor
    int eigen_max_align_bytes;  ///< follows -march unless pinned; changes layouts
    int json_version;           ///< nlohmann-json, the same coding
    char plugin[64];
    char plugin_version[32];
};
}

#define MATPOINT_STRINGIFY_(x) #x
#define MATPOINT_STRINGIFY(x) MATPOINT_STRINGIFY_(x)
#define MATPOINT_STAMP(NAME, VERSION)                                                           \
    {                                                                                           \
        "matpoint-plugin", sizeof(matpoint_abi_stamp), MATPOINT_ABI_VERSION, __VERSION__,       \
            "libstdc++ " MATPOINT_STRINGIFY(_GLIBCXX_RELEASE) " cxx11-abi " MATPOINT_STRINGIFY( \
                _GLIBCXX_USE_CXX11_ABI),                                                        \
            EIGEN_WORLD_VERSION * 10000 + EIGEN_MAJOR_VERSION * 100 + EIGEN_MINOR_VERSION,      \
            EIGEN_MAX_ALIGN_BYTES,                                                              \
            NLOHMANN_JSON_VERSION_MAJOR * 10000 + NLOHMANN_JSON_VERSION_MINOR * 100 +           \
                NLOHMANN_JSON_VERSION_PATCH,                                                    \
            NAME, VERSION                                                                       \
    }

/// Defines a plugin: `MATPOINT_PLUGIN("tait_water", "1.0.0") { registry.material<TaitWater>("tait_water"); }`
#define MATPOINT_PLUGIN(NAME, VERSION)                                                                \
    extern "C" __attribute__((visibility("default"))) const matpoint_abi_stamp matpoint_plugin_stamp; \
    const matpoint_abi_stamp matpoint_plugin_stamp = MATPOINT_STAMP(NAME, VERSION);                   \
    extern "C" __attribute__((visibility("default"))) void matpoint_plugin_register(                  \
        matpoint::Registry& registry);                                                                \
    void matpoint_plugin_register([[maybe_unused]] matpoint::Registry& registry)
