#pragma once

#include <matpoint/exact_solution.hpp>
#include <matpoint/particles.hpp>

#include <Eigen/Core>

#include <functional>

namespace matpoint {

/// A field of velocity gradients, from differences of the velocity at the start: exact for linear fields.
template <class S>
void set_initial_gradient(Particles<S>& particles, Field field,
                          const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& velocity,
                          double cell_size);

/// What the scene's exact solution says of the bodies at time 0. Their geometries are the reference
/// configuration.
template <class S>
void start_exactly(const ExactSolution& solution, Particles<S>& particles);

/// L = dv/dX F^-1 at time 0, from differences of v over `reach`, m.
template <class S>
void set_exact_gradient(const ExactSolution& solution, Particles<S>& particles, Field field, double reach);

}  // namespace matpoint
