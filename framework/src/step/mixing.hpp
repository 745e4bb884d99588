#pragma once

#include "step/ordering.hpp"

namespace matpoint {

/// Puts the particles of a range in the order of the cells that their stencils begin in, if a look at some of
/// them says that neighbours no longer share cells as they could. The loops treat those together that do.
template <class S>
void sort_if_mixed(const Patch<S>& patch, Particles<S>& particles, const BlockRange& range,
                   const ShapeFunction<S>& shape);

}  // namespace matpoint
