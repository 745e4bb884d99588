#include <matpoint/elasticity.hpp>
#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

namespace matpoint {

/// Von Mises plasticity with linear isotropic hardening and radial return on a hypoelastic trial.
template <class S>
class J2Plasticity final : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;

    explicit J2Plasticity(const Parameters& parameters)
        : Material<S>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")),
          yield_stress_(static_cast<Real>(parameters.number("yield_stress"))),
          hardening_(hardening(parameters.number("youngs_modulus"), parameters.number("tangent_modulus"))) {}

    static Schema schema() {
        Schema schema("Elastoplastic solid: von Mises yield, linear hardening, radial return",
                      "[Chen & Brannon 2002, sec. 4]; [Simo & Hughes 1998, box 3.1]");
        add_elastic_constants(schema)
            .number("yield_stress", {.unit = "Pa", .doc = "Uniaxial yield stress Y", .at_least = 0})
            .number(
                "tangent_modulus",
                {.unit = "Pa",
                 .doc = "Slope E_t of the uniaxial stress-strain curve after yield; 0 is perfectly plastic",
                 .default_value = 0.0,
                 .at_least = 0})
            .refuse("/tangent_modulus", "must be below youngs_modulus, the slope before yield",
                    [](const Json& own, const Json&) {
                        return own.value("tangent_modulus", 0.0) >= own.value("youngs_modulus", 0.0);
                    });
        return schema;
    }

    std::vector<StateVariable> state() const override { return {{"plastic_strain", 0, ""}}; }

    void update_stress(const Batch& batch, Real dt) const override {
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const auto trial = hypoelastic_stress(lame_, batch.stress(p), batch.velocity_gradient(p), dt);
            batch.set_stress(p, returned(trial, batch.state(0, p)));
        }
    }

    Real wave_speed(const Batch& batch) const override { return elastic_wave_speed(lame_, batch); }

  private:
    /// H = E E_t / (E - E_t), the slope of the yield stress over plastic strain.
    static Real hardening(double modulus, double tangent) {
        return static_cast<Real>(modulus * tangent / (modulus - tangent));
    }

    /// The trial stress brought back to q = Y + H eps_p along its deviator; raises plastic_strain. In a
    /// bar q is |sigma|, and the uniaxial modulus 2 mu = E takes the place of 3 mu.
    Tensor<S> returned(const Tensor<S>& trial, Real& plastic_strain) const {
        constexpr bool bar = S::dimension == 1;
        const Tensor<S> pressure = (bar ? Real(0) : trace(trial) / 3) * Tensor<S>::identity();
        const Tensor<S> deviator = trial - pressure;
        const Real q = std::sqrt(Real(bar ? 1 : 1.5) * contract(deviator, deviator));
        const Real excess = q - (yield_stress_ + hardening_ * plastic_strain);
        if (!(excess > 0)) return trial;  // so is what is not a number, which the run's guard reports
        plastic_strain += excess / (Real(bar ? 2 : 3) * lame_.mu + hardening_);
        return pressure + ((yield_stress_ + hardening_ * plastic_strain) / q) * deviator;
    }

    Lame<S> lame_;
    Real yield_stress_, hardening_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("j2_plasticity", "1.0.0") {
    registry.material<matpoint::J2Plasticity>("j2_plasticity");
}
