#pragma once

#include <matpoint/schema.hpp>
#include <matpoint/tensor.hpp>

#include <cmath>

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
template <class S, class T>
MATPOINT_INLINE Tensor<S, T> rotated_stress(const Tensor<S, T>& stress, const Tensor<S, T>& velocity_gradient,
                                            typename S::Real dt) {
    if constexpr (S::dimension == 1) {
        return stress;
    } else {
        const Tensor<S, T> a = (dt / 2) * skew(velocity_gradient);
        // Closed form of the inverse: A^3 = -|a|^2 A, where |a|^2 = A:A / 2.
        const Tensor<S, T> q =
            Tensor<S, T>::identity() + (T(2) / (T(1) + contract(a, a) / T(2))) * (a + a * a);
        return q * stress * transpose(q);
    }
}

/// L (I + L dt/2)^-1, the gradient with respect to the middle of a step from where L was taken by I + L dt.
/// It changes its sign if the step is taken back, and of a rotation it is the spin alone. L itself has a
/// strain of L^2 dt^2 / 2 too much, always with the same sign, which every vibration and every turn would
/// leave behind.
template <class S, class T>
MATPOINT_INLINE Tensor<S, T> midstep_gradient(const Tensor<S, T>& velocity_gradient, typename S::Real dt) {
    return velocity_gradient * inverse(Tensor<S, T>::identity() + (dt / 2) * velocity_gradient);
}

/// Stress after a step of dt (s) with the Jaumann rate lambda tr(D) I + 2 mu D + W sigma - sigma W, to second
/// order: D and W are those of the middle of the step [Hughes & Winget 1980], and the stress turns after one
/// half of the strain and before the other, so that a step taken back restores it.
template <class S, class T>
MATPOINT_INLINE Tensor<S, T> hypoelastic_stress(const Lame<S>& lame, const Tensor<S, T>& stress,
                                                const Tensor<S, T>& velocity_gradient, typename S::Real dt) {
    const Tensor<S, T> middle = midstep_gradient(velocity_gradient, dt);
    const Tensor<S, T> half_strain = (dt / 2) * symmetric(middle);
    const Tensor<S, T> half =
        (lame.lambda * trace(half_strain)) * Tensor<S, T>::identity() + (2 * lame.mu) * half_strain;
    return rotated_stress(stress + half, middle, dt) + half;
}

/// F F^T - I = H + H^T + H H^T of F = I + H: twice the strain where that is small, which F F^T rounds away.
template <class S, class T>
MATPOINT_INLINE Tensor<S, T> squared_strain(const Tensor<S, T>& displacement_gradient) {
    const Tensor<S, T> transposed = transpose(displacement_gradient);
    return displacement_gradient + transposed + displacement_gradient * transposed;
}

/// Largest eigenvalue of a symmetric tensor in the plane: exact in 1D and 2D, an upper bound in 3D
/// [Wolkowicz & Styan 1980]; independent of rotation.
template <class S, class T>
MATPOINT_INLINE T largest_eigenvalue(const Tensor<S, T>& b) {
    using std::sqrt;
    constexpr typename S::Real d = S::dimension;
    T mean = b.plane(0, 0);
    for (int a = 1; a < S::dimension; ++a) mean += b.plane(a, a);
    mean /= T(d);
    T diagonal(0), off_diagonal(0);  // squares of the deviator, which is symmetric
    for (int a = 0; a < S::dimension; ++a) {
        diagonal = multiply_add(b.plane(a, a) - mean, b.plane(a, a) - mean, diagonal);
        for (int c = 0; c < a; ++c) off_diagonal = multiply_add(b.plane(a, c), b.plane(a, c), off_diagonal);
    }
    return mean + sqrt(T((d - 1) / d) * (diagonal + T(2) * off_diagonal));
}

/// That of F F^T, the square of the largest stretch.
template <class S, class T>
MATPOINT_INLINE T largest_squared_stretch(const Tensor<S, T>& f) {
    return largest_eigenvalue(f * transpose(f));
}

/// (lambda + 2 mu) / rho, the square of the speed of pressure waves, m^2/s^2; E / rho in a bar.
template <class S, class T>
MATPOINT_INLINE T squared_elastic_wave_speed(const Lame<S>& lame, T density) {
    return T(lame.lambda + 2 * lame.mu) / density;
}

}  // namespace matpoint
