#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

#include <numbers>

namespace matpoint {
namespace {

template <class S>
class Usavg final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;

    explicit Usavg(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Update stress averaged: half of the step's strain from the velocity that was projected, half "
            "from "
            "the one that the forces have changed. Keeps energy well, at the cost of a pass more.",
            "[Nairn 2003, Material point method calculations with explicit cracks, section 2]");
    }

    /// Half of the strain follows what the forces have just done: strain' = (1 - (omega dt)^2 / 2) strain of
    /// what particles don't carry over.
    double largest_phase() const override { return 2; }

    void step(Phases<S>& phases, Real dt) const override {
        phases.project({.velocity = true});
        phases.update({.stress = NodeField::velocity}, dt / 2);
        phases.project({.internal_force = true});
        phases.accelerate(dt);
        phases.update({.stress = NodeField::velocity}, dt / 2);
        phases.update({.velocity = true, .position = NodeField::velocity}, dt);
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("usavg", "1.0.0") {
    registry.integrator<matpoint::Usavg>("usavg");
}
