#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {
namespace {

template <class S>
class Usf final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;

    explicit Usf(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Update stress first: stress from the velocity that was projected, before the forces. Keeps "
            "energy well.",
            "[Wallstedt & Guilkey 2008, section 2, eq. 8-18]");
    }

    void step(Phases<S>& phases, Real dt) const override {
        phases.project({.velocity = true});                                      // eq. 8, 9
        phases.update({.stress = NodeField::velocity}, dt);                      // eq. 10-13
        phases.project({.internal_force = true});                                // eq. 14
        phases.accelerate(dt);                                                   // eq. 15, 16
        phases.update({.velocity = true, .position = NodeField::velocity}, dt);  // eq. 17, 18
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("usf", "1.0.0") {
    registry.integrator<matpoint::Usf>("usf");
}
