#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

#include <numbers>

namespace matpoint {
namespace {

template <class S>
class CentralDifference final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;

    explicit CentralDifference(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Staggered central difference: velocities live at half steps. The first acceleration is halved, "
            "which brings them there from time 0; of second order.",
            "[Wallstedt & Guilkey 2008, section 4, eq. 40-50]");
    }

    bool staggered() const override { return true; }

    /// Strains follow what the forces have just done to the nodes. What particles don't carry over, as of
    /// velocities that alternate between nodes, has no inertia: strain' = (1 - (omega dt)^2) strain.
    double largest_phase() const override { return std::numbers::sqrt2; }

    void step(Phases<S>& phases, Real dt) const override {
        // The first acceleration is halved: it brings velocities from time 0 to half a step [section 4].
        const Real factor = phases.step_number() == 0 ? Real(0.5) : Real(1);
        phases.project({.velocity = true, .internal_force = true});  // eq. 40, 41, 44
        phases.accelerate(dt, factor);                               // eq. 45, 47
        phases.update({.velocity = true, .position = NodeField::velocity, .stress = NodeField::velocity},
                      dt);  // eq. 46, 49, 48, 50, 42, 43
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("central_difference", "1.0.0") {
    registry.integrator<matpoint::CentralDifference>("central_difference");
}
