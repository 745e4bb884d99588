// Strains far below 1 keep their digits: against long double, in numbers and in Packs.
#include <matpoint/elasticity.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace matpoint {
namespace {

template <class S>
class SmallStrains : public testing::Test {
  protected:
    using Real = typename S::Real;
    using Number = Pack<Real>;
    static constexpr double eps = std::numeric_limits<Real>::epsilon();

    /// check(H, H in all lanes, H in long double, largest component) from 1e-12 to 0.3.
    template <class Check>
    static void for_each_gradient(const Check& check) {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> component(-1, 1);
        for (double size = 1e-12; size < 1; size *= std::sqrt(10.0))
            for (int k = 0; k < 20; ++k) {
                Tensor<S> h;
                Tensor<S, Number> lanes;
                for (int c = 0; c < S::dimension * S::dimension; ++c)
                    lanes.plane.data()[c] = h.plane.data()[c] =
                        static_cast<Real>(0.3 * size * component(random));
                if constexpr (S::axisymmetric)
                    lanes.normal = h.normal = static_cast<Real>(0.3 * size * component(random));
                check(h, lanes, cast<long double>(h), size);
            }
    }
};
using Spaces = testing::Types<Bar, PlaneStrain, Axisymmetric, Solid, BarSingle, PlaneStrainSingle,
                              AxisymmetricSingle, SolidSingle>;
TYPED_TEST_SUITE(SmallStrains, Spaces);

/// det(I + H) - 1 by the invariants of H.
template <class S>
long double exact_volume_change(const Tensor<S, long double>& h) {
    const auto& a = h.plane;
    long double sum = a.trace(), rest = 0;
    if constexpr (S::dimension == 2) rest = a.determinant();
    if constexpr (S::dimension == 3) rest = a.determinant() + (a.trace() * a.trace() - (a * a).trace()) / 2;
    if constexpr (S::has_normal)
        return sum + h.normal + rest + (sum + rest) * h.normal;
    else
        return sum + rest;
}

TYPED_TEST(SmallStrains, change_the_volume_by_their_trace_and_more) {
    using S = TypeParam;
    this->for_each_gradient([&](const auto& h, const auto& lanes, const auto& wide, double size) {
        const auto exact = static_cast<double>(exact_volume_change<S>(wide));
        const double tolerance = 6 * this->eps * size;
        EXPECT_NEAR(static_cast<double>(volume_change(h)), exact, tolerance);
        EXPECT_NEAR(static_cast<double>(volume_change(lanes)[1]), exact, tolerance);
        const auto whole = static_cast<double>(determinant(Tensor<S, long double>::identity() + wide) -
                                               1);  // where size is not too small
        EXPECT_NEAR(exact, whole, 4e-18);
        EXPECT_NEAR(static_cast<double>(log1p(volume_change(lanes))[1]), std::log1p(exact), tolerance);
    });
}

TYPED_TEST(SmallStrains, are_what_F_FT_has_beyond_the_identity) {
    using S = TypeParam;
    this->for_each_gradient([&](const auto& h, const auto& lanes, const auto& wide, double size) {
        const auto one = Tensor<S, long double>::identity();
        const auto exact = (one + wide) * transpose(one + wide) - one;
        const auto found = squared_strain(h);
        const auto in_lanes = squared_strain(lanes);
        for (int c = 0; c < S::dimension * S::dimension; ++c) {
            const auto value = static_cast<double>(exact.plane.data()[c]);
            EXPECT_NEAR(static_cast<double>(found.plane.data()[c]), value, 4 * this->eps * size + 1e-18);
            EXPECT_NEAR(static_cast<double>(in_lanes.plane.data()[c][1]), value,
                        4 * this->eps * size + 1e-18);
        }
        if constexpr (S::has_normal) {
            EXPECT_NEAR(static_cast<double>(found.normal), static_cast<double>(exact.normal),
                        4 * this->eps * size + 1e-18);
        }
    });
}

}  // namespace
}  // namespace matpoint
