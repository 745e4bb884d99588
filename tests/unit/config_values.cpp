#include "config/nearest.hpp"
#include "config/units.hpp"

#include <matpoint/profile.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace matpoint {
namespace {

std::string unit_error(std::string_view text, const std::string& unit) {
    try {
        Units().to_si(text, unit);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "no error";
}

TEST(units, are_converted_to_the_declared_one) {
    Units units;
    EXPECT_DOUBLE_EQ(units.to_si("70 GPa", "Pa"), 70e9);
    EXPECT_DOUBLE_EQ(units.to_si("10ms", "s"), 0.01);
    EXPECT_DOUBLE_EQ(units.to_si(" 1.2 g/cm^3 ", "kg/m^3"), 1200);
    EXPECT_DOUBLE_EQ(units.to_si("36 km/h", "m/s"), 10);
    EXPECT_DOUBLE_EQ(units.to_si("-1 cm/s^2", "m/s^2"), -0.01);
    EXPECT_DOUBLE_EQ(units.to_si("2 kN", "N"), 2000);
    EXPECT_DOUBLE_EQ(units.to_si("5 1/ms", "1/s"), 5000);
    EXPECT_DOUBLE_EQ(units.to_si("3 Hz", "1/s"), 3);
    EXPECT_DOUBLE_EQ(units.to_si("20 %", ""), 0.2);
    EXPECT_NEAR(units.to_si("30 degrees", ""), std::acos(-1.0) / 6, 1e-15);
    EXPECT_DOUBLE_EQ(units.to_si("4.2e6", "Pa"), 4.2e6);
}

TEST(units, say_what_is_wrong_and_print_nothing) {
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(unit_error("10 kg", "s"), "\"10 kg\" is not convertible to s");
    EXPECT_EQ(unit_error("70 GPaa", "Pa"), "unknown unit \"GPaa\"");
    EXPECT_EQ(unit_error("10 s", ""), "\"10 s\" is not convertible to a number without unit");
    EXPECT_EQ(unit_error("10 5", ""), "unknown unit \"5\"");
    EXPECT_EQ(unit_error("fast", "m/s"), "\"fast\" doesn't start with a number");
    EXPECT_EQ(unit_error("", "m/s"), "\"\" doesn't start with a number");
    EXPECT_EQ(unit_error("nan", "s"), "\"nan\" is not a finite number");
    EXPECT_EQ(unit_error("1e308 GPa", "Pa"), "\"1e308 GPa\" is not a finite number");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(nearest, is_at_a_small_edit_distance) {
    EXPECT_EQ(nearest("dsk", {"plane", "disk"}), "disk");
    EXPECT_EQ(nearest("gmip", {"linear", "gimp"}), "gimp");
    EXPECT_EQ(nearest("poisson_ratio", {"youngs_modulus", "poissons_ratio"}), "poissons_ratio");
    EXPECT_EQ(nearest("usx", {"usf", "usl"}), "usf") << "the first of equals";
    EXPECT_EQ(nearest("musll", {"usl", "musl"}), "musl");
    EXPECT_EQ(nearest("sphere", {"box", "disk"}), std::nullopt);
    EXPECT_EQ(nearest("ab", {"xy"}), std::nullopt);
}

TEST(nearest, is_offered_or_all_are_listed) {
    EXPECT_EQ(did_you_mean("dsk", {"plane", "disk"}), "; did you mean \"disk\"?");
    EXPECT_EQ(did_you_mean("sphere", {"a", "b", "c"}), "; expected one of a, b, c");
    EXPECT_EQ(did_you_mean("sphere", std::vector<std::string>(21, "a")), "");
    EXPECT_EQ(did_you_mean("sphere", {}), "");
}

TEST(profile, is_a_number_a_formula_or_a_table) {
    EXPECT_EQ(Profile(Json(3))({1, 2, 3}, 4), 3);
    const Profile formula{Json("x + 10*y + 100*z + 1000*t + sin(pi/2)")};
    EXPECT_DOUBLE_EQ(formula({1, 2, 3}, 4), 4322);
    EXPECT_EQ(Profile(Json("t < 1 ? 5 : 6"))({0, 0, 0}, 2), 6);
    const Profile table(Json{{"times", {0, 1, 3}}, {"values", {0, 10, -10}}});
    EXPECT_DOUBLE_EQ(table({}, -1), 0);
    EXPECT_DOUBLE_EQ(table({}, 0.25), 2.5);
    EXPECT_DOUBLE_EQ(table({}, 1), 10);
    EXPECT_DOUBLE_EQ(table({}, 2), 0);
    EXPECT_DOUBLE_EQ(table({}, 99), -10);
}

TEST(profile, can_be_copied_and_moved) {
    Profile a(Json("2*x"));
    const Profile b = a;
    Profile c = std::move(a);
    a = Profile(Json(7));
    EXPECT_EQ(b({3, 0, 0}, 0), 6);
    EXPECT_EQ(c({4, 0, 0}, 0), 8);
    EXPECT_EQ(a({4, 0, 0}, 0), 7);
    c = b;
    EXPECT_EQ(c({5, 0, 0}, 0), 10);
}

TEST(profile, refuses_what_has_no_value) {
    for (const char* formula : {"", "2*", "w", "x = 3", "1, 2", "sin()", "x y", "\"text\""}) {
        EXPECT_THROW(Profile{Json(formula)}, std::invalid_argument) << formula;
    }
    EXPECT_THROW(Profile{Json(nullptr)}, std::invalid_argument);
    EXPECT_THROW(Profile(Json{{"times", {0, 0}}, {"values", {1, 2}}}), std::invalid_argument);
    EXPECT_THROW(Profile(Json{{"times", {0, 1}}, {"values", {1}}}), std::invalid_argument);
    EXPECT_THROW(Profile(Json{{"times", Json::array()}, {"values", Json::array()}}), std::invalid_argument);
    EXPECT_NO_THROW(Profile{Json("x >= 1 && y == 2 ? 1 : 0")});
}

}  // namespace
}  // namespace matpoint
