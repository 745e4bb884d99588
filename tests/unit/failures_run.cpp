// What a component throws in a run names it, and leaves the last good state.

#include "failures_fixture.hpp"

namespace matpoint {
namespace {

bool same_particles(const CheckpointData& a, const CheckpointData& b) {
    return std::ranges::equal(a.bodies, b.bodies, [](const auto& x, const auto& y) {
        return x.ids == y.ids && std::ranges::equal(x.columns, y.columns, [](const auto& p, const auto& q) {
                   return p.field == q.field && p.component == q.component && p.values == q.values;
               });
    });
}

struct Case {
    const char* name;
    const char* at;  ///< JSON pointer
    const char* own;
    const char* function;
    long good_step;  ///< that of the last good state
};

class FailureIn : public Failures, public testing::WithParamInterface<Case> {
  protected:
    /// With the component of the case, which throws `how`.
    static Json faulty(const std::string& how) {
        Json scene = bar();
        Json own = Json::parse(GetParam().own);
        own["where"] = GetParam().function;
        own["how"] = how;
        scene[Json::json_pointer(GetParam().at)] = own;
        if (scene.contains("exact_solution")) scene["bodies"]["bar"].erase("velocity");  // it gives one
        return scene;
    }
    static std::string type() { return Json::parse(GetParam().own).at("type"); }
};

TEST_P(FailureIn, IsToldWithItsPluginAndPointerAndLeavesTheLastGoodState) {
    const std::pair<const char*, const char*> thrown[] = {
        {"int", "something of type int, which is no std::exception"},
        {"exception", "std::exception"},
        {"bad_alloc", "not enough memory"},
        {"logic_error", "std::logic_error: two and two are five"}};
    for (const auto& [how, text] : thrown) {
        SCOPED_TRACE(how);
        const RunResult result = run(faulty(how));
        EXPECT_EQ(result.summary.at("status"), "broke_down");
        EXPECT_EQ(result.exit_status(), 1);
        EXPECT_SAYS(result.reason, GetParam().at);
        EXPECT_SAYS(result.reason, "\"" + type() + "\" of plugin \"faulty\" 0.0.1 failed in its ");
        EXPECT_SAYS(result.reason, text);
        EXPECT_SAYS(result.reason, "step ");
        EXPECT_SAYS(result.reason, " is saved in " + (folder / "out" / "checkpoints").string());

        const CheckpointData state = saved();
        EXPECT_EQ(state.step, GetParam().good_step);
        Json harmless = faulty("not at all");
        harmless["time"]["end"] = 1;
        run(harmless, state.step);
        EXPECT_TRUE(same_particles(state, saved()));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Components, FailureIn,
    testing::Values(
        Case{"material", "/materials/stuff",
             R"({"type": "faulty_material", "density": 1000, "stiffness": 1000, "from": 3.1042})", "update",
             5},
        Case{"wave_speed", "/materials/stuff",
             R"({"type": "faulty_material", "density": 1000, "stiffness": 1000, "from": 3.1042})",
             "wave_speed", 5},
        Case{"load", "/loads/0", R"({"type": "faulty_load", "from": 0.0045})", "apply", 5},
        Case{
            "condition", "/boundary_conditions/0",
            R"({"type": "faulty_condition", "from": 0.0045, "on": {"type": "box", "min": [0.5], "max": [0.6]}})",
            "velocity", 4},
        Case{"integrator", "/integrator", R"({"type": "faulty_integrator", "from": 0.0045})", "step", 5},
        Case{"solution", "/exact_solution", R"({"type": "faulty_solution", "body": "bar", "from": 0.0045})",
             "displacement", 4},
        Case{"open", "/outputs/0", R"({"type": "faulty_output"})", "open", 0},
        Case{"write", "/outputs/0", R"({"type": "faulty_output", "from": 0.0045, "every_steps": 1})", "write",
             5},
        Case{"flush", "/outputs/0", R"({"type": "faulty_output"})", "flush", 20}),
    [](const auto& which) { return which.param.name; });

TEST_F(Failures, WhatAnOutputCannotWriteIsNoBreakdown) {
    Json text = bar();
    text["outputs"] = {{{"type", "faulty_output"},
                        {"where", "write"},
                        {"how", "runtime_error"},
                        {"from", 0.0045},
                        {"every_steps", 1}}};
    const RunResult result = run(text);
    EXPECT_EQ(result.status, RunStatus::unfinished);
    EXPECT_SAYS(result.reason,
                "/outputs/0: output \"faulty_output\" of plugin \"faulty\" 0.0.1: the disk is on fire");
    EXPECT_EQ(saved().step, 5);
}

}  // namespace
}  // namespace matpoint
