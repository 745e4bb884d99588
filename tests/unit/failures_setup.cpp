// What a component throws before a run is told at its place in the scene, and nothing is run.

#include "failures_fixture.hpp"

namespace matpoint {
namespace {

struct Place {
    const char* name;
    const char* at;
    const char* own;
};

class FailureBefore : public Failures, public testing::WithParamInterface<Place> {
  protected:
    static Json faulty(const std::string& where, const std::string& how) {
        Json scene = bar();
        Json own = Json::parse(GetParam().own);
        own["where"] = where;
        own["how"] = how;
        scene[Json::json_pointer(GetParam().at)] = own;
        return scene;
    }
    void expect_told(const std::string& where, const std::string& text) {
        const std::vector<Diagnostic> mistakes = refused(faulty(where, "int"));
        ASSERT_EQ(mistakes.size(), 1U) << where;
        EXPECT_EQ(mistakes[0].pointer, GetParam().at);
        EXPECT_GT(mistakes[0].line, 0);
        const std::string type = Json::parse(GetParam().own).at("type");
        EXPECT_SAYS(mistakes[0].message, "\"" + type + "\" of plugin \"faulty\" 0.0.1 failed in " + text);
        EXPECT_SAYS(mistakes[0].message, "type int");
    }
};

TEST_P(FailureBefore, IsToldAtItsPlace) {
    expect_told("constructor", "its constructor");
    expect_told("rule", "the rule \"fails itself\" of its schema");
}

TEST_P(FailureBefore, LackOfMemoryNamesWhoNeedsIt) {
    try {
        Simulation::create(scene(faulty("constructor", "bad_alloc")), catalogue);
        FAIL() << "made";
    } catch (const ComponentFailure& failure) {
        EXPECT_TRUE(failure.out_of_memory());
        EXPECT_SAYS(std::string(failure.what()), GetParam().at);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Components, FailureBefore,
    testing::Values(Place{"material", "/materials/stuff",
                          R"({"type": "faulty_material", "density": 1000, "stiffness": 1000})"},
                    Place{"load", "/loads/0", R"({"type": "faulty_load"})"},
                    Place{"condition", "/boundary_conditions/0",
                          R"({"type": "faulty_condition", "on": "x_min"})"},
                    Place{"integrator", "/integrator", R"({"type": "faulty_integrator"})"},
                    Place{"geometry", "/bodies/bar/geometry", R"({"type": "faulty_geometry"})"},
                    Place{"solution", "/exact_solution", R"({"type": "faulty_solution", "body": "bar"})"},
                    Place{"output", "/outputs/0", R"({"type": "faulty_output"})"}),
    [](const auto& which) { return which.param.name; });

TEST_F(Failures, AllThatFailBeforeARunAreToldAtOnce) {
    Json text = bar();
    text["materials"]["stuff"]["where"] = "constructor";
    text["loads"] = {{{"type", "faulty_load"}, {"where", "constructor"}, {"how", "logic_error"}}};
    EXPECT_EQ(refused(text).size(), 2U);
}

TEST_F(Failures, FunctionsThatAreCalledBeforeARunAreNamed) {
    const auto message = [&](const char* pointer, const Json& own) {
        Json text = bar();
        text[Json::json_pointer(pointer)] = own;
        const std::vector<Diagnostic> mistakes = refused(text);
        return mistakes.empty() ? "" : mistakes[0].pointer + ": " + mistakes[0].message;
    };
    EXPECT_SAYS(message("/loads/0", {{"type", "faulty_load"}, {"where", "declare"}}),
                "/loads/0: load \"faulty_load\" of plugin \"faulty\" 0.0.1 failed in its declare");
    EXPECT_SAYS(message("/loads/0", {{"type", "faulty_load"}, {"where", "start"}}), "failed in its start");
    EXPECT_SAYS(message("/outputs/0", {{"type", "faulty_output"}, {"where", "check"}}),
                "failed in its check");
    const Json geometry{{"type", "faulty_geometry"}, {"where", "contains"}};
    EXPECT_SAYS(message("/bodies/bar/geometry", geometry),
                "/bodies/bar/geometry: geometry \"faulty_geometry\" of plugin \"faulty\" 0.0.1 failed");
    // The one that failed, not the one that has it.
    EXPECT_SAYS(
        message("/bodies/bar/geometry",
                {{"type", "union"}, {"of", {{{"type", "box"}, {"min", {0}}, {"max", {1}}}, geometry}}}),
        "/bodies/bar/geometry/of/1: geometry \"faulty_geometry\"");
}

}  // namespace
}  // namespace matpoint
