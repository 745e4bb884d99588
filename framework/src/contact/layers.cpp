#include "contact/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace matpoint {

namespace {

/// The contact between each pair of bodies; -1: none.
class Pairs {
  public:
    explicit Pairs(std::size_t bodies) : bodies_(bodies), contacts_(bodies * bodies, -1) {}

    int between(std::size_t a, std::size_t b) const { return contacts_[a * bodies_ + b]; }
    void set(std::size_t a, std::size_t b, std::size_t contact) {
        contacts_[a * bodies_ + b] = contacts_[b * bodies_ + a] = static_cast<int>(contact);
    }

  private:
    std::size_t bodies_;
    std::vector<int> contacts_;
};

}  // namespace

ContactLayers contact_layers(const std::vector<std::string>& bodies,
                             std::span<const std::vector<std::size_t>> between,
                             std::vector<ContactMistake>& mistakes) {
    const std::size_t n = bodies.size();
    ContactLayers layers;
    layers.layer.assign(n, 0);
    layers.count = 1;
    layers.law = {-1};
    if (std::ranges::all_of(between, [](const auto& own) { return own.empty(); })) return layers;

    Pairs pairs(n);
    for (std::size_t k = 0; k < between.size(); ++k)
        for (std::size_t i = 0; i < between[k].size(); ++i)
            for (std::size_t j = i + 1; j < between[k].size(); ++j) {
                const std::size_t a = between[k][i], b = between[k][j];
                if (a == b) {
                    mistakes.push_back({k, fmt::format("\"{}\" is named twice", bodies[a])});
                } else if (pairs.between(a, b) >= 0 && pairs.between(a, b) != static_cast<int>(k)) {
                    mistakes.push_back({k, fmt::format("\"{}\" and \"{}\" meet by contact {} already",
                                                       bodies[a], bodies[b], pairs.between(a, b))});
                } else {
                    pairs.set(a, b, k);
                }
            }
    if (!mistakes.empty()) return layers;

    std::vector<std::size_t> first;  // body of each layer
    for (std::size_t b = 0; b < n; ++b) {
        const auto own =
            std::ranges::find_if(first, [&](std::size_t other) { return pairs.between(b, other) < 0; });
        layers.layer[b] = static_cast<std::size_t>(own - first.begin());
        if (own == first.end()) first.push_back(b);
    }
    layers.count = first.size();
    layers.law.assign(layers.count * layers.count, -1);
    std::vector<std::optional<std::pair<std::size_t, std::size_t>>> example(layers.law.size());
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const int contact = pairs.between(a, b);
            const std::size_t i = layers.layer[a], j = layers.layer[b];
            if ((i != j) == (contact >= 0)) {
                if (contact < 0) continue;
                auto& known = example[i * layers.count + j];
                int& law = layers.law[i * layers.count + j];
                if (known && law != contact) {
                    mistakes.push_back(
                        {static_cast<std::size_t>(contact),
                         fmt::format("\"{}\" meets \"{}\" by this contact and \"{}\" meets \"{}\" by contact "
                                     "{}, but bodies without a contact between them move as one where they "
                                     "touch: name all of them in one contact, or one between those",
                                     bodies[b], bodies[a], bodies[known->second], bodies[known->first],
                                     law)});
                    return layers;
                }
                known = {a, b};
                law = layers.law[j * layers.count + i] = contact;
                example[j * layers.count + i] = {b, a};
                continue;
            }
            // Two bodies without contact, one of which meets a third that the other doesn't meet.
            const std::size_t third = first[contact < 0 ? std::min(i, j) : i];
            const auto says = [&](std::size_t x, std::size_t y) {
                return fmt::format("\"{}\" and \"{}\" {}", bodies[x], bodies[y],
                                   pairs.between(x, y) >= 0 ? "meet" : "move as one where they touch");
            };
            const int blame = std::max({contact, pairs.between(a, third), pairs.between(b, third)});
            mistakes.push_back(
                {static_cast<std::size_t>(std::max(blame, 0)),
                 fmt::format("{}, {}, but {}: that can't be; name \"{}\", \"{}\" and \"{}\" in "
                             "contacts between each two of them",
                             says(b, third), says(a, third), says(b, a), bodies[b], bodies[a],
                             bodies[third])});
            return layers;
        }
    return layers;
}

}  // namespace matpoint
