#include <matpoint/columns.hpp>

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

TEST(columns, assign_clears) {
    Columns<double> columns;
    columns.assign(2, 1000);
    const double* const memory = columns[0];
    columns[1][999] = 3;
    columns.assign(2, 1050);
    EXPECT_EQ(columns[0], memory);
    EXPECT_EQ(columns[1][999], 0);
    EXPECT_EQ(columns[1][1049], 0);
}

}  // namespace
}  // namespace matpoint
