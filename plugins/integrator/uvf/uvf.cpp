#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {
namespace {

template <class S>
class Uvf final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;

    explicit Uvf(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Update velocity first: position and velocity gradient are both taken from the updated particle "
            "velocities, projected anew.",
            "[Wallstedt & Guilkey 2008, section 4, eq. 40-51]");
    }

    std::vector<NodeField> node_fields() const override { return {NodeField::remapped_velocity}; }

    bool staggered() const override { return true; }

    void step(Phases<S>& phases, Real dt) const override {
        // The first acceleration is halved: it brings velocities from time 0 to half a step [section 4].
        const Real factor = phases.step_number() == 0 ? Real(0.5) : Real(1);
        phases.project({.velocity = true, .internal_force = true});  // eq. 40, 41, 44
        phases.accelerate(dt, factor);                               // eq. 45
        phases.update({.velocity = true}, dt);                       // eq. 46
        phases.remap();                                              // eq. 51, instead of eq. 47
        phases.update({.position = NodeField::remapped_velocity, .stress = NodeField::remapped_velocity},
                      dt);  // eq. 49, 48, 50, 42, 43
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("uvf", "1.0.0") {
    registry.integrator<matpoint::Uvf>("uvf");
}
