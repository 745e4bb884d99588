#include <matpoint/registry.hpp>

#include <stdexcept>

namespace matpoint {

void Registry::add(Entry entry) {
    const auto [position, added] = entries_.try_emplace({entry.kind, entry.type}, entry);
    if (added) return;
    const Entry& first = position->second;
    throw std::runtime_error(entry.kind + " \"" + entry.type + "\" is registered twice: by plugin \"" +
                             first.plugin + "\" " + first.version + " and by plugin \"" + entry.plugin +
                             "\" " + entry.version);
}

const Registry::Entry* Registry::find(const std::string& kind, const std::string& type) const {
    const auto position = entries_.find({kind, type});
    return position == entries_.end() ? nullptr : &position->second;
}

void Registry::set_current_plugin(std::string name, std::string version) {
    plugin_ = std::move(name);
    version_ = std::move(version);
}

std::shared_ptr<Component> Registry::make_component(const std::string& kind, const Json& own,
                                                    const Parameters::Context& context,
                                                    const std::string& pointer) const {
    const std::string type = own.at("type").get<std::string>();
    const Entry* entry = find(kind, type);
    if (!entry) throw std::logic_error("no " + kind + " \"" + type + "\" in the registry");
    const Origin origin{kind, type, entry->plugin, entry->version, pointer};
    const Factory& make = entry->make[static_cast<std::size_t>(context.space.index())];
    std::shared_ptr<Component> component;
    try {
        component = make(Parameters(own, context, pointer));
    } catch (const std::invalid_argument&) {
        throw;
    } catch (...) {
        throw_failure(origin, "constructor");
    }
    component->origin_ = origin;
    return component;
}

}  // namespace matpoint
