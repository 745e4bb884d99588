#include <matpoint/elasticity.hpp>
#include <matpoint/plugin.hpp>
#include <matpoint/pointwise_material.hpp>

namespace matpoint {

/// Hypoelastic: the stress follows the strain rate, and turns with the material (Jaumann rate). Or the law of
/// the linear theory: the stress follows the displacement gradient.
template <class S>
class LinearElastic final : public PointwiseMaterial<S, LinearElastic<S>> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;

    explicit LinearElastic(const Parameters& parameters)
        : PointwiseMaterial<S, LinearElastic<S>>(parameters),
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

    template <class Point>
    auto update(const Point& p, Real dt) const {
        p.set_stress(small_strain_ ? stress(symmetric(p.displacement_gradient()))
                                   : hypoelastic_stress(lame_, p.stress(), p.velocity_gradient(), dt));
        return squared_wave_speed(p);
    }
    template <class Point>
    auto squared_wave_speed(const Point& p) const {
        auto square = squared_elastic_wave_speed(lame_, p.density());
        if (small_strain_) square *= sqrt(largest_squared_stretch(p.deformation_gradient()));
        return square;
    }

    std::optional<double> stored_energy(const Batch& batch, Index p) const override {
        if (!small_strain_) return {};
        const Tensor<S> strain = symmetric(batch.displacement_gradient(p));
        return contract(stress(strain), strain) / 2;
    }

  private:
    template <class T>
    Tensor<S, T> stress(const Tensor<S, T>& strain) const {
        return (lame_.lambda * trace(strain)) * Tensor<S, T>::identity() + (2 * lame_.mu) * strain;
    }

    Lame<S> lame_;
    bool small_strain_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("linear_elastic", "1.1.0") {
    registry.material<matpoint::LinearElastic>("linear_elastic");
}
