#pragma once

#include <gtest/gtest.h>

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

/// Calls test(scene) for the scene with every shape, integrator and transfer.
template <class Test>
void with_every_scheme(Json scene, const Test& test) {
    for (const Json& shape : every_plugin("shape_function"))
        for (const Json& integrator : every_plugin("integrator"))
            for (const Json& transfer : every_plugin("transfer")) {
                SCOPED_TRACE(shape.dump() + integrator.dump() + transfer.dump());
                scene["shape_function"] = shape;
                scene["integrator"] = integrator;
                scene["transfer"] = transfer;
                test(scene);
            }
}

}  // namespace matpoint::conformance
