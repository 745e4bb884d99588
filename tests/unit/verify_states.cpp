// Two states are the same bit for bit, or the first difference is named.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verify/compare_states.hpp"

namespace {

using namespace matpoint;

CheckpointData state() {
    CheckpointData data;
    data.step = 7;
    data.time = 0.7;
    data.numbers = {{"strain", 1.5}};
    data.bodies = {{.name = "disk",
                    .size = 2,
                    .columns = {{.field = "velocity", .component = 1, .values = std::vector<double>{1, 2}}},
                    .ids = {1, 0},
                    .block_numbers = {3},
                    .block_begins = {0, 2}}};
    return data;
}

std::vector<double>& velocity(CheckpointData& data) {
    return std::get<std::vector<double>>(data.bodies[0].columns[0].values);
}

TEST(CompareStates, SameBitsAreNoDifference) {
    CheckpointData a = state(), b = state();
    EXPECT_EQ(first_difference(a, b), "");
    // The same bits, though a NaN equals nothing.
    velocity(a)[0] = velocity(b)[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(first_difference(a, b), "");
}

TEST(CompareStates, OneBitIsADifference) {
    CheckpointData other = state();
    velocity(other)[1] = std::nextafter(2.0, 3.0);
    const std::string difference = first_difference(state(), other);
    EXPECT_NE(difference.find("velocity (component 1) of particle 1 of body disk"), std::string::npos)
        << difference;
    other = state();
    velocity(other)[1] = 0;
    CheckpointData negative = other;
    velocity(negative)[1] = -0.0;
    EXPECT_NE(first_difference(other, negative), "") << "0 and -0 are equal, but not the same";
}

TEST(CompareStates, EverythingElseCounts) {
    const auto changed = [](auto change) {
        CheckpointData other = state();
        change(other);
        return first_difference(state(), other);
    };
    EXPECT_NE(changed([](auto& s) { s.step = 8; }), "");
    EXPECT_NE(changed([](auto& s) { s.time = 0.8; }), "");
    EXPECT_NE(changed([](auto& s) { s.numbers["strain"] = 1; }), "");
    EXPECT_NE(changed([](auto& s) { s.numbers.clear(); }), "");
    EXPECT_NE(changed([](auto& s) { s.bodies[0].ids = {0, 1}; }), "");
    EXPECT_NE(changed([](auto& s) { s.bodies[0].block_begins = {0, 1}; }), "");
    EXPECT_NE(changed([](auto& s) { s.bodies[0].columns.clear(); }), "");
    EXPECT_NE(changed([](auto& s) { s.bodies[0].columns[0].field = "position"; }), "");
    EXPECT_NE(changed([](auto& s) { s.bodies.clear(); }), "");
}

}  // namespace
