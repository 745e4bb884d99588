#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

#include <numbers>

namespace matpoint {
namespace {

template <class S>
class Usl final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;

    explicit Usl(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Update stress last: stress from the velocity that the forces have changed. Damps what the grid "
            "does not resolve.",
            "[Wallstedt & Guilkey 2008, section 2, eq. 8-19]");
    }

    /// Strains follow what the forces have just done to the nodes. What particles don't carry over, as of
    /// velocities that alternate between nodes, has no inertia: strain' = (1 - (omega dt)^2) strain.
    double largest_phase() const override { return std::numbers::sqrt2; }

    void step(Phases<S>& phases, Real dt) const override {
        phases.project({.velocity = true, .internal_force = true});  // eq. 8, 9, 14
        phases.accelerate(dt);                                       // eq. 15, 16
        phases.update({.velocity = true, .position = NodeField::velocity, .stress = NodeField::velocity},
                      dt);  // eq. 17-19, 11-13
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("usl", "1.0.0") {
    registry.integrator<matpoint::Usl>("usl");
}
