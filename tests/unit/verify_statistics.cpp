// Numbers taken from a probe's file, on files written by hand.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "verify/check.hpp"

namespace {

using namespace matpoint;
namespace fs = std::filesystem;

class Statistics : public testing::Test {
  protected:
    Statistics() {
        std::string name = (fs::temp_directory_path() / "matpoint_verify_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~Statistics() override { fs::remove_all(folder); }

    Json resolve(const Json& check, Diagnostics& mistakes) {
        Document document = parse_document("{}", "test.json");
        document.json = {{"checks", Json::array({check})}};
        return validate_checks(document, document.json["checks"], "/checks", mistakes);
    }

    CheckResult evaluate(Json check, const std::string& table) {
        std::ofstream(folder / "p.csv") << table;
        check["probe"] = "p";
        Diagnostics mistakes;
        const Json resolved = resolve(check, mistakes);
        EXPECT_FALSE(mistakes.has_errors()) << mistakes.text();
        return evaluate_check(
            resolved.at(0),
            {.scene = scene, .catalogue = catalogue, .output = folder, .folder = folder, .result = result});
    }

    fs::path folder;
    Scene scene;
    PluginCatalogue catalogue{PluginIndex({})};
    RunResult result;
};

// Rises through 1 at t = 3 and falls below it again at t = 7.
const char* const hump = "time,x\n0,0\n1,0.5\n3,1.5\n4,4\n7,0.5\n8,-2\n";

TEST_F(Statistics, MeanAndExtremesOfTheRowsInAWindow) {
    EXPECT_TRUE(evaluate({{"statistic", "mean"}, {"from", 1}, {"to", 4}, {"equals", 2}}, hump).holds);
    EXPECT_TRUE(evaluate({{"statistic", "max"}, {"equals", 4}}, hump).holds);
    EXPECT_TRUE(evaluate({{"statistic", "min"}, {"equals", -2}}, hump).holds);
    EXPECT_TRUE(evaluate({{"statistic", "max"}, {"from", 5}, {"equals", 0.5}}, hump).holds);
    EXPECT_FALSE(evaluate({{"statistic", "mean"}, {"from", 9}, {"below", 1e9}}, hump).holds)
        << "no rows is no success";
}

TEST_F(Statistics, TimesAtALevel) {
    EXPECT_TRUE(evaluate({{"statistic", "last"}, {"equals", 4}}, "time,x\n0,0\n1,nan\n2,4\n").holds);
    EXPECT_FALSE(evaluate({{"statistic", "last"}, {"below", 9}}, "time,x\n0,0\n1,nan\n").holds);
    EXPECT_TRUE(evaluate({{"statistic", "first_time_above"}, {"level", 1}, {"equals", 3}}, hump).holds);
    EXPECT_TRUE(
        evaluate({{"statistic", "first_time_below"}, {"level", 1}, {"from", 2}, {"equals", 7}}, hump).holds);
    EXPECT_TRUE(evaluate({{"statistic", "total_time_above"}, {"level", 1}, {"equals", 4}}, hump).holds);
    EXPECT_TRUE(evaluate({{"statistic", "total_time_below"}, {"level", 1}, {"equals", 4}}, hump).holds);
    EXPECT_FALSE(evaluate({{"statistic", "first_time_above"}, {"level", 5}, {"above", 0}}, hump).holds)
        << "a level that is never passed has no time";
}

TEST_F(Statistics, BoundsAndTolerances) {
    const Json mean{{"statistic", "max"}, {"equals", 4.1}};
    Json near = mean;
    near["absolute"] = 0.11;
    EXPECT_FALSE(evaluate(mean, hump).holds);
    EXPECT_TRUE(evaluate(near, hump).holds);
    const CheckResult above = evaluate({{"statistic", "max"}, {"above", 4}}, hump);
    EXPECT_FALSE(above.holds);
    EXPECT_EQ(above.measured, "max of p: 4 not > 4");
}

TEST_F(Statistics, WhatIsNotANumberFails) {
    for (const char* name : {"mean", "min", "max"}) {
        EXPECT_FALSE(evaluate({{"statistic", name}, {"below", 1e9}}, "time,x\n0,0\n1,nan\n2,2\n").holds)
            << name;
    }
}

TEST_F(Statistics, ALevelBelongsToTimes) {
    for (const Json& check : {Json{{"statistic", "first_time_above"}, {"probe", "p"}, {"below", 1}},
                              Json{{"statistic", "mean"}, {"level", 1}, {"probe", "p"}, {"below", 1}}}) {
        Diagnostics mistakes;
        resolve(check, mistakes);
        EXPECT_TRUE(mistakes.has_errors()) << check;
    }
}

}  // namespace
