#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace matpoint {

/// As many numbers as a 32-byte register holds, one particle a lane; arithmetic acts on all lanes.
/// What is written for a type T with T(0.5), + - * /, min and max works for a number and for a Pack.
template <class Real>
class Pack {
  public:
    static constexpr int lanes = static_cast<int>(32 / sizeof(Real));

    Pack() = default;  ///< lanes are not initialised
    template <class Number>
    requires std::is_arithmetic_v<Number> Pack(Number x)
        : v_(broadcast<Lanes>(static_cast<Real>(x), std::make_index_sequence<lanes>())) {}

    static Pack load(const Real* from) {
        Pack a;
        std::memcpy(&a.v_, from, sizeof a.v_);
        return a;
    }
    void store(Real* to) const { std::memcpy(to, &v_, sizeof v_); }

    Real operator[](int lane) const { return v_[lane]; }
    void set(int lane, Real x) { v_[lane] = x; }

    friend Pack operator+(Pack a, Pack b) { return Pack(a.v_ + b.v_); }
    friend Pack operator-(Pack a, Pack b) { return Pack(a.v_ - b.v_); }
    friend Pack operator*(Pack a, Pack b) { return Pack(a.v_ * b.v_); }
    friend Pack operator/(Pack a, Pack b) { return Pack(a.v_ / b.v_); }
    Pack operator-() const { return Pack(-v_); }
    Pack& operator+=(Pack b) { return *this = *this + b; }
    Pack& operator-=(Pack b) { return *this = *this - b; }
    Pack& operator*=(Pack b) { return *this = *this * b; }

    friend Pack min(Pack a, Pack b) { return Pack(a.v_ < b.v_ ? a.v_ : b.v_); }
    friend Pack max(Pack a, Pack b) { return Pack(a.v_ > b.v_ ? a.v_ : b.v_); }
    /// 1 / a, and 0 where a is 0.
    friend Pack inverse_or_zero(Pack a) { return Pack(a.v_ != Lanes{} ? Pack(1).v_ / a.v_ : Lanes{}); }
    /// The first `count` lanes of a; those of `rest` beyond.
    friend Pack head(Pack a, int count, Pack rest) {
        const Integers last =
            broadcast<Integers>(static_cast<Integer>(count), std::make_index_sequence<lanes>());
        return Pack(numbering(std::make_index_sequence<lanes>()) < last ? a.v_ : rest.v_);
    }
    /// Sum of the lanes of each of the packs a[0] … a[lanes - 1].
    static Pack sums(const Pack* a) {
        if constexpr (lanes == 4) {
            const auto halves = [&](int i) { return fold<2, 0, 1, 4, 5>(a[i], a[i + 2]); };
            return fold<1, 0, 4, 2, 6>(halves(0), halves(1));
        } else {
            const auto halves = [&](int i) { return fold<4, 0, 1, 2, 3, 8, 9, 10, 11>(a[i], a[i + 4]); };
            const auto quarters = [&](int i) {
                return fold<2, 0, 1, 8, 9, 4, 5, 12, 13>(halves(i), halves(i + 2));
            };
            return fold<1, 0, 8, 2, 10, 4, 12, 6, 14>(quarters(0), quarters(1));
        }
    }

  private:
    using Integer = std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>;
    typedef Real Lanes __attribute__((vector_size(32)));
    typedef Integer Integers __attribute__((vector_size(32)));

    explicit Pack(Lanes v) : v_(v) {}
    template <class Vector, class Number, std::size_t... I>
    static Vector broadcast(Number x, std::index_sequence<I...>) {
        return Vector{(static_cast<void>(I), x)...};
    }
    template <std::size_t... I>
    static Integers numbering(std::index_sequence<I...>) {
        return Integers{static_cast<Integer>(I)...};
    }

    /// Lanes I of a and b laid end to end, each plus the lane `step` further on.
    template <int step, int... I>
    static Pack fold(Pack a, Pack b) {
        return Pack(__builtin_shufflevector(a.v_, b.v_, I...) +
                    __builtin_shufflevector(a.v_, b.v_, (I + step)...));
    }

    Lanes v_;
};

}  // namespace matpoint
