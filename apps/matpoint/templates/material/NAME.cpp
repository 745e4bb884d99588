#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>

using namespace matpoint;

/// Weakly compressible fluid without viscosity; see README.md for the equations.
template <class Space>
class {{Name}} final : public Material<Space> {
  public:
    using Real = typename Space::Real;
    using Batch = ParticleBatch<Space>;

    static Schema schema() {
        return Schema("Weakly compressible fluid, p = K/gamma (J^-gamma - 1)", "[Murnaghan 1944]")
            .number("bulk_modulus", {.unit = "Pa", .doc = "K, resistance to compression", .greater_than = 0})
            .number("exponent", {.doc = "gamma; 7 for water", .default_value = 7, .greater_than = 1});
    }

    explicit {{Name}}(const Parameters& parameters)
        : Material<Space>(parameters),
          rho0_(Real(parameters.number("density"))),
          K_(Real(parameters.number("bulk_modulus"))),
          gamma_(Real(parameters.number("exponent"))) {}

    void update_stress(const Batch& batch, Real) const override {
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Real J = rho0_ / batch.density(p);
            const Real pressure = K_ / gamma_ * (std::pow(J, -gamma_) - 1);  // Pa
            batch.set_stress(p, -pressure * Tensor<Space>::identity());
        }
    }

    /// c^2 = dp/drho = K/rho0 J^(1 - gamma)
    Real wave_speed(const Batch& batch) const override {
        Real largest = 0;
        for (Index p = batch.begin(); p < batch.end(); ++p)
            largest = std::max(largest, std::pow(rho0_ / batch.density(p), 1 - gamma_));
        return std::sqrt(K_ / rho0_ * largest);
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
