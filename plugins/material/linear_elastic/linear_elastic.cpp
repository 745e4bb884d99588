#include <matpoint/elasticity.hpp>
#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {

/// Hypoelastic: the stress follows the strain rate, and turns with the material (Jaumann rate).
template <class S>
class LinearElastic final : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;

    explicit LinearElastic(const Parameters& parameters)
        : Material<S>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")) {}

    static Schema schema() {
        Schema schema("Linear elastic solid: the stress rate is lambda tr(D) I + 2 mu D + W sigma - sigma W",
                      "[Chen & Brannon 2002, sec. 4]");
        add_elastic_constants(schema);
        return schema;
    }

    void update_stress(const Batch& batch, Real dt) const override {
        for (Index p = batch.begin(); p < batch.end(); ++p)
            batch.set_stress(p, hypoelastic_stress(lame_, batch.stress(p), batch.velocity_gradient(p), dt));
    }

    Real wave_speed(const Batch& batch) const override { return elastic_wave_speed(lame_, batch); }

  private:
    Lame<S> lame_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("linear_elastic", "1.0.0") {
    registry.material<matpoint::LinearElastic>("linear_elastic");
}
