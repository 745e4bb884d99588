// No stress, at no cost: what a step takes beside its material.
#include <matpoint/elasticity.hpp>
#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

using namespace matpoint;

template <class Space>
class IdleRubber final : public Material<Space> {
  public:
    using Real = typename Space::Real;
    using Batch = ParticleBatch<Space>;

    static Schema schema() {
        Schema schema("No stress, whatever the strain");
        return add_elastic_constants(schema);
    }
    explicit IdleRubber(const Parameters& parameters) : Material<Space>(parameters) {}

    bool uses_deformation_gradient() const override { return true; }
    void update_stress(const Batch&, Real) const override {}
    Real wave_speed(const Batch&) const override { return 1; }
};

MATPOINT_PLUGIN("idle_rubber", "1.0.0") {
    registry.material<IdleRubber>("idle_rubber");
}
