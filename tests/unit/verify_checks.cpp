// Checks of what must hold after a run, on results written by hand.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "verify/check.hpp"

namespace {

using namespace matpoint;
namespace fs = std::filesystem;

class Checks : public testing::Test {
  protected:
    Checks() {
        std::string name = (fs::temp_directory_path() / "matpoint_verify_XXXXXX").string();
        folder = mkdtemp(name.data());
        result.summary = {{"steps", 50}, {"conservation", {{"mass_drift", 1e-9}}}, {"bad", nullptr}};
    }
    ~Checks() override { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
    }

    /// Of a check as it stands in a file.
    CheckResult evaluate(const Json& check, bool update_gold = false) {
        const Document document = parse_document("{}", "test.json");
        Document whole = document;
        whole.json = {{"checks", Json::array({check})}};
        Diagnostics mistakes;
        const Json resolved = validate_checks(whole, whole.json["checks"], "/checks", mistakes);
        EXPECT_FALSE(mistakes.has_errors()) << mistakes.text();
        return evaluate_check(resolved.at(0), {.scene = scene,
                                               .catalogue = catalogue,
                                               .output = folder,
                                               .folder = folder,
                                               .result = result,
                                               .update_gold = update_gold});
    }

    fs::path folder;
    Scene scene;
    PluginCatalogue catalogue{PluginIndex({})};
    RunResult result;
};

TEST_F(Checks, ProbeComparesWithTheLargestValueExpected) {
    write("x.csv", "time,x\n0,0\n1,2.1\n2,4\n");
    // Off by 0.1 where 4 is the largest value: 0.025.
    EXPECT_TRUE(evaluate({{"probe", "x"}, {"formula", "2*t"}, {"relative", 0.026}}).holds);
    const CheckResult off = evaluate({{"probe", "x"}, {"formula", "2*t"}, {"relative", 0.024}});
    EXPECT_FALSE(off.holds);
    EXPECT_EQ(off.measured, "x: relative 0.025 > 0.024");
    EXPECT_EQ(off.where, "at t = 1 s it is 2.1, expected 2");
    EXPECT_TRUE(evaluate({{"probe", "x"}, {"formula", "2*t"}, {"absolute", 0.11}}).holds);
    EXPECT_FALSE(evaluate({{"probe", "x"}, {"formula", "2*t"}, {"absolute", 0.09}}).holds);
}

TEST_F(Checks, ProbeKeepsToTheTimesAndTheColumnAskedFor) {
    write("p.csv", "time,x,y\n0,9,0\n1,9,1\n2,9,7\n");
    const Json check{{"probe", "p"}, {"column", "y"}, {"formula", "t"}, {"absolute", 1e-12}};
    EXPECT_FALSE(evaluate(check).holds);
    Json early = check;
    early["to"] = 1.5;
    EXPECT_TRUE(evaluate(early).holds);
    Json late = check;
    late["from"] = 5;
    EXPECT_FALSE(evaluate(late).holds) << "no rows is no success";
    Json none = check;
    none.erase("column");
    EXPECT_NE(evaluate(none).measured.find("x, y"), std::string::npos);
}

TEST_F(Checks, ProbeThatIsNotANumberFails) {
    write("x.csv", "time,x\n0,0\n1,nan\n2,2\n");
    EXPECT_FALSE(evaluate({{"probe", "x"}, {"formula", "t"}, {"absolute", 1e9}}).holds);
}

TEST_F(Checks, MissingProbeFails) {
    const CheckResult missing = evaluate({{"probe", "none"}, {"formula", "t"}, {"absolute", 1}});
    EXPECT_FALSE(missing.holds);
    EXPECT_NE(missing.measured.find("none.csv"), std::string::npos);
}

TEST_F(Checks, SummaryBounds) {
    const auto with = [&](Json bounds) {
        bounds["summary"] = "/steps";
        return evaluate(bounds).holds;
    };
    EXPECT_TRUE(with({{"below", 51}}));
    EXPECT_FALSE(with({{"below", 50}}));
    EXPECT_TRUE(with({{"above", 49}, {"below", 51}}));
    EXPECT_FALSE(with({{"above", 49}, {"below", 50}}));
    EXPECT_TRUE(with({{"equals", 50}}));
    EXPECT_FALSE(with({{"equals", 51}}));
    EXPECT_TRUE(with({{"equals", 51}, {"absolute", 1}}));
    EXPECT_FALSE(with({{"equals", 51}, {"relative", 0.01}}));
    // A number that is not finite is null in JSON, and within no bound.
    EXPECT_FALSE(evaluate({{"summary", "/bad"}, {"below", 1}}).holds);
    const CheckResult misspelt = evaluate({{"summary", "/conservation/mas_drift"}, {"below", 1}});
    EXPECT_FALSE(misspelt.holds);
    EXPECT_NE(misspelt.measured.find("did you mean \"/conservation/mass_drift\""), std::string::npos);
}

TEST_F(Checks, GoldComparesColumnsByName) {
    write("p.csv", "time,x,y\n0,1,10\n1,2,20\n");
    write("gold.csv", "time,y,x\n0,10,1\n1,20.1,2\n");
    const Json check{{"gold", "gold.csv"}, {"probe", "p"}, {"relative", 0.01}};
    EXPECT_TRUE(evaluate(check).holds);
    Json narrow = check;
    narrow["relative"] = 0.001;
    const CheckResult off = evaluate(narrow);
    EXPECT_FALSE(off.holds);
    EXPECT_NE(off.measured.find("p.y"), std::string::npos) << off.measured;
    EXPECT_NE(off.where.find("row 2 is 20"), std::string::npos) << off.where;

    write("gold.csv", "time,y,x\n0,10,1\n");
    EXPECT_FALSE(evaluate(check).holds) << "fewer rows";
    write("gold.csv", "time,y\n0,10\n1,20\n");
    EXPECT_FALSE(evaluate(check).holds) << "a column is missing";
}

TEST_F(Checks, GoldIsWrittenOnlyWhenAskedFor) {
    write("p.csv", "time,x\n0,1\n");
    const Json check{{"gold", "kept/gold.csv"}, {"probe", "p"}, {"absolute", 0}};
    const CheckResult missing = evaluate(check);
    EXPECT_FALSE(missing.holds);
    EXPECT_NE(missing.measured.find("--update-gold"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "kept"));
    EXPECT_TRUE(evaluate(check, true).holds);
    EXPECT_TRUE(evaluate(check).holds);
}

/// What is said about a list of checks in a file.
std::string mistakes_in(const std::string& checks) {
    const Document document = parse_document("{\"checks\":\n" + checks + "}", "a.json");
    Diagnostics mistakes;
    validate_checks(document, document.json.at("checks"), "/checks", mistakes);
    return mistakes.text();
}

TEST(ValidateChecks, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(mistakes_in(R"([{"probe": "x", "formula": "t", "absolute": 1}])"), "");
    const std::string unknown = mistakes_in(R"([{"prob": "x", "formula": "t", "absolute": 1}])");
    EXPECT_NE(unknown.find("a.json:2:2:"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("did you mean \"probe\""), std::string::npos) << unknown;
    EXPECT_NE(mistakes_in(R"([{"probe": "x", "formula": "t +", "absolute": 1}])").find("/checks/0/formula"),
              std::string::npos);
    EXPECT_NE(mistakes_in(R"([{"probe": "x", "formula": "t"}])").find("how large a deviation"),
              std::string::npos);
    EXPECT_NE(mistakes_in(R"([{"summary": "/steps"}])").find("what must hold"), std::string::npos);
    EXPECT_NE(mistakes_in(R"([{"summary": "steps", "below": 1}])").find("/checks/0/summary"),
              std::string::npos);
    EXPECT_NE(mistakes_in(R"({"probe": "x"})").find("list of checks"), std::string::npos);
    EXPECT_NE(mistakes_in(R"([7])").find("/checks/0"), std::string::npos);
    const std::string two = mistakes_in(R"([{"summary": "/a", "belo": 1}, {"probe": "x", "formla": "t"}])");
    EXPECT_NE(two.find("/checks/0/belo"), std::string::npos) << two;
    EXPECT_NE(two.find("/checks/1/formla"), std::string::npos) << two;
}

}  // namespace
