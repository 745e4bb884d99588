#include <matpoint/elasticity.hpp>
#include <matpoint/plugin.hpp>
#include <matpoint/pointwise_material.hpp>

namespace matpoint {

/// Von Mises plasticity with linear isotropic hardening and radial return on a hypoelastic trial.
template <class S>
class J2Plasticity final : public PointwiseMaterial<S, J2Plasticity<S>> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;

    explicit J2Plasticity(const Parameters& parameters)
        : PointwiseMaterial<S, J2Plasticity<S>>(parameters),
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

    /// The trial stress brought back to q = Y + H eps_p along its deviator; raises plastic_strain. In a
    /// bar q is |sigma|, and the uniaxial modulus 2 mu = E takes the place of 3 mu.
    template <class Point>
    auto update(const Point& p, Real dt) const {
        using T = typename Point::Number;
        constexpr bool bar = S::dimension == 1;
        const Tensor<S, T> trial = hypoelastic_stress(lame_, p.stress(), p.velocity_gradient(), dt);
        const Tensor<S, T> pressure = (bar ? T(0) : trace(trial) / T(3)) * Tensor<S, T>::identity();
        const Tensor<S, T> deviator = trial - pressure;
        const T q = sqrt(T(bar ? 1 : 1.5) * contract(deviator, deviator));
        const T before = p.state(0);
        const T excess = q - (yield_stress_ + hardening_ * before);
        const auto yields = excess > T(0);  // what is not a number does not; the run's guard reports it
        const T after =
            select(yields, before + excess / T(Real(bar ? 2 : 3) * lame_.mu + hardening_), before);
        p.set_state(0, after);
        const T share = (yield_stress_ + hardening_ * after) / q;
        p.set_stress(select(yields, pressure + share * deviator, trial));
        return squared_wave_speed(p);
    }
    template <class Point>
    auto squared_wave_speed(const Point& p) const {
        return squared_elastic_wave_speed(lame_, p.density());
    }

  private:
    /// H = E E_t / (E - E_t), the slope of the yield stress over plastic strain.
    static Real hardening(double modulus, double tangent) {
        return static_cast<Real>(modulus * tangent / (modulus - tangent));
    }

    Lame<S> lame_;
    Real yield_stress_, hardening_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("j2_plasticity", "1.0.0") {
    registry.material<matpoint::J2Plasticity>("j2_plasticity");
}
