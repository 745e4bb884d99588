#pragma once

#include <matpoint/space.hpp>

#include <Eigen/LU>

#include <type_traits>

namespace matpoint {

/// A second-order tensor of a space: the in-plane part and, in 2D, the component normal to the
/// plane (zz in plane strain, the hoop component when axisymmetric). A material written with these
/// operations is right in every space: 1D has one component, 3D has nine.
template <class S>
struct Tensor {
    using Real = typename S::Real;
    using Matrix = typename S::Matrix;
    struct None {
        constexpr None() = default;
        constexpr None(Real) {}
    };

    Matrix plane = Matrix::Zero();
    [[no_unique_address]] std::conditional_t<S::has_normal, Real, None> normal{};

    static Tensor identity() {
        Tensor t;
        t.plane = Matrix::Identity();
        if constexpr (S::has_normal) t.normal = Real(1);
        return t;
    }

    friend Tensor operator+(const Tensor& a, const Tensor& b) {
        Tensor t;
        t.plane = a.plane + b.plane;
        if constexpr (S::has_normal) t.normal = a.normal + b.normal;
        return t;
    }
    friend Tensor operator-(const Tensor& a, const Tensor& b) { return a + Real(-1) * b; }
    friend Tensor operator*(Real s, const Tensor& a) {
        Tensor t;
        t.plane = s * a.plane;
        if constexpr (S::has_normal) t.normal = s * a.normal;
        return t;
    }
    /// Matrix product.
    friend Tensor operator*(const Tensor& a, const Tensor& b) {
        Tensor t;
        t.plane.noalias() = a.plane * b.plane;
        if constexpr (S::has_normal) t.normal = a.normal * b.normal;
        return t;
    }
};

template <class S>
Tensor<S> transpose(const Tensor<S>& a) {
    Tensor<S> t = a;
    t.plane = a.plane.transpose();
    return t;
}

template <class S>
Tensor<S> symmetric(const Tensor<S>& a) {
    return typename S::Real(0.5) * (a + transpose(a));
}

template <class S>
Tensor<S> skew(const Tensor<S>& a) {
    return typename S::Real(0.5) * (a - transpose(a));
}

template <class S>
typename S::Real trace(const Tensor<S>& a) {
    if constexpr (S::has_normal)
        return a.plane.trace() + a.normal;
    else
        return a.plane.trace();
}

template <class S>
typename S::Real determinant(const Tensor<S>& a) {
    if constexpr (S::has_normal)
        return a.plane.determinant() * a.normal;
    else
        return a.plane.determinant();
}

/// a : b, the sum of the products of all components.
template <class S>
typename S::Real contract(const Tensor<S>& a, const Tensor<S>& b) {
    const typename S::Real plane = a.plane.cwiseProduct(b.plane).sum();
    if constexpr (S::has_normal)
        return plane + a.normal * b.normal;
    else
        return plane;
}

}  // namespace matpoint
