#pragma once

#include "config/catalogue.hpp"
#include "config/kinds.hpp"

#include <string>
#include <vector>

namespace matpoint {

/// One component, for people and for programs: what it is, its paper, its parameters, its misfits.
std::string describe_text(const Kind& kind, const std::string& type, const Schema& schema);
Json describe_json(const Kind& kind, const std::string& type, const Schema& schema);

/// A kind: what it chooses, the types there are, the parameters they share. Opens no plugin.
std::string describe_text(const Kind& kind, const Catalogue& catalogue);
Json describe_json(const Kind& kind, const Catalogue& catalogue);

/// The keys of a scene: all, those that choose no component, and one.
std::string describe_scene_text();
Json describe_scene_json();
std::vector<const Parameter*> own_keys();
std::string describe_text(const Parameter& key);
Json describe_json(const Parameter& key);

}  // namespace matpoint
