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

/// The stress carried along by the spin W = skew L of the middle of a step: Q sigma Q^T with the rotation
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

/// L (I + L dt/2)^-1, the gradient with respect to the middle of a step from where L was taken by I + L dt.
/// It changes its sign if the step is taken back, and of a rotation it is the spin alone. L itself has a
/// strain of L^2 dt^2 / 2 too much, always with the same sign, which every vibration and every turn would
/// leave behind.
template <class S>
Tensor<S> midstep_gradient(const Tensor<S>& velocity_gradient, typename S::Real dt) {
    const Tensor<S> half = Tensor<S>::identity() + (dt / 2) * velocity_gradient;
    Tensor<S> middle;
    middle.plane.noalias() = velocity_gradient.plane * half.plane.inverse();
    if constexpr (S::has_normal) middle.normal = velocity_gradient.normal / half.normal;
    return middle;
}

/// Stress after a step of dt (s) with the Jaumann rate lambda tr(D) I + 2 mu D + W sigma - sigma W, to second
/// order: D and W are those of the middle of the step [Hughes & Winget 1980], and the stress turns after one
/// half of the strain and before the other, so that a step taken back restores it.
template <class S>
Tensor<S> hypoelastic_stress(const Lame<S>& lame, const Tensor<S>& stress, const Tensor<S>& velocity_gradient,
                             typename S::Real dt) {
    const Tensor<S> middle = midstep_gradient(velocity_gradient, dt);
    const Tensor<S> half_strain = (dt / 2) * symmetric(middle);
    const Tensor<S> half =
        (lame.lambda * trace(half_strain)) * Tensor<S>::identity() + (2 * lame.mu) * half_strain;
    return rotated_stress(stress + half, middle, dt) + half;
}

/// Largest eigenvalue of F F^T in the plane, the square of the largest stretch there: exact in 1D and 2D, an
/// upper bound in 3D [Wolkowicz & Styan 1980]; independent of rotation.
template <class S>
typename S::Real largest_squared_stretch(const Tensor<S>& f) {
    using Real = typename S::Real;
    using Matrix = typename S::Matrix;
    constexpr Real d = S::dimension;
    const Matrix b = f.plane * f.plane.transpose();
    const Real mean = b.trace() / d;
    const Matrix deviator = b - mean * Matrix::Identity();
    return mean + std::sqrt((d - 1) / d * deviator.squaredNorm());
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
