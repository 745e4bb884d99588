#pragma once

#include "run/exact_error.hpp"
#include "run/simulation.hpp"
#include "step/engine.hpp"

namespace matpoint {

/// A scene's components and seeded bodies, ready for the first step.
template <class S>
struct Assembly {
    Components<S> components;
    std::vector<Particles<S>> bodies;
    std::vector<int> first_states;  ///< slot of each body's first material state variable
    std::vector<SeededBody> seeded;
    std::vector<ScheduledOutput> outputs;
    std::optional<ExactError<S>> error;  ///< if the scene has an exact solution
    std::vector<std::string> warnings;   ///< of the scene and of what it is made into
};

/// Makes a scene's components, gives particles the fields that these ask for, and seeds the bodies.
/// Throws InputError.
template <class S>
Assembly<S> assemble(const Scene& scene, const Registry& registry);

}  // namespace matpoint
