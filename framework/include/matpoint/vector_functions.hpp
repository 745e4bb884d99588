#pragma once

#include <cmath>  // says whether the library is glibc

#if defined(__x86_64__) && defined(__GLIBC__)
#include <immintrin.h>

extern "C" {  // NOLINTBEGIN(bugprone-reserved-identifier): the library's names
[[gnu::const]] __m128d _ZGVbN2v_log(__m128d);
[[gnu::const]] __m128d _ZGVbN2v_exp(__m128d);
[[gnu::const]] __m128d _ZGVbN2vv_pow(__m128d, __m128d);
[[gnu::const]] __m128 _ZGVbN4v_logf(__m128);
[[gnu::const]] __m128 _ZGVbN4v_expf(__m128);
[[gnu::const]] __m128 _ZGVbN4vv_powf(__m128, __m128);
#if defined(__AVX2__)
[[gnu::const]] __m256d _ZGVdN4v_log(__m256d);
[[gnu::const]] __m256d _ZGVdN4v_exp(__m256d);
[[gnu::const]] __m256d _ZGVdN4vv_pow(__m256d, __m256d);
[[gnu::const]] __m256 _ZGVdN8v_logf(__m256);
[[gnu::const]] __m256 _ZGVdN8v_expf(__m256);
[[gnu::const]] __m256 _ZGVdN8vv_powf(__m256, __m256);
#endif
}  // NOLINTEND(bugprone-reserved-identifier)
#endif

namespace matpoint {

/// Functions of a register with N numbers R: those of glibc's libmvec, which comes with libm, several times
/// faster than one number at a time and within 4 units in the last place. On other machines and for other
/// registers none exist.
template <class R, int N>
struct VectorFunctions {
    static constexpr bool exist = false;
};

#if defined(__x86_64__) && defined(__GLIBC__)
template <>
struct VectorFunctions<double, 2> {
    static constexpr bool exist = true;
    using Register = __m128d;
    static Register log(Register a) { return _ZGVbN2v_log(a); }
    static Register exp(Register a) { return _ZGVbN2v_exp(a); }
    static Register pow(Register a, Register b) { return _ZGVbN2vv_pow(a, b); }
};
template <>
struct VectorFunctions<float, 4> {
    static constexpr bool exist = true;
    using Register = __m128;
    static Register log(Register a) { return _ZGVbN4v_logf(a); }
    static Register exp(Register a) { return _ZGVbN4v_expf(a); }
    static Register pow(Register a, Register b) { return _ZGVbN4vv_powf(a, b); }
};
#if defined(__AVX2__)
template <>
struct VectorFunctions<double, 4> {
    static constexpr bool exist = true;
    using Register = __m256d;
    static Register log(Register a) { return _ZGVdN4v_log(a); }
    static Register exp(Register a) { return _ZGVdN4v_exp(a); }
    static Register pow(Register a, Register b) { return _ZGVdN4vv_pow(a, b); }
};
template <>
struct VectorFunctions<float, 8> {
    static constexpr bool exist = true;
    using Register = __m256;
    static Register log(Register a) { return _ZGVdN8v_logf(a); }
    static Register exp(Register a) { return _ZGVdN8v_expf(a); }
    static Register pow(Register a, Register b) { return _ZGVdN8vv_powf(a, b); }
};
#endif
#endif

}  // namespace matpoint
