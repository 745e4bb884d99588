#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/grid.hpp>
#include <matpoint/particles.hpp>

#include "grid/level_fields.hpp"
#include "grid/levels.hpp"
#include "particles/filled_places.hpp"

#include <array>
#include <functional>

namespace matpoint {

/// Velocity of a body at a point at the start, m/s.
using InitialVelocity = std::function<Eigen::Vector3d(const Eigen::Vector3d& position)>;

/// Fills a body that has no particles yet: on a lattice with `particles_per_cell` places in every cell of the
/// grid, cell by cell; or, if the geometry is a list of points, with these. Only the part of a region within
/// the grid is filled; a listed point must be in it. `density` in kg/m^3; without `velocity` the body is at
/// rest. Sets position, velocity, volume, mass, and those of initial_position, half_size, initial_half_size
/// and id that were asked for. Throws std::invalid_argument that names the body if it gets no particle, or a
/// listed point is outside the grid.
template <class S>
void seed(Particles<S>& particles, const Patch<S>& patch, const Geometry& geometry,
          const std::array<int, 3>& particles_per_cell, double density, const InitialVelocity& velocity = {},
          Seeding seeding = Seeding::filled);

/// The same on nested levels: each cell gets that many particles of the level that it belongs to. A listed
/// point counts as one of its level. Sets refinement_field and level_field too.
template <class S>
void seed(Particles<S>& particles, const Levels<S>& levels, const Geometry& geometry,
          const std::array<int, 3>& particles_per_cell, double density, const InitialVelocity& velocity = {},
          Seeding seeding = Seeding::filled);

}  // namespace matpoint
