#pragma once

#include <matpoint/grid.hpp>
#include <matpoint/registry.hpp>

#include <optional>

namespace matpoint {

/// The phases of a step, which an integrator puts in order.
template <class S>
class Phases {
  public:
    using Real = typename S::Real;

    struct Projection {
        bool velocity = false;        ///< nodal mass and velocity [Wallstedt & Guilkey 2008, eq. 8, 9]
        bool internal_force = false;  ///< nodal internal force [eq. 14]
    };
    struct Update {
        bool velocity = false;                   ///< particle velocity, by the transfer [eq. 18]
        std::optional<NodeField> position = {};  ///< position, moved with this nodal velocity [eq. 17]
        std::optional<NodeField> stress =
            {};  ///< L, F, volume and stress, from this nodal velocity [eq. 10-13]
        /// Alone: what this nodal velocity has that the last update of stress lacked, to be added to the L of
        /// the next (Integrator::lags).
        std::optional<NodeField> lag = {};
    };

    virtual long step_number() const = 0;
    /// Particles to nodes; velocities are constrained. Both in one pass if both are asked for.
    virtual void project(Projection) = 0;
    /// a = factor (f_int + f_ext) / m, v* = v + a dt [eq. 15, 16], constrained.
    virtual void accelerate(Real dt, Real factor = 1) = 0;
    /// NodeField::remapped_velocity from the updated particle velocities [eq. 51], constrained.
    virtual void remap() = 0;
    /// Nodes to particles, in one pass.
    virtual void update(Update, Real dt) = 0;

  protected:
    ~Phases() = default;
};

/// The order of the phases of a step; reads like the paper.
template <class S>
class Integrator : public Component {
  public:
    using Space = S;
    using Real = typename S::Real;

    /// Node fields beyond mass, velocity, force and acceleration.
    virtual std::vector<NodeField> node_fields() const { return {}; }
    /// Whether velocities are those of half steps: prescribed ones are then taken at these times.
    virtual bool staggered() const { return false; }
    /// Whether particles remember the gradient that their stress was updated with, for Update::lag.
    virtual bool lags() const { return false; }
    /// Largest omega dt with which the fastest vibration of the nodes stays bounded; that of the leapfrog by
    /// default. The guard of the time step asks.
    virtual double largest_phase() const { return 2; }
    /// Advances everything by dt (s).
    virtual void step(Phases<S>& phases, Real dt) const = 0;
};

}  // namespace matpoint
