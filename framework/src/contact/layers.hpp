#pragma once

#include <span>
#include <string>
#include <vector>

namespace matpoint {

/// Which bodies share a velocity field, and which contact parts those that don't.
struct ContactLayers {
    std::vector<std::size_t> layer;  ///< by body, from 0
    std::size_t count = 0;
    std::vector<int> law;  ///< by pair of layers: index of a contact; -1: none, of a layer with itself

    int law_between(std::size_t a, std::size_t b) const { return law[a * count + b]; }
};

/// What is wrong with the contacts of a scene, and which to blame.
struct ContactMistake {
    std::size_t contact;
    std::string text;
};

/// `between`, by contact: the bodies that meet each other (empty: a tool). Bodies that no contact is between
/// share a layer; that must hold for all of a layer alike. Adds what is wrong to `mistakes`.
ContactLayers contact_layers(const std::vector<std::string>& bodies,
                             std::span<const std::vector<std::size_t>> between,
                             std::vector<ContactMistake>& mistakes);

}  // namespace matpoint
