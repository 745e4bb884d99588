#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {
namespace {

template <class S>
class Musl final : public Integrator<S> {
  public:
    using typename Integrator<S>::Real;

    explicit Musl(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Modified update stress last: the velocity gradient is taken from the updated particle "
            "velocities, projected anew. Robust where nodes carry little mass.",
            "[Wallstedt & Guilkey 2008, eq. 8-18, 51 for the gradient]");
    }

    std::vector<NodeField> node_fields() const override { return {NodeField::remapped_velocity}; }

    void step(Phases<S>& phases, Real dt) const override {
        phases.project({.velocity = true, .internal_force = true});  // eq. 8, 9, 14
        phases.accelerate(dt);                                       // eq. 15, 16
        phases.update({.velocity = true}, dt);                       // eq. 18
        phases.remap();                                              // eq. 51
        phases.update({.position = NodeField::velocity, .stress = NodeField::remapped_velocity},
                      dt);  // eq. 17, 10-13
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("musl", "1.0.0") {
    registry.integrator<matpoint::Musl>("musl");
}
