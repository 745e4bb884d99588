#include <matpoint/integrator.hpp>
#include <matpoint/plugin.hpp>

using namespace matpoint;

/// Update stress last: the stress follows from the velocities at the end of the step; see README.md.
template <class Space>
class {{Name}} final : public Integrator<Space> {
  public:
    using Real = typename Space::Real;

    static Schema schema() { return Schema("Update stress last", "[Sulsky et al. 1994]"); }
    explicit {{Name}}(const Parameters&) {}

    void step(Phases<Space>& phases, Real dt) const override {
        phases.project({.velocity = true, .internal_force = true});
        phases.accelerate(dt);
        phases.update({.velocity = true, .position = NodeField::velocity, .stress = NodeField::velocity}, dt);
    }
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.integrator<{{Name}}>("{{name}}"); }
