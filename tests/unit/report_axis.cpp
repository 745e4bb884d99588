// Axes of plots: places of values, ticks, ranges without extent.

#include "report/plot_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace matpoint;

std::vector<PlotAxis::Tick> labelled(const PlotAxis& axis) {
    std::vector<PlotAxis::Tick> ticks = axis.ticks();
    std::erase_if(ticks, [](const PlotAxis::Tick& tick) { return tick.label.empty(); });
    return ticks;
}

TEST(ReportAxis, EqualFactorsAreEqualDistancesOnALogarithmicAxis) {
    // 5 % of its two decades are left free at both ends: from 10^-1.1 to 10^1.1.
    const PlotAxis axis(true, {0.1, 10}, 0, 220);
    EXPECT_NEAR(axis.pixel(0.1), 10, 1e-9);
    EXPECT_NEAR(axis.pixel(1), 110, 1e-9);
    EXPECT_NEAR(axis.pixel(10), 210, 1e-9);
    EXPECT_NEAR(axis.pixel(2), 110 + 100 * std::log10(2.0), 1e-9);
}

TEST(ReportAxis, RunsUpwardsWhereItsLastPixelIsAbove) {
    const PlotAxis axis(true, {1e-4, 1}, 400, 0);
    EXPECT_GT(axis.pixel(1e-4), axis.pixel(1e-3));
    EXPECT_LT(axis.pixel(1e-4), 400);
    EXPECT_GT(axis.pixel(1), 0);
}

TEST(ReportAxis, DecadesAreLabelledWithPowersAndDividedByMinorTicks) {
    const PlotAxis axis(true, {1e-3, 1}, 0, 300);
    const auto labels = labelled(axis);
    ASSERT_EQ(labels.size(), 4U);
    EXPECT_NE(labels[0].label.find("−3</tspan>"), std::string::npos) << labels[0].label;
    EXPECT_NEAR(labels[2].pixel, axis.pixel(0.1), 1e-9);
    const auto ticks = axis.ticks();
    EXPECT_TRUE(std::any_of(ticks.begin(), ticks.end(), [&](const PlotAxis::Tick& tick) {
        return tick.label.empty() && std::abs(tick.pixel - axis.pixel(0.05)) < 1e-9;
    }));
}

TEST(ReportAxis, AFewLabelsWhateverTheRange) {
    for (const double widest : {1.0, 1.01, 1.5, 2.9, 7.0, 50.0, 99.0, 1e3, 1e9, 1e40, 1e300}) {
        for (const double least : {1e-17, 1.1e-6, 0.4, 1.0, 31.0}) {
            for (const bool logarithmic : {false, true}) {
                if (least * widest > 1e300) continue;
                const PlotAxis axis(logarithmic, {least, least * widest}, 0, 500);
                const auto labels = labelled(axis);
                EXPECT_GE(labels.size(), 2U) << least << " times " << widest;
                EXPECT_LE(labels.size(), 13U) << least << " times " << widest;
                EXPECT_LE(axis.ticks().size(), 120U);
                for (const auto& tick : axis.ticks()) {
                    EXPECT_GE(tick.pixel, -1e-6);
                    EXPECT_LE(tick.pixel, 500 + 1e-6);
                }
                for (std::size_t i = 1; i < labels.size(); ++i)
                    EXPECT_NE(labels[i].label, labels[i - 1].label) << least << " times " << widest;
            }
        }
    }
}

TEST(ReportAxis, LinearTicksStandAtTheirNumbers) {
    const PlotAxis axis(false, {-0.3, 0.7}, 0, 100);
    for (const auto& [pixel, label] : axis.ticks()) {
        const bool negative = label.starts_with("−");
        const double value = std::stod(negative ? label.substr(std::string("−").size()) : label);
        EXPECT_NEAR(pixel, axis.pixel(negative ? -value : value), 1e-9) << label;
    }
    EXPECT_EQ(PlotAxis(false, {0.1, 1}, 0, 100).ticks().front().label, "0") << "zero is near, so it is shown";
}

TEST(ReportAxis, EqualValuesLieInTheMiddle) {
    EXPECT_NEAR(PlotAxis(true, {3e-5, 3e-5}, 0, 100).pixel(3e-5), 50, 1e-9);
    EXPECT_NEAR(PlotAxis(false, {-2}, 0, 100).pixel(-2), 50, 1e-9);
    EXPECT_NEAR(PlotAxis(false, {0}, 0, 100).pixel(0), 50, 1e-9);
}

TEST(ReportAxis, ShowsWhatItCan) {
    const double infinity = std::numeric_limits<double>::infinity();
    const PlotAxis logarithmic(true, {0, -1, 1, 100, infinity, std::nan("")}, 0, 110);
    EXPECT_NEAR(logarithmic.pixel(1), 5, 1e-9);
    EXPECT_FALSE(logarithmic.shows(0));
    EXPECT_FALSE(logarithmic.shows(-1));
    EXPECT_FALSE(logarithmic.shows(infinity));
    const PlotAxis linear(false, {-1, 1}, 0, 1);
    EXPECT_TRUE(linear.shows(-1));
    EXPECT_FALSE(linear.shows(std::nan("")));
    EXPECT_TRUE(PlotAxis(true, {0, -1}, 0, 1).ticks().empty());
}

}  // namespace
