#include <matpoint/elasticity.hpp>
#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>

namespace matpoint {

/// Compressible neo-Hookean solid of [Wallstedt & Guilkey 2008, eq. 54, 55].
template <class S>
class NeoHookean final : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;

    explicit NeoHookean(const Parameters& parameters)
        : Material<S>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")) {}

    static Schema schema() {
        Schema schema("Neo-Hookean solid: sigma = lambda ln J / J I + mu / J (F F^T - I)",
                      "[Wallstedt & Guilkey 2008, eq. 55]");
        add_elastic_constants(schema);
        return schema;
    }

    bool uses_deformation_gradient() const override { return true; }

    void update_stress(const Batch& batch, Real) const override {
        for (Index p = batch.begin(); p < batch.end(); ++p)
            batch.set_stress(p, stress(lame_, batch.deformation_gradient(p)));
    }

    Real wave_speed(const Batch& batch) const override {
        Real fastest = 0;
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Tensor<S> f = batch.deformation_gradient(p);
            const Real square = stiffness(lame_, f) / (determinant(f) * batch.density(p));
            if (square > fastest) fastest = square;  // false for what is not a number
        }
        return std::sqrt(fastest);
    }

    std::optional<double> stored_energy(const Batch& batch, Index p) const override {
        const Tensor<S> f = batch.deformation_gradient(p);
        const double log_j = std::log(static_cast<double>(determinant(f)));
        const auto one = Tensor<S>::identity();
        const double stretch = contract(f - one, f + one);  // tr(F F^T) - tr(I), without cancellation
        return lame_.lambda / 2 * log_j * log_j - lame_.mu * log_j + lame_.mu / 2 * stretch;
    }

  private:
    /// Cauchy stress [Wallstedt & Guilkey 2008, eq. 55]; eq. 28 in a bar.
    static Tensor<S> stress(const Lame<S>& lame, const Tensor<S>& f) {
        const auto one = Tensor<S>::identity();
        const Real j = determinant(f);
        return (lame.lambda * std::log(j) / j) * one + (lame.mu / j) * (f * transpose(f) - one);
    }

    /// Upper bound of J times the eigenvalues of the acoustic tensor of any direction, Pa (README).
    static Real stiffness(const Lame<S>& lame, const Tensor<S>& f) {
        const Real volumetric = lame.lambda * (1 - std::log(determinant(f))) + lame.mu;
        return std::max(Real(0), volumetric) + lame.mu * largest_squared_stretch(f);
    }

    Lame<S> lame_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("neo_hookean", "1.0.0") {
    registry.material<matpoint::NeoHookean>("neo_hookean");
}
