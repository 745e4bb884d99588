#include <matpoint/pack.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace matpoint {
namespace {

template <class P>
class PackTest : public testing::Test {
  public:
    using Real = typename P::Real;
    static constexpr int lanes = P::lanes;
    using Numbers = std::array<Real, static_cast<std::size_t>(lanes)>;

    /// Different numbers in all lanes.
    static Numbers numbers(double first, double step) {
        Numbers n;
        for (std::size_t i = 0; i < n.size(); ++i)
            n[i] = static_cast<Real>(first + step * static_cast<double>(i * i));
        return n;
    }
    template <class OfPack, class OfNumber>
    static void expect_same_lanes(const OfPack& of_pack, const OfNumber& of_number) {
        const Numbers a = numbers(0.3, 0.7), b = numbers(5.1, -1.3);
        const P result = of_pack(P::load(a.data()), P::load(b.data()));
        for (int i = 0; i < lanes; ++i) {
            const auto k = static_cast<std::size_t>(i);
            EXPECT_EQ(result[i], of_number(a[k], b[k])) << "lane " << i;
        }
    }
};
using Packs =
    testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>, Pack<float, 8>>;
TYPED_TEST_SUITE(PackTest, Packs);

TYPED_TEST(PackTest, each_lane_is_the_number) {
    using P = TypeParam;
    using R = typename P::Real;
    this->expect_same_lanes([](P a, P b) { return a * b - a / b + P(2); },
                            [](R a, R b) { return a * b - a / b + R(2); });
    this->expect_same_lanes([](P a, P b) { return min(a, b) + P(3) * max(a, b) + abs(b); },
                            [](R a, R b) { return std::min(a, b) + R(3) * std::max(a, b) + std::abs(b); });
    this->expect_same_lanes([](P a, P b) { return sqrt(a) + floor(b - P(3)); },
                            [](R a, R b) { return std::sqrt(a) + std::floor(b - R(3)); });
    this->expect_same_lanes([](P a, P b) { return select(a < b && !(b > P(5)), a, b); },
                            [](R a, R b) { return a < b && !(b > R(5)) ? a : b; });
}

TYPED_TEST(PackTest, logarithms_and_powers_are_within_four_units_in_the_last_place) {
    using P = TypeParam;
    using R = typename P::Real;
    const auto expect_near = [](P values, int lane, long double exact) {
        const R unit = std::numeric_limits<R>::epsilon() * static_cast<R>(std::abs(exact));
        EXPECT_NEAR(values[lane], static_cast<R>(exact), 4 * unit) << "lane " << lane;
    };
    for (int k = -300; k < 300; ++k) {
        P a;  // near 1, where the logarithm is small
        for (int i = 0; i < P::lanes; ++i) a.set(i, R(1) + R(k) * R(P::lanes + i) * R(1e-4));
        for (int i = 0; i < P::lanes; ++i) {
            expect_near(log(a), i, std::log(static_cast<long double>(a[i])));
            expect_near(exp(a), i, std::exp(static_cast<long double>(a[i])));
            expect_near(pow(a, R(1.5)), i, std::pow(static_cast<long double>(a[i]), 1.5L));
        }
    }
}

TYPED_TEST(PackTest, the_logarithm_of_what_is_near_1_keeps_the_digits_of_the_difference) {
    using P = TypeParam;
    using R = typename P::Real;
    for (double size = 1e-30; size < 1; size *= 1.7)
        for (const double side : {-0.9, 0.9}) {
            P a;
            for (int i = 0; i < P::lanes; ++i) a.set(i, static_cast<R>(side * size / (1 + i)));
            const P found = log1p(a);
            for (int i = 0; i < P::lanes; ++i) {
                const auto exact = static_cast<R>(std::log1p(static_cast<long double>(a[i])));
                EXPECT_NEAR(found[i], exact, 6 * std::numeric_limits<R>::epsilon() * std::abs(exact)) << a[i];
            }
        }
}

TYPED_TEST(PackTest, multiply_add_rounds_once_or_twice_but_never_by_chance) {
    using P = TypeParam;
    using R = typename P::Real;
    this->expect_same_lanes([](P a, P b) { return multiply_add(a, b, P(-1)); },
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
                            [](R a, R b) { return std::fma(a, b, R(-1)); });
#else
                            [](R a, R b) { return a * b - R(1); });
#endif
}

TYPED_TEST(PackTest, what_is_not_a_number_is_in_no_order) {
    using P = TypeParam;
    const P nan(std::numeric_limits<typename P::Real>::quiet_NaN());
    EXPECT_FALSE(any(nan < P(1)));
    EXPECT_FALSE(any(nan >= P(1)));
    EXPECT_TRUE(any(!(nan >= P(1))));
    EXPECT_EQ(largest(max(nan, P(2))), 2);
    EXPECT_EQ(largest(min(nan, P(2))), 2);
}

TYPED_TEST(PackTest, transpose_exchanges_lanes_and_packs) {
    using P = TypeParam;
    constexpr int n = P::lanes;
    std::array<P, n> packs;
    for (int k = 0; k < n; ++k)
        for (int i = 0; i < n; ++i)
            packs[static_cast<std::size_t>(k)].set(i, static_cast<typename P::Real>(10 * k + i));
    P::transpose(packs.data());
    for (int k = 0; k < n; ++k)
        for (int i = 0; i < n; ++i) EXPECT_EQ(packs[static_cast<std::size_t>(k)][i], 10 * i + k);
}

TYPED_TEST(PackTest, head_and_stores) {
    using P = TypeParam;
    const P a = head(P(7.75), 1, P(-100.5));
    std::array<int, P::lanes> integers;
    a.store(integers.data());
    EXPECT_EQ(integers[0], 7);
    for (int i = 1; i < P::lanes; ++i) {
        EXPECT_EQ(a[i], typename P::Real(-100.5));
        EXPECT_EQ(integers[static_cast<std::size_t>(i)], -100);
    }
    EXPECT_EQ(P(0.1).template as<double>()[P::lanes - 1], static_cast<double>(typename P::Real(0.1)));
}

}  // namespace
}  // namespace matpoint
