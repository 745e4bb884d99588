// Files of studies: what they ask for, and mistakes in them, all at once and located.

#include "study_fixture.hpp"

#include "config/diagnostics.hpp"
#include "study/variants.hpp"

namespace {

using namespace matpoint;

constexpr const char* accuracy = R"("accuracy": {"summary": "/error/linf"})";

class StudyFiles : public StudyFolder {
  protected:
    std::string told(const std::string& members) const {
        try {
            study(members);
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    }
    void expect_told(const std::string& members, const std::string& part) const {
        const std::string text = told(members);
        EXPECT_NE(text.find(part), std::string::npos) << members << "\n" << text;
    }
    void expect_limits_told(const std::string& members, const std::string& part) const {
        const auto file = write("l.json", "{\"scene\": \"scene.json\", " + members + "}");
        try {
            read_limits_file(file);
            FAIL() << "nothing is told about " << members;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
};

TEST_F(StudyFiles, AllCombinationsAreVariants) {
    const StudyFile file = study(std::string(accuracy) + R"(, "set": {"/time/end": 1},
        "variants": {"fast": {"/integrator/type": "usl"}, "slow": {}},
        "vary": {"/time/cfl": {"from": 0.1, "to": 0.3, "step": 0.1}, "/grid/cell_size": [0.5], "/shape_function/type": ["linear", "gimp"]})");
    EXPECT_EQ(file.title, "s");
    EXPECT_EQ(file.scene, folder / "scene.json");
    EXPECT_EQ(file.json.at("cost").at("summary"), "/cpu_seconds");
    const std::vector<Variant> variants = make_variants(file);
    ASSERT_EQ(variants.size(), 12u);
    EXPECT_EQ(variants[0].name, "fast, cfl=0.1, shape_function=linear")
        << "what is the same in all is left out";
    EXPECT_EQ(variants[1].name, "fast, cfl=0.1, shape_function=gimp");
    EXPECT_EQ(variants[11].name, "slow, cfl=0.3, shape_function=gimp");
    EXPECT_EQ(variants[11].number, 12);
    EXPECT_EQ(
        variants[1].settings.dump(),
        R"({"/integrator/type":"usl","/time/cfl":0.1,"/grid/cell_size":0.5,"/shape_function/type":"gimp"})");
    ASSERT_EQ(variants[1].assignments.size(), 5u);
    EXPECT_EQ(variants[1].assignments[0].pointer, "/time/end") << "what is varied comes after what is set";
    EXPECT_EQ(variants[1].assignments[4].from, "/vary/~1shape_function~1type");
}

TEST_F(StudyFiles, MistakesAreToldAllAtOnce) {
    const std::string text = told(R"("acuracy": {},
"vary": {"/time/cfl": {"from": 1, "to": 2, "step": -1},
"time/end": [1], "/grid": 3},
"target": -1, "timing": "quite")");
    for (const char* part : {"did you mean \"accuracy\"", "missing key \"accuracy\"",
                             "s.json:3:", "s.json:4:", "expected a number > 0", "quiet"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST_F(StudyFiles, WhatMakesNoSenseIsRefused) {
    const std::string both = std::string(accuracy) + R"(, "vary": {"/time/cfl": [1, 2]})";
    EXPECT_EQ(told(both), "");
    expect_told(accuracy, "nothing to vary");
    expect_told(std::string(accuracy) + R"(, "vary": {"time": [1]})", "JSON pointer into the scene");
    expect_told(std::string(accuracy) + R"(, "vary": {"/time/cfl": []})",
                "expected a list of values or a range");
    expect_told(std::string(accuracy) + R"(, "vary": {"/a": {"from": 1, "to": 2}})", "`step` or `factor`");
    expect_told(std::string(accuracy) + R"(, "vary": {"/a": {"from": 1, "to": 2, "step": -1}})",
                "does not lead");
    expect_told(std::string(accuracy) + R"(, "vary": {"/a": {"from": 1, "to": 2, "factor": 0.5}})",
                "does not lead");
    expect_told(std::string(accuracy) + R"(, "vary": {"/a": {"from": -1, "to": 2, "factor": 2}})",
                "does not lead");
    expect_told(std::string(accuracy) + R"(, "vary": {"/a": {"from": 0, "to": 1, "step": 1e-9}})", "most");
    expect_told(std::string(accuracy) + R"(, "vary": {"/a": [1]}, "variants": {"b": {"/a": 2}})",
                "is varied too");
    expect_told(std::string(accuracy) + R"(, "variants": {"b": 3})", "/variants/b");
    expect_told(R"("vary": {"/a": [1]}, "accuracy": {"summary": "error"})", "JSON pointer into summary.json");
    expect_told(R"("vary": {"/a": [1]}, "accuracy": {"summary": "/error/linf", "reference": "finest"})",
                "/grid/cell_size must be in /vary");
    expect_told(both + R"(, "plots": [{"name": "a b", "x": "cost"}])", "a file is called after it");
    expect_told(both + R"(, "plots": [{"name": "a", "x": "/time/clf"}])", "did you mean \"/time/cfl\"");
    expect_told(both + R"(, "plots": [{"name": "a", "x": "cfl", "lines": ["cell_size"]}])",
                "/plots/0/lines/0");
    expect_told(both + R"(, "plots": {})", "expected a list of plots");
}

TEST_F(StudyFiles, PlotsMayNameValuesShortly) {
    const StudyFile file = study(std::string(accuracy) + R"(, "vary": {"/time/cfl": [1, 2]},
        "plots": [{"name": "a", "x": "cfl", "lines": "variant"}])");
    EXPECT_EQ(file.json.at("plots")[0].at("x"), "/time/cfl");
    EXPECT_EQ(file.json.at("plots")[0].at("y"), "error");
}

TEST_F(StudyFiles, Limits) {
    const auto good =
        write("l.json", R"({"scene": "scene.json", "stable": {"summary": "/error/linf", "below": 0.1},
        "search": {"pointer": "/time/cfl", "from": 0.1, "to": 2}})");
    EXPECT_EQ(make_variants(read_limits_file(good)).size(), 1u);
    EXPECT_EQ(read_limits_file(good).json.at("search").at("digits"), 2);
    const std::string stable = R"("stable": {"summary": "/error/linf", "below": 0.1}, )";
    expect_limits_told(stable + R"("search": {"pointer": "/time/cfl", "from": 2, "to": 1})",
                       "more than `from`");
    expect_limits_told(stable + R"("search": {"pointer": "cfl", "from": 1, "to": 2})", "/search/pointer");
    expect_limits_told(stable + R"("search": {"pointer": "/a", "from": 1, "to": 2}, "vary": {"/a": [1]})",
                       "can't be varied too");
    expect_limits_told(stable + accuracy, "missing key \"search\"");
}

}  // namespace
