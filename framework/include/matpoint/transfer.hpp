#pragma once

#include <matpoint/shape_function.hpp>

namespace matpoint {

/// How velocity goes from the particles to the grid and back.
template <class S>
class Transfer : public Component {
  public:
    using Space = S;
    using Real = typename S::Real;

    /// Asks for the particle fields that the transfer keeps.
    virtual void declare(Particles<S>&) const {}
    /// Field by which a particle extends its velocity to the nodes, v + A (x_i - x_p); none by default.
    virtual std::optional<Field> affine() const { return {}; }
    /// Whether update() reads the gathered acceleration, or the gathered affine velocity.
    virtual bool needs_acceleration() const = 0;
    virtual bool needs_affine() const { return false; }
    /// Share of a particle's velocity that is replaced by the grid's in a step: 0 for FLIP, 1 for PIC and
    /// APIC.
    virtual Real grid_share() const = 0;
    /// Terms of the series for the inverse of the full mass matrix that makes nodal velocities of momenta; 1:
    /// the lumped mass alone. More read and send Field::grid_velocity, which they need.
    virtual int order() const { return 1; }
    /// New velocity of every particle of the batch from what was gathered; dt in s.
    virtual void update(const ParticleBatch<S>& batch, Real dt) const = 0;
};

}  // namespace matpoint
