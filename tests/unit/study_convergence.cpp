// Orders of convergence and limits of made-up sequences whose order and limit are known; Pareto fronts.

#include <gtest/gtest.h>

#include "study/convergence.hpp"

#include <cmath>
#include <limits>

namespace {

using namespace matpoint;
using Points = std::vector<std::pair<double, double>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<double, 3> sequence(const std::array<double, 3>& sizes, double limit, double factor,
                               double order) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) values[i] = limit + factor * std::pow(sizes[i], order);
    return values;
}

TEST(StudyConvergence, OrderOfErrors) {
    EXPECT_NEAR(observed_order(0.1, 1e-4, 0.2, 4e-4), 2, 1e-12);
    EXPECT_NEAR(observed_order(0.1, 1, 0.3, 3), 1, 1e-12);
    EXPECT_LT(observed_order(0.1, 2, 0.2, 1), 0) << "it gets worse";
    EXPECT_TRUE(std::isnan(observed_order(0.1, 0, 0.2, 1)));
}

TEST(StudyConvergence, RichardsonFindsOrderAndLimit) {
    for (const auto& sizes :
         {std::array{0.1, 0.2, 0.4}, std::array{0.1, 0.13, 0.4}, std::array{1.0, 1.5, 2.0}}) {
        for (const double order : {0.5, 1.0, 2.0, 3.7}) {
            for (const double factor : {3.0, -0.2}) {
                const Extrapolation found = extrapolate(sizes, sequence(sizes, 5, factor, order));
                ASSERT_TRUE(found.order.has_value()) << order;
                EXPECT_NEAR(*found.order, order, 1e-9);
                EXPECT_NEAR(found.limit, 5, 1e-9);
            }
        }
    }
}

TEST(StudyConvergence, WithoutOrderTheFinestIsTheLimit) {
    const std::array sizes{0.1, 0.2, 0.4};
    for (const auto& values : {std::array{1.0, 2.0, 1.5},  // not monotone
                               std::array{1.0, 2.0, 2.5},  // the differences grow
                               std::array{1.0, 1.0, 1.0},  // constant
                               std::array{1.0, 2.0, infinity}}) {
        const Extrapolation found = extrapolate(sizes, values);
        EXPECT_FALSE(found.order.has_value());
        EXPECT_EQ(found.limit, 1.0);
    }
}

TEST(StudyConvergence, TheFrontIsWhatNothingBeats) {
    EXPECT_EQ(pareto_front(Points{{1, 10}, {2, 5}, {3, 5}, {2, 6}, {4, 1}}),
              (std::vector<bool>{true, true, false, false, true}));
    EXPECT_EQ(pareto_front(Points{{1, 1}, {1, 1}}), (std::vector<bool>{true, true})) << "equals don't beat";
    EXPECT_EQ(pareto_front(Points{{1, 1}, {0, std::nan("")}, {infinity, 0}}),
              (std::vector<bool>{true, false, false}));
}

}  // namespace
