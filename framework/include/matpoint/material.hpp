#pragma once

#include <matpoint/particles.hpp>
#include <matpoint/registry.hpp>

namespace matpoint {

/// A constitutive model. The kernel has updated F (where used) and V before it calls update_stress.
template <class S>
class Material : public Component {
  public:
    using Space = S;
    using Real = typename S::Real;
    using Batch = ParticleBatch<S>;

    /// Density at the start, kg/m^3 (a parameter of every material).
    explicit Material(const Parameters& parameters) : density_(parameters.number("density")) {}
    double density() const { return density_; }

    /// Variables of its own that particles carry; none by default.
    virtual std::vector<StateVariable> state() const { return {}; }
    virtual bool uses_deformation_gradient() const { return false; }

    /// New Cauchy stress of every particle of the batch, at the end of a step of length dt (s).
    virtual void update_stress(const Batch& batch, Real dt) const = 0;
    /// Largest speed of sound in the batch in its present state, m/s, for the automatic time step; 0 if the
    /// material has no stiffness. What is negative or not finite ends the run.
    virtual Real wave_speed(const Batch& batch) const = 0;
    /// Both, in this order, in one call.
    virtual Real update(const Batch& batch, Real dt) const {
        update_stress(batch, dt);
        return wave_speed(batch);
    }
    /// Energy stored by particle p per unit of initial volume, J/m^3; empty if the model has none.
    virtual std::optional<double> stored_energy(const Batch&, Index) const { return {}; }

  private:
    double density_;
};

}  // namespace matpoint
