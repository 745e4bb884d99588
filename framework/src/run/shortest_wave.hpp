#pragma once

#include <matpoint/shape_function.hpp>

#include "grid/levels.hpp"

#include <vector>

namespace matpoint {

/// omega h / c of the shortest wave that the nodes carry, velocities of +1 and -1 at every other node: h
/// times the slope that particles see, root mean square over a body where it lies worst to the nodes; of the
/// axis, body and level where that is largest. 2 with weights that are linear from node to node, less with
/// smoother ones; h is the smallest edge of a cell.
template <class S>
double shortest_wave_phase(const Levels<S>& levels, const std::vector<Particles<S>>& bodies,
                           const ShapeFunction<S>& shape);

}  // namespace matpoint
