#pragma once

#include <matpoint/vector_functions.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/// For small functions that every particle runs through: GCC leaves some of them out of line otherwise.
#define MATPOINT_INLINE [[gnu::always_inline]] inline
/// For a loop over particles: whatever it calls becomes part of it, however often and wherever that is
/// called.
#if defined(__SANITIZE_ADDRESS__)  // such loops would take minutes to compile
#define MATPOINT_FLATTEN
#else
#define MATPOINT_FLATTEN [[gnu::flatten]]
#endif

namespace matpoint {

/// a b + c, rounded once where the instruction set has that operation (x86-64-v3, v4, ARM64), else twice. The
/// compiler may not choose by itself (-ffp-contract=off), so that results do not depend on what it inlines.
template <class Number>
requires std::is_arithmetic_v<Number> MATPOINT_INLINE Number multiply_add(Number a, Number b, Number c) {
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    return std::fma(a, b, c);
#else
    return a * b + c;
#endif
}

/// Bytes of a register of the instruction set that this is compiled for. Those of 64 bytes of x86-64-v4 made
/// steps 1.35 times slower than those of 32.
#if defined(__AVX__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif
/// Numbers that are treated at once: a register's, but not more than particles usually are in a cell.
template <class Real>
inline constexpr int native_lanes = std::min(8, register_bytes / static_cast<int>(sizeof(Real)));

/// Several numbers; arithmetic acts on all lanes. What is written for a type T with T(0.5), + - * /, <,
/// select and the functions below works for a number and for a Pack, and gives the same bits for each lane as
/// for the number; log, log1p, exp and pow may differ from it by a few units in the last place.
template <class R, int N = native_lanes<R>>
class Pack {
    using Integer = std::conditional_t<sizeof(R) == 8, std::int64_t, std::int32_t>;
    typedef R Lanes __attribute__((vector_size(N * sizeof(R))));
    typedef Integer Integers __attribute__((vector_size(N * sizeof(R))));
    /// Lanes at any address of numbers, which they may alias as vectors do (a byte copy may alias all).
    typedef R Anywhere __attribute__((vector_size(N * sizeof(R)), aligned(sizeof(R))));
    static constexpr std::size_t bytes = N * sizeof(R);
    using Functions = VectorFunctions<R, N>;
    template <class, int>
    friend class Pack;

  public:
    using Real = R;
    static constexpr int lanes = N;

    /// A truth for each lane.
    struct Mask {
        Integers bits;
        MATPOINT_INLINE friend Mask operator&&(Mask a, Mask b) { return {a.bits & b.bits}; }
        MATPOINT_INLINE friend Mask operator||(Mask a, Mask b) { return {a.bits | b.bits}; }
        MATPOINT_INLINE friend Mask operator!(Mask a) { return {~a.bits}; }
        MATPOINT_INLINE friend bool any(Mask a) {
#if defined(__AVX__)
            if constexpr (bytes == 32) return !_mm256_testz_si256(__m256i(a.bits), __m256i(a.bits));
#endif
            bool found = false;
            for (int i = 0; i < N; ++i) found |= a.bits[i] != 0;
            return found;
        }
        /// `if (a < b)` asks for one truth of several particles.
        template <std::same_as<bool> Bool>
        explicit operator Bool() const {
            static_assert(
                !std::is_same_v<Bool, bool>,
                "a condition on a Pack has a truth for each particle: write `select(condition, a, b)` "
                "in the place of `if`, `?:`, `&&` with a bool; any(condition) tells whether it holds "
                "somewhere");
            return false;
        }
    };

    Pack() = default;  ///< lanes are not initialised
    template <class Number>
    requires std::is_arithmetic_v<Number> Pack(Number x)
        : v_(broadcast<Lanes>(static_cast<R>(x), std::make_index_sequence<N>())) {}

    MATPOINT_INLINE static Pack load(const R* from) {
        return Pack(Lanes(*reinterpret_cast<const Anywhere*>(from)));
    }
    MATPOINT_INLINE void store(R* to) const {
        *reinterpret_cast<Anywhere*>(to) = v_;
    }
    /// Without what comes after the point.
    MATPOINT_INLINE void store(int* to) const {
        typedef int Ints __attribute__((vector_size(N * sizeof(int))));
        const Ints a = __builtin_convertvector(v_, Ints);
        std::memcpy(to, &a, sizeof a);
    }
    /// The same numbers of another precision.
    template <class Other>
    MATPOINT_INLINE Pack<Other, N> as() const {
        return Pack<Other, N>(__builtin_convertvector(v_, typename Pack<Other, N>::Lanes));
    }

    R operator[](int lane) const {
        return v_[lane];
    }
    void set(int lane, R x) {
        v_[lane] = x;
    }

    MATPOINT_INLINE friend Pack operator+(Pack a, Pack b) {
        return Pack(a.v_ + b.v_);
    }
    MATPOINT_INLINE friend Pack operator-(Pack a, Pack b) {
        return Pack(a.v_ - b.v_);
    }
    MATPOINT_INLINE friend Pack operator*(Pack a, Pack b) {
        return Pack(a.v_ * b.v_);
    }
    MATPOINT_INLINE friend Pack operator/(Pack a, Pack b) {
        return Pack(a.v_ / b.v_);
    }
    MATPOINT_INLINE Pack operator-() const {
        return Pack(-v_);
    }
    MATPOINT_INLINE Pack& operator+=(Pack b) {
        return *this = *this + b;
    }
    MATPOINT_INLINE Pack& operator-=(Pack b) {
        return *this = *this - b;
    }
    MATPOINT_INLINE Pack& operator*=(Pack b) {
        return *this = *this * b;
    }
    MATPOINT_INLINE Pack& operator/=(Pack b) {
        return *this = *this / b;
    }

    MATPOINT_INLINE friend Mask operator<(Pack a, Pack b) {
        return {a.v_ < b.v_};
    }
    MATPOINT_INLINE friend Mask operator>(Pack a, Pack b) {
        return {a.v_ > b.v_};
    }
    MATPOINT_INLINE friend Mask operator<=(Pack a, Pack b) {
        return {a.v_ <= b.v_};
    }
    MATPOINT_INLINE friend Mask operator>=(Pack a, Pack b) {
        return {a.v_ >= b.v_};
    }
    MATPOINT_INLINE friend Mask operator==(Pack a, Pack b) {
        return {a.v_ == b.v_};
    }
    MATPOINT_INLINE friend Mask operator!=(Pack a, Pack b) {
        return {a.v_ != b.v_};
    }

    /// a where `condition` holds, b elsewhere.
    MATPOINT_INLINE friend Pack select(Mask condition, Pack a, Pack b) {
        return Pack(condition.bits ? a.v_ : b.v_);
    }
    MATPOINT_INLINE friend Pack min(Pack a, Pack b) {
        return Pack(a.v_ < b.v_ ? a.v_ : b.v_);
    }
    MATPOINT_INLINE friend Pack max(Pack a, Pack b) {
        return Pack(a.v_ > b.v_ ? a.v_ : b.v_);
    }
    MATPOINT_INLINE friend Pack abs(Pack a) {
        return Pack(a.v_ < Lanes{} ? -a.v_ : a.v_);
    }
    MATPOINT_INLINE friend Pack sqrt(Pack a) {
#if defined(__AVX__)
        if constexpr (bytes == 32 && sizeof(R) == 8) return Pack(Lanes(_mm256_sqrt_pd(__m256d(a.v_))));
        if constexpr (bytes == 32 && sizeof(R) == 4) return Pack(Lanes(_mm256_sqrt_ps(__m256(a.v_))));
#endif
        return a.each([](R x) { return std::sqrt(x); });
    }
    MATPOINT_INLINE friend Pack floor(Pack a) {
#if defined(__AVX__)
        if constexpr (bytes == 32 && sizeof(R) == 8) return Pack(Lanes(_mm256_floor_pd(__m256d(a.v_))));
        if constexpr (bytes == 32 && sizeof(R) == 4) return Pack(Lanes(_mm256_floor_ps(__m256(a.v_))));
#endif
#if defined(__SSE4_1__)
        if constexpr (bytes == 16 && sizeof(R) == 8) return Pack(Lanes(_mm_floor_pd(__m128d(a.v_))));
        if constexpr (bytes == 16 && sizeof(R) == 4) return Pack(Lanes(_mm_floor_ps(__m128(a.v_))));
#endif
        return a.each([](R x) { return std::floor(x); });
    }
    MATPOINT_INLINE friend Pack log(Pack a) {
        if constexpr (Functions::exist)
            return Pack(Lanes(Functions::log(typename Functions::Register(a.v_))));
        else
            return a.each([](R x) { return std::log(x); });
    }
    /// log(1 + a), however small a is: what 1 + a rounds away is put back to first order.
    MATPOINT_INLINE friend Pack log1p(Pack a) {
        const Pack sum = Pack(1) + a;
        return log(sum) + (a - (sum - Pack(1))) * (Pack(1) / sum);
    }
    MATPOINT_INLINE friend Pack exp(Pack a) {
        if constexpr (Functions::exist)
            return Pack(Lanes(Functions::exp(typename Functions::Register(a.v_))));
        else
            return a.each([](R x) { return std::exp(x); });
    }
    MATPOINT_INLINE friend Pack pow(Pack a, R exponent) {
        if constexpr (Functions::exist)
            return Pack(Lanes(Functions::pow(typename Functions::Register(a.v_),
                                             typename Functions::Register(Pack(exponent).v_))));
        else
            return a.each([=](R x) { return std::pow(x, exponent); });
    }
    /// function(lane) of each lane, for what has no operation of its own.
    template <class Function>
    Pack each(const Function& function) const {
        Pack b;
        for (int i = 0; i < N; ++i) b.v_[i] = function(v_[i]);
        return b;
    }

    MATPOINT_INLINE friend Pack multiply_add(Pack a, Pack b, Pack c) {
#if defined(__FMA__)
        if constexpr (bytes == 32 && sizeof(R) == 8)
            return Pack(Lanes(_mm256_fmadd_pd(__m256d(a.v_), __m256d(b.v_), __m256d(c.v_))));
        if constexpr (bytes == 32 && sizeof(R) == 4)
            return Pack(Lanes(_mm256_fmadd_ps(__m256(a.v_), __m256(b.v_), __m256(c.v_))));
#endif
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
        for (int i = 0; i < N; ++i) c.v_[i] = std::fma(a.v_[i], b.v_[i], c.v_[i]);
        return c;
#else
        return a * b + c;
#endif
    }

    /// 1 / a, and 0 where a is 0.
    MATPOINT_INLINE friend Pack inverse_or_zero(Pack a) {
        return Pack(a.v_ != Lanes{} ? Pack(1).v_ / a.v_ : Lanes{});
    }
    /// The first `count` lanes of a; those of `rest` beyond.
    MATPOINT_INLINE friend Pack head(Pack a, int count, Pack rest) {
        const Integers last = broadcast<Integers>(static_cast<Integer>(count), std::make_index_sequence<N>());
        return Pack(numbering(std::make_index_sequence<N>()) < last ? a.v_ : rest.v_);
    }
    MATPOINT_INLINE friend R largest(Pack a) {
        R found = a.v_[0];
        for (int i = 1; i < N; ++i) found = std::max(found, a.v_[i]);
        return found;
    }

    /// Lane i of pack k becomes lane k of pack i.
    static void transpose(Pack* a) {
        if constexpr (N == 2) {
            const Pack low = shuffle<0, 2>(a[0], a[1]);
            a[1] = shuffle<1, 3>(a[0], a[1]);
            a[0] = low;
        } else if constexpr (N == 4) {
            const Pack low0 = shuffle<0, 4, 2, 6>(a[0], a[1]), high0 = shuffle<1, 5, 3, 7>(a[0], a[1]);
            const Pack low1 = shuffle<0, 4, 2, 6>(a[2], a[3]), high1 = shuffle<1, 5, 3, 7>(a[2], a[3]);
            a[0] = shuffle<0, 1, 4, 5>(low0, low1);
            a[1] = shuffle<0, 1, 4, 5>(high0, high1);
            a[2] = shuffle<2, 3, 6, 7>(low0, low1);
            a[3] = shuffle<2, 3, 6, 7>(high0, high1);
        } else {
            static_assert(N == 8);
            Pack b[8];
            for (int k = 0; k < 8; k += 2) {
                b[k] = shuffle<0, 8, 2, 10, 4, 12, 6, 14>(a[k], a[k + 1]);
                b[k + 1] = shuffle<1, 9, 3, 11, 5, 13, 7, 15>(a[k], a[k + 1]);
            }
            for (int k = 0; k < 8; k += 4)
                for (int i = 0; i < 2; ++i) {
                    a[k + i] = shuffle<0, 1, 8, 9, 4, 5, 12, 13>(b[k + i], b[k + 2 + i]);
                    a[k + 2 + i] = shuffle<2, 3, 10, 11, 6, 7, 14, 15>(b[k + i], b[k + 2 + i]);
                }
            for (int k = 0; k < 4; ++k) {
                b[k] = shuffle<0, 1, 2, 3, 8, 9, 10, 11>(a[k], a[k + 4]);
                b[k + 4] = shuffle<4, 5, 6, 7, 12, 13, 14, 15>(a[k], a[k + 4]);
            }
            for (int k = 0; k < 8; ++k) a[k] = b[k];
        }
    }

  private:
    explicit Pack(Lanes v) : v_(v) {}
    template <class Vector, class Number, std::size_t... I>
    static Vector broadcast(Number x, std::index_sequence<I...>) {
        return Vector{(static_cast<void>(I), x)...};
    }
    template <std::size_t... I>
    static Integers numbering(std::index_sequence<I...>) {
        return Integers{static_cast<Integer>(I)...};
    }
    /// Lanes I of a and b laid end to end.
    template <int... I>
    static Pack shuffle(Pack a, Pack b) {
        return Pack(__builtin_shufflevector(a.v_, b.v_, I...));
    }

    Lanes v_;
};

}  // namespace matpoint
