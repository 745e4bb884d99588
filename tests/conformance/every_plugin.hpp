#pragma once

#include "registry/catalogue.hpp"

#include <string>
#include <vector>

namespace matpoint::conformance {

/// An object for each type of a kind that a plugin offers, every parameter at its default.
inline std::vector<Json> every_plugin(const std::string& kind) {
    PluginCatalogue catalogue;
    std::vector<Json> objects;
    for (const std::string& type : catalogue.types(kind)) {
        Json own{{"type", type}};
        for (const Parameter& parameter : catalogue.find(kind, type)->parameters())
            if (parameter.default_value) own[parameter.name] = *parameter.default_value;
        objects.push_back(own);
    }
    return objects;
}

}  // namespace matpoint::conformance
