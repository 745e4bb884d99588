#pragma once

#include <matpoint/particles.hpp>
#include <matpoint/schema.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace matpoint {

/// Lamé constants, Pa. A bar (1D) has free sides: lambda = 0 and mu = E/2 make its stress uniaxial,
/// sigma = E epsilon, and turn [Wallstedt & Guilkey 2008, eq. 55] into their eq. 28.
template <class S>
struct Lame {
    using Real = typename S::Real;

    Lame(double youngs_modulus, double poissons_ratio) {
        const double e = youngs_modulus, nu = poissons_ratio;
        if constexpr (S::dimension == 1) {
            lambda = 0;
            mu = static_cast<Real>(e / 2);
        } else {
            lambda = static_cast<Real>(e * nu / ((1 + nu) * (1 - 2 * nu)));
            mu = static_cast<Real>(e / (2 * (1 + nu)));
        }
    }

    Real lambda, mu;
};

/// Whether the scene is one-dimensional; for the rules of schemas.
inline bool is_bar(const Json& scene) {
    return scene.contains("space") && scene.at("space").value("dimension", 0) == 1;
}

/// Declares `youngs_modulus` and `poissons_ratio`.
inline Schema& add_elastic_constants(Schema& schema) {
    return schema.number("youngs_modulus", {.unit = "Pa", .doc = "Young's modulus E", .at_least = 0})
        .number("poissons_ratio",
                {.doc = "Poisson's ratio nu", .default_value = 0.0, .greater_than = -1, .less_than = 0.5})
        .warn("/poissons_ratio",
              "has no effect in 1D, where a bar's sides are free and its stress is uniaxial",
              [](const Json& own, const Json& scene) {
                  return is_bar(scene) && own.value("poissons_ratio", 0.0) != 0;
              });
}

/// The stress carried along by the spin W = skew L of a step: Q sigma Q^T with the rotation
/// Q = (I - A)^-1 (I + A), A = W dt/2, of [Hughes & Winget 1980]. It integrates W sigma - sigma W to
/// second order and keeps the stress's invariants whatever the step.
template <class S>
Tensor<S> rotated_stress(const Tensor<S>& stress, const Tensor<S>& velocity_gradient, typename S::Real dt) {
    if constexpr (S::dimension == 1) {
        return stress;
    } else {
        using Real = typename S::Real;
        const Tensor<S> a = (dt / 2) * skew(velocity_gradient);
        // Closed form of the inverse: A^3 = -|a|^2 A, where |a|^2 = A:A / 2.
        const Tensor<S> q = Tensor<S>::identity() + (Real(2) / (Real(1) + contract(a, a) / 2)) * (a + a * a);
        return q * stress * transpose(q);
    }
}

/// Stress after a step of dt (s) with the Jaumann rate lambda tr(D) I + 2 mu D + W sigma - sigma W.
template <class S>
Tensor<S> hypoelastic_stress(const Lame<S>& lame, const Tensor<S>& stress, const Tensor<S>& velocity_gradient,
                             typename S::Real dt) {
    const Tensor<S> strain = dt * symmetric(velocity_gradient);
    return rotated_stress(stress, velocity_gradient, dt) +
           (lame.lambda * trace(strain)) * Tensor<S>::identity() + (2 * lame.mu) * strain;
}

/// Largest sqrt((lambda + 2 mu) / rho) of a batch, m/s; sqrt(E / rho) in a bar.
template <class S>
typename S::Real elastic_wave_speed(const Lame<S>& lame, const ParticleBatch<S>& batch) {
    using Real = typename S::Real;
    Real density = std::numeric_limits<Real>::max();
    for (Index p = batch.begin(); p < batch.end(); ++p) density = std::min(density, batch.density(p));
    return std::sqrt((lame.lambda + 2 * lame.mu) / density);
}

}  // namespace matpoint
