#pragma once

#include "registry/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace matpoint::conformance {

/// The component that `own` describes, from its plugin.
template <class C>
std::shared_ptr<C> make(const std::string& kind, const Json& own) {
    PluginCatalogue catalogue;
    if (!catalogue.find(kind, own.at("type").get<std::string>()))
        throw std::runtime_error("no plugin for " + own.dump());
    const Parameters::Context context{SpaceId::of<typename C::Space>(), ".", &catalogue.registry(), nullptr};
    return catalogue.registry().make<C>(kind, own, context);
}

inline Schema schema_of(const std::string& kind, const std::string& type) {
    PluginCatalogue catalogue;
    const Schema* schema = catalogue.find(kind, type);
    if (!schema) throw std::runtime_error("no plugin for " + kind + " " + type);
    return *schema;
}

/// Whether a rule about the parameter at `pointer` refuses the object, or warns about it.
inline bool has_rule(const Schema& schema, bool refuses, const std::string& pointer, const Json& own,
                     const Json& scene = {{"space", {{"dimension", 2}}}}) {
    return std::any_of(schema.rules().begin(), schema.rules().end(), [&](const Rule& rule) {
        return rule.refuses == refuses && rule.pointer == pointer && rule.applies(own, scene);
    });
}

}  // namespace matpoint::conformance
