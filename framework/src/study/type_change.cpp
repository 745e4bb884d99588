#include "study/type_change.hpp"

#include "config/kinds.hpp"

#include <algorithm>

namespace matpoint {
namespace {

constexpr std::string_view type_key = "/type";

/// The kind of the component at a pointer: of the section "/integrator", or an item of it "/loads/0".
const Kind* kind_at(const std::string& pointer) {
    const std::string section = pointer.substr(1, pointer.find('/', 1) - 1);
    if (std::ranges::count(pointer, '/') > 2) return nullptr;
    const auto found = std::ranges::find(kinds(), section, &Kind::section);
    return found == kinds().end() ? nullptr : &*found;
}

}  // namespace

Setting without_leftovers(const Setting& setting, const Json& scene, Catalogue& catalogue) {
    if (!setting.pointer.ends_with(type_key) || !setting.value.is_string()) return setting;
    const std::string component = setting.pointer.substr(0, setting.pointer.size() - type_key.size());
    const Json::json_pointer at(component);
    if (component.empty() || !scene.contains(at) || !scene.at(at).is_object()) return setting;
    const Json& old = scene.at(at);
    const Kind* kind = kind_at(component);
    const Schema* type = kind ? catalogue.find(kind->name, setting.value.get<std::string>()) : nullptr;
    if (!type || old.value("type", Json()) == setting.value) return setting;

    Json changed{{"type", setting.value}};
    for (const Parameter* parameter : parameters_of(*kind, *type))
        if (old.contains(parameter->name)) changed[parameter->name] = old.at(parameter->name);
    return {component, changed, setting.from};
}

}  // namespace matpoint
