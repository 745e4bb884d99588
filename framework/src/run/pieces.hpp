#pragma once

#include <matpoint/shape_function.hpp>

#include "grid/levels.hpp"

#include <vector>

namespace matpoint {

/// Parts of a body that share no node of the grid, and so don't feel each other: their numbers of particles,
/// the largest first. Particles off the grid belong to none. `patch`: the nodes of the body; where the grid
/// has levels, its coarsest one tells.
template <class S>
std::vector<Index> pieces(const Levels<S>& levels, const Patch<S>& patch, const Particles<S>& particles,
                          const ShapeFunction<S>& shape);

/// How far the particles of a body lie apart where it is pulled most and along the pull, in cells: from their
/// deformation if they carry it, else from their volume alone.
template <class S>
double widest_spacing(const Patch<S>& patch, const Particles<S>& particles);

}  // namespace matpoint
