#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/grid.hpp>

#include <array>

namespace matpoint {

/// Particles that a body can get at most: the places in the box around its geometry, or the points that it
/// lists.
template <class S>
double most_particles(const Patch<S>& patch, const Geometry& geometry, const std::array<int, 3>& per_cell);

/// About how many it gets, without making them: what part of the box its geometry fills is sampled.
template <class S>
double expected_particles(const Patch<S>& patch, const Geometry& geometry,
                          const std::array<int, 3>& per_cell);

}  // namespace matpoint
