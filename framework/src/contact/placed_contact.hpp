#pragma once

#include <matpoint/contact.hpp>

#include <memory>
#include <string>
#include <vector>

namespace matpoint {

/// How the direction and the distance between two bodies at a node are found.
struct PairRule {
    enum class Normal { average, regression, fixed };
    enum class Gap { moment, particles, none };

    Normal normal = Normal::average;
    Eigen::Vector3d fixed = Eigen::Vector3d::Zero();
    Gap gap = Gap::moment;

    /// Of the resolved object of a law between bodies.
    static PairRule of(const Json& law);
};

/// A contact of a scene and the bodies that it holds for.
template <class S>
struct PlacedContact {
    std::string name;
    std::shared_ptr<Contact<S>> contact;
    std::vector<std::size_t> bodies;  ///< in the order of the scene's `between`
    PairRule rule;
};

}  // namespace matpoint
