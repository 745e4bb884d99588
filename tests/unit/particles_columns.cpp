#include <matpoint/particles.hpp>

#include <gtest/gtest.h>

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

TEST(particles, that_follow_dropped_ones_hold_initial_values) {
    Particles<Bar> particles("rod");
    particles.require(Field::deformation_gradient);
    particles.resize(3);
    for (Index p = 0; p < 3; ++p)
        particles.column(Field::mass)[p] = particles.column(Field::deformation_gradient)[p] = 7;
    const std::array<std::uint32_t, 1> kept{2};
    particles.permute(kept);
    particles.resize(3);
    EXPECT_EQ(particles.column(Field::mass)[0], 7);
    for (const Index p : {1, 2}) {
        EXPECT_EQ(particles.column(Field::mass)[p], 0);
        EXPECT_EQ(particles.column(Field::deformation_gradient)[p], 1);
    }
}

}  // namespace
}  // namespace matpoint
