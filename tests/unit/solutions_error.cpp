#include "run/exact_error.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace matpoint {
namespace {

TEST(ErrorSums, MeanRootMeanSquareAndLargest) {
    ErrorSums sums;
    for (const double deviation : {3.0, 4.0, 0.0, 1.0}) sums.add(deviation);
    EXPECT_DOUBLE_EQ(sums.l1(), 2.0);
    EXPECT_DOUBLE_EQ(sums.l2(), std::sqrt(26.0 / 4));
    EXPECT_DOUBLE_EQ(sums.largest, 4.0);
}

TEST(ErrorSums, WhatIsNotANumberIsNotForgotten) {
    ErrorSums sums;
    sums.add(1);
    sums.add(std::numeric_limits<double>::quiet_NaN());
    sums.add(2);
    EXPECT_TRUE(std::isnan(sums.largest));
    EXPECT_TRUE(std::isnan(sums.l1()));
}

}  // namespace
}  // namespace matpoint
