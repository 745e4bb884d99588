#include <matpoint/pointwise_material.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>

using namespace matpoint;

/// Weakly compressible fluid without viscosity; see README.md for the equations.
template <class Space>
class {{Name}} final : public PointwiseMaterial<Space, {{Name}}<Space>> {
  public:
    using Real = typename Space::Real;
    using Batch = ParticleBatch<Space>;

    static Schema schema() {
        return Schema("Weakly compressible fluid, p = K/gamma (J^-gamma - 1)", "[Murnaghan 1944]")
            .number("bulk_modulus", {.unit = "Pa", .doc = "K, resistance to compression", .greater_than = 0})
            .number("exponent", {.doc = "gamma; 7 for water", .default_value = 7, .greater_than = 1});
    }

    explicit {{Name}}(const Parameters& parameters)
        : PointwiseMaterial<Space, {{Name}}<Space>>(parameters),
          rho0_(Real(parameters.number("density"))),
          K_(Real(parameters.number("bulk_modulus"))),
          gamma_(Real(parameters.number("exponent"))) {}

    template <class Point>
    auto update(const Point& p, Real) const {
        const auto speed = squared_wave_speed(p);  // first: what it shares with the stress is computed once then
        const auto J = rho0_ / p.density();
        const auto pressure = K_ / gamma_ * (pow(J, -gamma_) - 1);  // Pa
        p.set_stress(-pressure * Tensor<Space, typename Point::Number>::identity());
        return speed;
    }

    /// c^2 = dp/drho = K/rho0 J^(1 - gamma)
    template <class Point>
    auto squared_wave_speed(const Point& p) const {
        return K_ / rho0_ * pow(rho0_ / p.density(), 1 - gamma_);
    }

    /// W with dW/dJ = -p and W(1) = 0
    std::optional<double> stored_energy(const Batch& batch, Index p) const override {
        const double J = rho0_ / batch.density(p), K = K_, gamma = gamma_;
        return K / gamma * (std::pow(J, 1 - gamma) / (gamma - 1) + J) - K / (gamma - 1);
    }

  private:
    Real rho0_, K_, gamma_;  // kg/m^3 (a parameter that every material has), Pa, 1
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.material<{{Name}}>("{{name}}"); }
