#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {
namespace {

/// L = grad v*^{n+1} + (grad v^{n+1} - grad v*^n): what the projection took from the nodes' velocity between
/// two steps, which v*^n strained the particles with, is put into the strain of the next.
template <class S>
class LaggedStrain final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;

    explicit LaggedStrain(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Update stress last, with strain that follows the velocity which particles carry over, a step "
            "late: strain and position follow the same motion. Keeps the energy of what vibrates; of first "
            "order.",
            "[Matpoint, docs/theory.md]");
    }

    bool lags() const override { return true; }

    /// What particles don't carry over is strained with twice, this step and against it the next:
    /// strain' = (1 - (omega dt)^2) strain + (omega dt)^2 strain before.
    double largest_phase() const override { return 1; }

    void step(Phases<S>& phases, Real dt) const override {
        phases.project({.velocity = true});
        // The first step has no step before that anything was left of.
        if (phases.step_number() > 0) phases.update({.lag = NodeField::velocity}, dt);
        phases.project({.internal_force = true});
        phases.accelerate(dt);
        phases.update({.velocity = true, .position = NodeField::velocity, .stress = NodeField::velocity}, dt);
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("lagged_strain", "1.0.0") {
    registry.integrator<matpoint::LaggedStrain>("lagged_strain");
}
