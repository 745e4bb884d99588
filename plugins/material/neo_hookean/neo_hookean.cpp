#include <matpoint/elasticity.hpp>
#include <matpoint/plugin.hpp>
#include <matpoint/pointwise_material.hpp>

#include <cmath>

namespace matpoint {

/// Compressible neo-Hookean solid of [Wallstedt & Guilkey 2008, eq. 54, 55].
template <class S>
class NeoHookean final : public PointwiseMaterial<S, NeoHookean<S>> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;

    explicit NeoHookean(const Parameters& parameters)
        : PointwiseMaterial<S, NeoHookean<S>>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")) {}

    static Schema schema() {
        Schema schema("Neo-Hookean solid: sigma = lambda ln J / J I + mu / J (F F^T - I)",
                      "[Wallstedt & Guilkey 2008, eq. 55]");
        add_elastic_constants(schema);
        return schema;
    }

    bool uses_deformation_gradient() const override { return true; }

    template <class Point>
    auto update(const Point& p, Real) const {
        const State<typename Point::Number> state(p.displacement_gradient());
        p.set_stress(stress(state));
        return squared_wave_speed(state) * p.volume() / p.mass();
    }
    template <class Point>
    auto squared_wave_speed(const Point& p) const {
        return squared_wave_speed(State<typename Point::Number>(p.displacement_gradient())) * p.volume() /
               p.mass();
    }

    std::optional<double> stored_energy(const Batch& batch, Index p) const override {
        // In double precision: of small strains, tr H and ln J are nearly the same.
        const auto h = cast<double>(batch.displacement_gradient(p));
        const double log_j = std::log1p(volume_change(h));
        return lame_.lambda / 2 * log_j * log_j + lame_.mu * (trace(h) - log_j + contract(h, h) / 2);
    }

  private:
    template <class T>
    struct State {
        explicit State(const Tensor<S, T>& displacement_gradient) : b(squared_strain(displacement_gradient)) {
            const T growth = volume_change(displacement_gradient);
            inverse_j = T(1) / (T(1) + growth);
            log_j = log1p(growth);
        }
        Tensor<S, T> b;  ///< F F^T - I
        T inverse_j, log_j;
    };

    /// Cauchy stress [Wallstedt & Guilkey 2008, eq. 55]; eq. 28 in a bar.
    template <class T>
    Tensor<S, T> stress(const State<T>& state) const {
        return (lame_.lambda * state.log_j * state.inverse_j) * Tensor<S, T>::identity() +
               (lame_.mu * state.inverse_j) * state.b;
    }

    /// Times density, Pa: an upper bound of the eigenvalues of the acoustic tensor of any direction (README).
    template <class T>
    T squared_wave_speed(const State<T>& state) const {
        const T volumetric = lame_.lambda * (T(1) - state.log_j) + lame_.mu;
        const T stiffness = max(T(0), volumetric) + lame_.mu * (T(1) + largest_eigenvalue(state.b));
        return stiffness * state.inverse_j;
    }

    Lame<S> lame_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("neo_hookean", "1.0.0") {
    registry.material<matpoint::NeoHookean>("neo_hookean");
}
