#pragma once

#include <matpoint/pack.hpp>

#include <concepts>
#include <type_traits>

namespace matpoint {

template <class Kernel>
concept HasWidth = requires {
    std::integral_constant<int, Kernel::width>();
};
template <class Kernel>
concept HasSized = requires {
    std::bool_constant<Kernel::sized>();
};
template <class Kernel, class T>
concept HasBase = requires(T xi) {
    { Kernel::base(xi) } -> std::convertible_to<T>;
};
template <class Kernel, class T>
concept HasWeights = requires(T s, T* weights) {
    Kernel::evaluate(s, s, weights, weights);
};

/// Kernel::width; where that is missing, any number, so that no more is said about it.
template <class Kernel>
inline constexpr int kernel_width = 1;
template <HasWidth Kernel>
inline constexpr int kernel_width<Kernel> = Kernel::width;

/// Whether Kernel has what TensorProductShape calls; what it lacks is told in a sentence.
template <class Kernel, class Real>
consteval bool is_kernel() {
    constexpr bool width = HasWidth<Kernel>, sized = HasSized<Kernel>;
    static_assert(width,
                  "a shape's kernel says how many nodes a particle reaches along an axis: "
                  "`static constexpr int width = 2;`");
    static_assert(sized,
                  "a shape's kernel says whether it reads the particles' half sizes: "
                  "`static constexpr bool sized = false;`");
    constexpr bool base = HasBase<Kernel, Real> && HasBase<Kernel, Pack<Real>>;
    static_assert(base,
                  "a shape's kernel gives the first of its nodes, for a number and for a Pack: "
                  "`template <class T> static T base(T xi)`");
    constexpr bool weights = HasWeights<Kernel, Real> && HasWeights<Kernel, Pack<Real>>;
    static_assert(weights,
                  "a shape's kernel gives its weights and their derivatives, for a number and for a Pack: "
                  "`template <class T> static void evaluate(T s, T half_size, T* weights, T* derivatives)`");
    return width && sized && base && weights;
}

}  // namespace matpoint
