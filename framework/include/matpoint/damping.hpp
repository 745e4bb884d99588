#pragma once

#include <matpoint/registry.hpp>

#include <span>

namespace matpoint {

/// What leads a scene to rest: a resistance to the motion of the nodes, or a stop of all motion. The kernel
/// counts the energy that it takes.
template <class S>
class Damping : public Component {
  public:
    using Space = S;
    using Real = typename S::Real;

    /// What a component of nodes' velocity (m/s) is slowed down by: out, m/s^2, from their acceleration by
    /// all other forces and the step's length dt (s). Nothing by default.
    virtual void resist(std::span<const Real> velocity, std::span<const Real> acceleration, Real dt,
                        std::span<Real> out) const;
    /// Whether all motion stops at the end of a step that has changed the kinetic energy (J) so. Never by
    /// default.
    virtual bool stops(double energy_before, double energy) const;
};

template <class S>
void Damping<S>::resist(std::span<const Real>, std::span<const Real>, Real, std::span<Real> out) const {
    for (Real& slowed : out) slowed = 0;
}

template <class S>
bool Damping<S>::stops(double, double) const {
    return false;
}

}  // namespace matpoint
