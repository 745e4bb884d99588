#include "run/make_placed.hpp"

#include <algorithm>
#include <numeric>

namespace matpoint {

namespace {

/// Bodies that a law between them names, in the scene's order; "all" is every one.
std::vector<std::size_t> bodies_between(const Json& contact, const std::vector<std::string>& names) {
    std::vector<std::size_t> bodies;
    for (const Json& body : contact.at("between")) {
        const auto place = std::ranges::find(names, body.get<std::string>());
        if (place != names.end()) {
            bodies.push_back(static_cast<std::size_t>(place - names.begin()));
            continue;
        }
        bodies.resize(names.size());
        std::iota(bodies.begin(), bodies.end(), std::size_t{0});
        break;
    }
    return bodies;
}

}  // namespace

template <class S>
void make_conditions(Maker& maker, std::vector<PlacedCondition<S>>& conditions) {
    const Json& all = maker.json("/boundary_conditions");
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string pointer = "/boundary_conditions/" + std::to_string(k);
        PlacedCondition<S> placed;
        placed.name = all[k].value("name", "");
        placed.condition = maker.make<BoundaryCondition<S>>("boundary_condition", pointer);
        if (const Json& on = all[k].at("on"); on.contains("body")) {
            const Json& bodies = maker.json("/bodies");
            placed.part.emplace();
            placed.part->body = static_cast<std::size_t>(
                std::distance(bodies.begin(), bodies.find(on.at("body").get<std::string>())));
            if (on.contains("within"))
                placed.part->within = maker.make<Geometry>("geometry", pointer + "/on/within");
        } else if (on.is_object()) {
            placed.region = maker.make<Geometry>("geometry", pointer + "/on");
        } else {
            placed.faces = all[k].at("on").get<std::vector<std::string>>();
        }
        conditions.push_back(std::move(placed));
    }
}

template <class S>
void make_contacts(Maker& maker, Components<S>& components) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : maker.json("/bodies").items()) names.push_back(name);
    std::vector<std::vector<std::size_t>> between;
    const Json& all = maker.json("/contacts");
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string pointer = "/contacts/" + std::to_string(k);
        PlacedContact<S> placed;
        placed.name = all[k].at("name").get<std::string>();
        placed.contact = maker.make<Contact<S>>("contact", pointer);
        if (all[k].contains("between")) {
            placed.rule = PairRule::of(all[k]);
            placed.bodies = bodies_between(all[k], names);
            if (placed.bodies.size() < 2)
                maker.mistake(pointer + "/between", "a contact is between two or more bodies");
        } else if (placed.contact && placed.contact->law()) {
            maker.mistake(pointer, "a law between bodies declares their parameters: declare_pair(schema)");
        }
        between.push_back(placed.bodies);
        components.contacts.push_back(std::move(placed));
    }
    std::vector<ContactMistake> mistakes;
    components.layers = contact_layers(names, between, mistakes);
    for (const ContactMistake& mistake : mistakes)
        maker.mistake("/contacts/" + std::to_string(mistake.contact) + "/between", mistake.text);
}

void make_outputs(Maker& maker, std::vector<ScheduledOutput>& outputs) {
    const Json& all = maker.json("/outputs");
    for (std::size_t k = 0; k < all.size(); ++k) {
        ScheduledOutput scheduled;
        scheduled.output = maker.make<Output>("output", "/outputs/" + std::to_string(k));
        scheduled.type = all[k].at("type").get<std::string>();
        scheduled.every = all[k].value("every", 0.0);
        scheduled.every_steps = all[k].value("every_steps", 0L);
        outputs.push_back(std::move(scheduled));
    }
}

#define MATPOINT_INSTANTIATE(S)                                                 \
    template void make_conditions<S>(Maker&, std::vector<PlacedCondition<S>>&); \
    template void make_contacts<S>(Maker&, Components<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
