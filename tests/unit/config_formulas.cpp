// Formulas: what they know is what their page says; where they have no value, and where they may not stand.
#include "config/formula_places.hpp"
#include "config_example.hpp"

#include <gtest/gtest.h>
#include <muParser.h>

#include <fstream>
#include <iterator>
#include <regex>

namespace matpoint {
namespace {

std::string page() {
    std::ifstream file(MATPOINT_FORMULAS_PAGE);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(formulas, have_the_values_that_their_page_says) {
    static const std::regex row(R"(\| `([^`]+)` \| (-?[0-9.]+) \|\n)");
    const std::string text = page();
    int rows = 0;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), row); match != std::sregex_iterator();
         ++match) {
        EXPECT_NEAR(Profile(Json((*match)[1].str()))({}, 0), std::stod((*match)[2]), 1e-14) << (*match)[1];
        ++rows;
    }
    EXPECT_EQ(rows, 21);
}

TEST(formulas, know_the_functions_on_their_page_and_no_others) {
    const std::string text = page();
    const mu::Parser parser;
    for (const auto& function : parser.GetFunDef())
        EXPECT_TRUE(std::regex_search(text, std::regex("`" + function.first + "[(`]"))) << function.first;
}

TEST(formulas, say_what_they_depend_on) {
    EXPECT_EQ(Profile(Json("x*t + 0*z")).variables(), "txz");
    EXPECT_EQ(Profile(Json("2*pi")).variables(), "");
    EXPECT_EQ(Profile(Json(3)).variables(), "");
    EXPECT_EQ(Profile(Json{{"times", {0}}, {"values", {1}}}).variables(), "t");
    const Profile kept(Json("x < 1 ? t : y"));
    EXPECT_EQ(kept.variables(), "txy");
    EXPECT_EQ(kept({0, 5, 0}, 7), 7) << "after it was asked";
}

TEST(formulas, name_themselves_the_time_and_the_place_where_they_have_no_value) {
    const Profile formula(Json("x/t"));
    EXPECT_EQ(formula({1, 2, 3}, 2), 0.5);
    try {
        formula({1, 2, 3}, 0);
        FAIL();
    } catch (const FormulaError& error) {
        EXPECT_STREQ(error.what(), "the formula \"x/t\" is infinite at t = 0 s, x = 1 m");
        EXPECT_EQ(error.formula(), "x/t");
    }
    EXPECT_THROW(Profile(Json("sqrt(0.1 - t)"))({}, 0.2), FormulaError);
}

TEST(formulas, are_found_in_a_scene_but_not_in_its_checks) {
    const Json scene{{"loads", {{{"a", {1, "1/t"}}}, {{"b/c", "1/t"}}}}, {"checks", {{{"formula", "1/t"}}}}};
    EXPECT_EQ(formula_places(scene, "1/t"), (std::vector<std::string>{"/loads/0/a/1", "/loads/1/b~1c"}));
}

TEST(formulas, may_depend_only_on_what_means_something_in_their_place) {
    const std::string velocity = "/boundary_conditions/1/value=";
    const auto says = [](const std::string& setting, const std::string& expected) {
        const std::string all = complaints({setting});
        EXPECT_NE(all.find(expected), std::string::npos) << "expected: " << expected << "\ngot: " << all;
    };
    says(velocity + "[\"z\", null]",
         "/boundary_conditions/1/value/0: expected a number, a formula of x, y, t, or {\"times\": [...], "
         "\"values\": "
         "[...]} (m/s), got \"z\", which depends on z");
    says("/bodies/disk/velocity=[\"x*t\", 0]",
         "/bodies/disk/velocity/0: expected a number or a formula of x, y (m/s), got \"x*t\", which depends "
         "on t");
    says("/bodies/disk/velocity=[{\"times\": [0, 1], \"values\": [0, 1]}, 0]",
         "/bodies/disk/velocity/0: expected a number or a formula of x, y (m/s), got {\"times\"");
    EXPECT_EQ(complaints({velocity + "[\"x + y + t\", null]", "/bodies/disk/velocity=[\"x + y\", 1]"}), "");
}

TEST(formulas, have_a_value_at_all_times_of_the_run) {
    const auto complaint = [](const std::string& formula) {
        return complaints({"/boundary_conditions/1/value/1=" + formula});
    };
    const auto refused = [&](const std::string& formula, const std::string& when) {
        EXPECT_NE(complaint(formula).find("error: /boundary_conditions/1/value/1: the formula \"" + formula +
                                          "\" is " + when),
                  std::string::npos)
            << complaint(formula);
    };
    // The run ends at 0.01 s.
    refused("1/t", "infinite at t = 0 s");
    refused("1/(0.01 - t)", "infinite at t = 0.01 s");
    refused("sqrt(0.00805 - t)", "not a number at t = 0.0081 s");
    refused("ln(0 - 1)", "not a number at t = 0 s");
    refused("x/t", "infinite at t = 0 s, x = ");
    EXPECT_EQ(complaint("sqrt(0.0101 - t)"), "");
    EXPECT_EQ(complaint("t == 0 ? 1 : sin(t)/t"), "");
    EXPECT_EQ(complaint("sqrt(1e-4 - x^2)"), "") << "it may be meant for a region where it has one";
    EXPECT_EQ(complaint("1/(x - 0.5)"), "");
}

}  // namespace
}  // namespace matpoint
