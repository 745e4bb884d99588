#pragma once

#include <matpoint/pack.hpp>
#include <matpoint/space.hpp>

#include <Eigen/LU>

#include <array>
#include <type_traits>

namespace matpoint {

/// A square matrix of Packs, by column as Eigen's. Eigen's own operations on such numbers are not inlined.
template <class T, int D>
struct PackMatrix {
    std::array<T, static_cast<std::size_t>(D) * D> numbers;

    PackMatrix() {
#pragma GCC unroll 9  // or it becomes a call of memset's kind, which takes longer
        for (T& number : numbers) number = T(0);
    }
    MATPOINT_INLINE T& operator()(int row, int column) {
        return numbers[place(row, column)];
    }
    MATPOINT_INLINE const T& operator()(int row, int column) const {
        return numbers[place(row, column)];
    }
    T* data() {
        return numbers.data();
    }
    const T* data() const {
        return numbers.data();
    }
    static PackMatrix Zero() {
        return {};
    }

  private:
    MATPOINT_INLINE static std::size_t place(int row, int column) {
        const int place = row + D * column;
        return static_cast<std::size_t>(place);
    }
};

/// A second-order tensor of a space: the in-plane part and, in 2D, the component normal to the
/// plane (zz in plane strain, the hoop component when axisymmetric). A material written with these
/// operations is right in every space: 1D has one component, 3D has nine. Its numbers are of type T: one
/// number, or a Pack of them, one particle a lane.
template <class S, class T = typename S::Real>
struct Tensor {
    static constexpr int d = S::dimension;
    using Number = T;
    using Matrix = std::conditional_t<std::is_arithmetic_v<T>, Eigen::Matrix<T, d, d>, PackMatrix<T, d>>;
    struct None {
        constexpr None() = default;
        constexpr None(T) {}
    };

    Matrix plane = Matrix::Zero();
    [[no_unique_address]] std::conditional_t<S::has_normal, T, None> normal{};

    MATPOINT_INLINE static Tensor identity() {
        Tensor t;
        for (int a = 0; a < d; ++a) t.plane(a, a) = T(1);
        if constexpr (S::has_normal) t.normal = T(1);
        return t;
    }

    /// function(a, b) of each component.
    template <class Function>
    MATPOINT_INLINE static Tensor zip(const Tensor& a, const Tensor& b, const Function& function) {
        Tensor t;
        for (int c = 0; c < d * d; ++c) t.plane.data()[c] = function(a.plane.data()[c], b.plane.data()[c]);
        if constexpr (S::has_normal) t.normal = function(a.normal, b.normal);
        return t;
    }
    MATPOINT_INLINE friend Tensor operator+(const Tensor& a, const Tensor& b) {
        return zip(a, b, [](const T& x, const T& y) { return x + y; });
    }
    MATPOINT_INLINE friend Tensor operator-(const Tensor& a, const Tensor& b) {
        return zip(a, b, [](const T& x, const T& y) { return x - y; });
    }
    MATPOINT_INLINE friend Tensor operator*(T s, const Tensor& a) {
        return zip(a, a, [&](const T& x, const T&) { return s * x; });
    }
    /// Matrix product.
    MATPOINT_INLINE friend Tensor operator*(const Tensor& a, const Tensor& b) {
        Tensor t;
        for (int column = 0; column < d; ++column)
            for (int row = 0; row < d; ++row) {
                T sum = a.plane(row, 0) * b.plane(0, column);
                for (int k = 1; k < d; ++k) sum = multiply_add(a.plane(row, k), b.plane(k, column), sum);
                t.plane(row, column) = sum;
            }
        if constexpr (S::has_normal) t.normal = a.normal * b.normal;
        return t;
    }
};

template <class S, class T>
MATPOINT_INLINE Tensor<S, T> transpose(const Tensor<S, T>& a) {
    Tensor<S, T> t = a;
    for (int row = 0; row < S::dimension; ++row)
        for (int column = 0; column < S::dimension; ++column) t.plane(row, column) = a.plane(column, row);
    return t;
}

template <class S, class T>
MATPOINT_INLINE Tensor<S, T> symmetric(const Tensor<S, T>& a) {
    return T(0.5) * (a + transpose(a));
}

template <class S, class T>
MATPOINT_INLINE Tensor<S, T> skew(const Tensor<S, T>& a) {
    return T(0.5) * (a - transpose(a));
}

template <class S, class T>
MATPOINT_INLINE T trace(const Tensor<S, T>& a) {
    T sum = a.plane(0, 0);
    for (int c = 1; c < S::dimension; ++c) sum += a.plane(c, c);
    if constexpr (S::has_normal) sum += a.normal;
    return sum;
}

/// The transpose of the in-plane part's cofactors; with 1 for the normal component.
template <class S, class T>
MATPOINT_INLINE Tensor<S, T> adjugate(const Tensor<S, T>& a) {
    Tensor<S, T> t = Tensor<S, T>::identity();
    if constexpr (S::dimension == 2) {
        t.plane(0, 0) = a.plane(1, 1);
        t.plane(1, 1) = a.plane(0, 0);
        t.plane(0, 1) = -a.plane(0, 1);
        t.plane(1, 0) = -a.plane(1, 0);
    } else if constexpr (S::dimension == 3) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const int k = (j + 1) % 3, l = (j + 2) % 3, m = (i + 1) % 3, n = (i + 2) % 3;
                t.plane(i, j) = a.plane(k, m) * a.plane(l, n) - a.plane(k, n) * a.plane(l, m);
            }
    }
    return t;
}

/// Of the in-plane part.
template <class S, class T>
MATPOINT_INLINE T plane_determinant(const Tensor<S, T>& a) {
    const Tensor<S, T> cofactors = adjugate(a);
    T sum = a.plane(0, 0) * cofactors.plane(0, 0);
    for (int c = 1; c < S::dimension; ++c) sum = multiply_add(a.plane(0, c), cofactors.plane(c, 0), sum);
    return sum;
}

template <class S, class T>
MATPOINT_INLINE T determinant(const Tensor<S, T>& a) {
    if constexpr (S::has_normal)
        return plane_determinant(a) * a.normal;
    else
        return plane_determinant(a);
}

/// det(I + H) - 1, the change of volume by a displacement gradient H, whatever small it is.
template <class S, class T>
MATPOINT_INLINE T volume_change(const Tensor<S, T>& h) {
    T diagonal = h.plane(0, 0), rest(0);
    for (int c = 1; c < S::dimension; ++c) diagonal += h.plane(c, c);
    if constexpr (S::dimension > 1) rest = plane_determinant(h);
    if constexpr (S::dimension == 3) {
        const Tensor<S, T> cofactors = adjugate(h);
        for (int c = 0; c < 3; ++c) rest += cofactors.plane(c, c);
    }
    const T change = diagonal + rest;
    if constexpr (S::has_normal)
        return multiply_add(change, h.normal, change + h.normal);
    else
        return change;
}

template <class S, class T>
MATPOINT_INLINE Tensor<S, T> inverse(const Tensor<S, T>& a) {
    Tensor<S, T> t = (T(1) / plane_determinant(a)) * adjugate(a);
    if constexpr (S::has_normal) t.normal = T(1) / a.normal;
    return t;
}

/// The same numbers of another precision.
template <class T, class S, class From>
Tensor<S, T> cast(const Tensor<S, From>& a) {
    Tensor<S, T> t;
    t.plane = a.plane.template cast<T>();
    if constexpr (S::has_normal) t.normal = static_cast<T>(a.normal);
    return t;
}

/// a where `condition` holds, b elsewhere.
template <class S, class T>
MATPOINT_INLINE Tensor<S, T> select(const typename T::Mask& condition, const Tensor<S, T>& a,
                                    const Tensor<S, T>& b) {
    return Tensor<S, T>::zip(a, b, [&](const T& x, const T& y) { return select(condition, x, y); });
}

/// a : b, the sum of the products of all components.
template <class S, class T>
MATPOINT_INLINE T contract(const Tensor<S, T>& a, const Tensor<S, T>& b) {
    T sum = a.plane.data()[0] * b.plane.data()[0];
    for (int c = 1; c < S::dimension * S::dimension; ++c)
        sum = multiply_add(a.plane.data()[c], b.plane.data()[c], sum);
    if constexpr (S::has_normal) sum += a.normal * b.normal;
    return sum;
}

}  // namespace matpoint
