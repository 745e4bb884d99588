// The bisection for a limit, asked about limits that are known.

#include <gtest/gtest.h>

#include "study/limit_search.hpp"

#include <vector>

namespace {

using matpoint::LimitSearch;

/// What is tried until the search is over, when values below (or above) the limit are stable.
std::vector<double> search(LimitSearch& limits, double limit, bool stable_below = true) {
    std::vector<double> tried;
    while (const auto value = limits.next()) {
        tried.push_back(*value);
        limits.answer(stable_below ? *value < limit : *value > limit);
        if (tried.size() > 100) break;
    }
    return tried;
}

TEST(StudyLimits, AreFoundToTheDigitsAskedFor) {
    for (const double limit : {0.0514, 0.1234, 0.5772, 0.9951, 1.049, 1.98}) {
        LimitSearch coarse(0.05, 2, 2, true), fine(0.05, 2, 4, true);
        EXPECT_LT(search(coarse, limit).size(), 12u);
        search(fine, limit);
        ASSERT_TRUE(coarse.stable() && coarse.unstable() && fine.stable() && fine.unstable());
        EXPECT_LT(*coarse.stable(), limit);
        EXPECT_GE(*coarse.unstable(), limit);
        // Neighbours among the numbers of two digits, 0.1 apart above 1, and 0.01 or 0.001 below.
        const double step = limit >= 1 ? 0.1 : limit >= 0.1 ? 0.01 : 0.001;
        EXPECT_NEAR(*coarse.unstable() - *coarse.stable(), step, 1e-9) << limit;
        EXPECT_LT(*fine.stable(), limit);
        EXPECT_LE(*fine.unstable() - *fine.stable(), 1.001e-3);
    }
}

TEST(StudyLimits, TellWhenTheRangeHasNone) {
    LimitSearch never(0.1, 1, 2, true);
    EXPECT_EQ(search(never, 0.05), (std::vector<double>{0.1})) << "unstable at once: nothing more to try";
    EXPECT_FALSE(never.stable());
    LimitSearch always(0.1, 1, 2, true);
    EXPECT_EQ(search(always, 7), (std::vector<double>{0.1, 1.0}));
    EXPECT_EQ(always.stable(), 1.0);
    EXPECT_FALSE(always.unstable());
}

TEST(StudyLimits, SmallestStableValueOverDecades) {
    LimitSearch limits(1e-6, 1e6, 1, false);
    EXPECT_LT(search(limits, 3.5e2, false).size(), 12u);
    EXPECT_EQ(limits.stable(), 400.0);
    EXPECT_EQ(limits.unstable(), 300.0);
}

TEST(StudyLimits, RangesAcrossZero) {
    LimitSearch limits(-1, 3, 2, true);
    search(limits, 0.5005);
    EXPECT_EQ(limits.stable(), 0.5);
    EXPECT_EQ(limits.unstable(), 0.51);
}

}  // namespace
