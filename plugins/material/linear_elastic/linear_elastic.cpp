#include <matpoint/elasticity.hpp>
#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

namespace matpoint {

/// Hypoelastic: the stress follows the strain rate, and turns with the material (Jaumann rate). Or the law of
/// the linear theory: the stress follows the displacement gradient.
template <class S>
class LinearElastic final : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;

    explicit LinearElastic(const Parameters& parameters)
        : Material<S>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")),
          small_strain_(parameters.text("strain") == "small") {}

    static Schema schema() {
        Schema schema("Linear elastic solid: the stress rate is lambda tr(D) I + 2 mu D + W sigma - sigma W",
                      "[Chen & Brannon 2002, sec. 4]");
        add_elastic_constants(schema);
        schema.choice("strain",
                      {.doc = "rate: for any rotation; small: sigma = lambda tr(eps) I + 2 mu eps with "
                              "eps = sym(F) - I, for small rotations (in a bar E (F - 1))",
                       .default_value = "rate",
                       .choices = {"rate", "small"}});
        return schema;
    }

    bool uses_deformation_gradient() const override { return small_strain_; }

    void update_stress(const Batch& batch, Real dt) const override {
        if (small_strain_) {
            for (Index p = batch.begin(); p < batch.end(); ++p)
                batch.set_stress(p, stress(small_strain(batch, p)));
        } else {
            for (Index p = batch.begin(); p < batch.end(); ++p)
                batch.set_stress(p,
                                 hypoelastic_stress(lame_, batch.stress(p), batch.velocity_gradient(p), dt));
        }
    }

    Real wave_speed(const Batch& batch) const override {
        if (!small_strain_) return elastic_wave_speed(lame_, batch);
        Real fastest = 0;
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Real stretch = std::sqrt(largest_squared_stretch(batch.deformation_gradient(p)));
            const Real square = stretch * (lame_.lambda + 2 * lame_.mu) / batch.density(p);
            if (square > fastest) fastest = square;  // false for what is not a number
        }
        return std::sqrt(fastest);
    }

    std::optional<double> stored_energy(const Batch& batch, Index p) const override {
        if (!small_strain_) return {};
        const Tensor<S> strain = small_strain(batch, p);
        return contract(stress(strain), strain) / 2;
    }

  private:
    static Tensor<S> small_strain(const Batch& batch, Index p) {
        return symmetric(batch.deformation_gradient(p)) - Tensor<S>::identity();
    }
    Tensor<S> stress(const Tensor<S>& strain) const {
        return (lame_.lambda * trace(strain)) * Tensor<S>::identity() + (2 * lame_.mu) * strain;
    }

    Lame<S> lame_;
    bool small_strain_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("linear_elastic", "1.1.0") {
    registry.material<matpoint::LinearElastic>("linear_elastic");
}
