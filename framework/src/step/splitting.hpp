#pragma once

#include <matpoint/particles.hpp>

#include "grid/levels.hpp"

namespace matpoint {

/// Splits particles in a level that is finer than their own distance: each into 2^D that fill its deformed
/// domain, with its velocity, deformation and stress. Mass, momentum and energy are kept. The first child
/// keeps the id, the others have new ones. Sets refinement_field and level_field.
template <class S>
void split_arrived(const Levels<S>& levels, Particles<S>& particles);

}  // namespace matpoint
