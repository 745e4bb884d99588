#include <matpoint/particle_pack.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace matpoint {
namespace {

TEST(columns, keep_what_they_held_when_they_grow) {
    Columns<double> columns(1);
    columns.resize(2, 3);
    for (Index p = 0; p < 3; ++p) columns[0][p] = static_cast<double>(p + 1), columns[1][p] = -1;
    columns.resize(3, 100'000);
    EXPECT_EQ(columns.count(), 3);
    EXPECT_EQ(columns.size(), 100'000);
    EXPECT_EQ(columns[0][2], 3);
    EXPECT_EQ(columns[1][0], -1);
    EXPECT_EQ(columns[0][3], 0);
    EXPECT_EQ(columns[2][99'999], 0);
}

TEST(columns, the_spare_one_takes_anothers_place) {
    Columns<float> columns(1);
    columns.resize(2, 4);
    columns[1][3] = 5;
    columns.spare()[3] = 7;
    columns.exchange_with_spare(1);
    EXPECT_EQ(columns[1][3], 7);
    EXPECT_EQ(columns.spare()[3], 5);
}

TEST(columns, begin_an_odd_number_of_cache_lines_apart) {
    for (const Index n : {Index{1}, Index{8}, Index{64}, Index{4096}, Index{1 << 18}}) {
        Columns<double> columns;
        columns.resize(2, n);
        const Index bytes = (columns[1] - columns[0]) * Index{sizeof(double)};
        EXPECT_EQ(bytes % 128, 64) << n;
    }
}

TEST(columns, keep_what_they_held_when_the_spare_one_is_released) {
    for (const Index n : {Index{100}, Index{300'001}}) {
        Columns<double> columns(1);
        columns.resize(3, n);
        for (std::size_t c = 0; c < 3; ++c)
            for (Index p = 0; p < n; ++p) columns[c][p] = static_cast<double>(c + 1);
        for (const std::size_t exchanged : {2U, 0U, 1U}) {
            std::fill_n(columns.spare(), n, static_cast<double>(exchanged + 1));
            columns.exchange_with_spare(exchanged);
            columns.release_spare();
            for (std::size_t c = 0; c < 3; ++c)
                for (Index p = 0; p < n; ++p) ASSERT_EQ(columns[c][p], static_cast<double>(c + 1)) << n;
        }
    }
}

template <class S>
class particles_of_any_precision : public testing::Test {};
using Precisions = testing::Types<Solid, SolidSingle>;
TYPED_TEST_SUITE(particles_of_any_precision, Precisions);

TYPED_TEST(particles_of_any_precision, hold_positions_and_volumes_in_double) {
    using S = TypeParam;
    using Vector = typename S::Vector;
    Particles<S> particles("rod");
    particles.require(Field::initial_position);
    EXPECT_EQ(particles.has(Field::position_remainder), S::single);
    EXPECT_EQ(particles.has(Field::initial_position_remainder), S::single);
    EXPECT_EQ(particles.has(Field::volume_remainder), S::single);
    particles.require(Field::velocity_remainder);
    EXPECT_EQ(particles.has(Field::velocity_remainder), S::single);
    particles.resize(300);
    const auto value = [](Index p, int a) { return (a - 1) * 1e4 / (1.0 + static_cast<double>(p)) + 0.1; };
    for (Index p = 0; p < 300; ++p) {
        for (int a = 0; a < 3; ++a)
            for (const Field field : {Field::position, Field::initial_position})
                particles.set_value(field, a, p, value(p, a));
        particles.set_value(Field::volume, 0, p, value(p, 2));
    }
    std::vector<std::uint32_t> backwards(300);
    std::iota(backwards.rbegin(), backwards.rend(), 0U);
    particles.permute(backwards);
    for (Index p = 0; p < 300; ++p) {
        const auto x = particles.position(p);
        for (int a = 0; a < 3; ++a) {
            const double exact = value(299 - p, a), tolerance = 1e-14 * std::abs(exact);
            EXPECT_NEAR(x[a], exact, tolerance);
            EXPECT_NEAR(particles.position(p, Field::initial_position)[a], exact, tolerance);
        }
        EXPECT_NEAR(particles.value(Field::volume, 0, p), value(299 - p, 2), 1e-14 * value(299 - p, 2));
        const Vector rounded = particles.vector(Field::position, p);
        EXPECT_TRUE((lowest_position<S>(rounded).array() <= x.array()).all());
        EXPECT_TRUE((highest_position<S>(rounded).array() >= x.array()).all());
    }
}

TYPED_TEST(particles_of_any_precision, add_up_what_is_far_smaller_than_they_hold) {
    using S = TypeParam;
    using Real = typename S::Real;
    constexpr int count = 13, steps = 10'000;  // no whole number of Packs
    Particles<S> particles("rod");
    particles.resize(count);
    const auto start = [](Index p) { return 1e3 * static_cast<double>(p - 6); };
    const auto increment = [](Index p) { return static_cast<Real>(1e-6 * static_cast<double>(p + 1)); };
    for (Index p = 0; p < count; ++p) particles.set_value(Field::position, 1, p, start(p));
    Gathered<S> gathered{};
    for (Index p = 0; p < count; ++p) gathered.velocity[1][static_cast<std::size_t>(p)] = increment(p);
    const ParticleBatch<S> batch(particles, 0, count, gathered, -1);
    for (int k = 0; k < steps; ++k)
        visit_packs(batch,
                    [&](const auto& p) { p.template add<Field::position>(1, p.load(gathered.velocity[1])); });
    for (Index p = 0; p < count; ++p) {
        const double moved = steps * static_cast<double>(increment(p));
        EXPECT_NEAR(particles.value(Field::position, 1, p) - start(p), moved, 1e-5 * moved) << p;
    }
}

TEST(particles, that_follow_dropped_ones_hold_initial_values) {
    Particles<Bar> particles("rod");
    const int damage = particles.require("damage", 1, 1);
    particles.resize(3);
    for (Index p = 0; p < 3; ++p) particles.column(Field::mass)[p] = particles.column(damage, 0)[p] = 7;
    const std::array<std::uint32_t, 1> kept{2};
    particles.permute(kept);
    particles.resize(3);
    EXPECT_EQ(particles.column(Field::mass)[0], 7);
    for (const Index p : {1, 2}) {
        EXPECT_EQ(particles.column(Field::mass)[p], 0);
        EXPECT_EQ(particles.column(damage, 0)[p], 1);
    }
}

}  // namespace
}  // namespace matpoint
