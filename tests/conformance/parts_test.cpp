// Conditions that parts of bodies carry with them.
#include "every_plugin.hpp"
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace matpoint::conformance {
namespace {

/// A bar of rubber, held or driven at its ends by conditions to come.
Json bar() {
    return Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [3, 1], "cell_size": 0.1},
        "time": {"end": 100, "step": 2e-3},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}},
        "bodies": {"bar": {"material": "rubber", "geometry": {"type": "box", "min": [0.5, 0.3], "max": [1.7, 0.7]}}},
        "outputs": [{"type": "csv", "fields": ["velocity", "displacement_gradient"]}]
    })json");
}
Json part(double low, double high) {
    return {{"body", "bar"}, {"within", {{"type", "box"}, {"min", {low, 0}}, {"max", {high, 1}}}}};
}

TEST(BodyPart, AWholeBodyMovesAsItIsTold) {
    Json scene = bar();
    scene["boundary_conditions"] = {
        {{"type", "velocity"}, {"on", {{"body", "bar"}}}, {"velocity", {3, "-1 - 20*t"}}}};
    with_every_scheme(scene, [](const Json& own) {
        Simulated run(own);
        const auto x = run->column("bar", "position", 0), y = run->column("bar", "position", 1);
        run.advance(50);
        const auto moved_x = run->column("bar", "position", 0), moved_y = run->column("bar", "position", 1);
        for (std::size_t p = 0; p < x.size(); ++p) {
            EXPECT_NEAR(moved_x[p] - x[p], 0.3, 1e-12);
            EXPECT_NEAR(moved_y[p] - y[p], moved_y[0] - y[0], 1e-12);
        }
        EXPECT_NEAR(moved_y[0] - y[0], -0.1 - 0.1, 0.003);
        for (int c = 0; c < 4; ++c)
            for (const double h : run->column("bar", "displacement_gradient", c)) EXPECT_NEAR(h, 0, 1e-11);
        EXPECT_LT(run->conservation().momentum_drift, 1e-11);
    });
}

// Edges on lines of nodes: a part that stays is a region.
TEST(BodyPart, OneThatStaysIsARegion) {
    Json scene = bar();
    scene["bodies"]["bar"]["velocity"] = {"x > 1 ? 0.5*(x - 1) : 0", 0};
    with_every_scheme(scene, [](Json own) {
        const auto moved = [&](const Json& on) {
            own["boundary_conditions"] = {{{"type", "fixed"}, {"name", "clamp"}, {"on", on}}};
            Simulated run(own);
            run.advance(60);
            EXPECT_GT(std::abs(run->reaction("clamp")[0]), 1);
            EXPECT_LT(run->conservation().momentum_drift, 1e-12);
            return run->column("bar", "position", 0);
        };
        EXPECT_EQ(moved(part(0, 0.9)), moved({{"type", "box"}, {"min", {0, 0}}, {"max", {0.91, 1}}}));
    });
}

// Two grips draw the bar apart, and drift over the grid: the work of their reactions is the bar's energy, and
// by symmetry one draws as much as the other.
TEST(BodyPart, GripsDrawWhatIsBetweenThem) {
    Json scene = bar();
    scene["bodies"]["bar"]["particles_per_cell"] = 9;
    scene["boundary_conditions"] = {
        {{"type", "velocity"}, {"name", "left"}, {"on", part(0, 0.8)}, {"velocity", {0.25, 0}}},
        {{"type", "velocity"}, {"name", "right"}, {"on", part(1.4, 2)}, {"velocity", {0.75, 0}}}};
    scene["bodies"]["bar"]["velocity"] = {"min(0.75, max(0.25, 0.25 + 0.5*(x - 0.8)/0.6))", 0};
    for (const Json& integrator : every_plugin("integrator")) {
        SCOPED_TRACE(integrator.dump());
        scene["integrator"] = integrator;
        Simulated run(scene);
        double work = 0;
        for (int k = 0; k < 200; ++k) {
            run.advance(1);
            work += (0.25 * run->reaction("left")[0] + 0.75 * run->reaction("right")[0]) * run->time_step();
        }
        const Energies energies = run->energies();
        EXPECT_NEAR(energies.external, work, 1e-3 * work);
        EXPECT_GT(work, 0);
        EXPECT_LT(run->conservation().energy_drift, 0.05);
        EXPECT_LT(run->conservation().momentum_drift, 1e-12);
    }
}

TEST(BodyPart, OtherComponentsStayFree) {
    Json scene = bar();
    scene["boundary_conditions"] = {
        {{"type", "slip"}, {"axis", "x"}, {"name", "guide"}, {"on", {{"body", "bar"}}}}};
    scene["loads"] = {{{"type", "gravity"}, {"acceleration", {7, -1}}}};
    Simulated run(scene);
    run.advance(100);
    const auto mass = run->column("bar", "mass", 0);
    double whole = 0;
    for (const double m : mass) whole += m;
    EXPECT_NEAR(run->reaction("guide")[0], -7 * whole, 1e-9 * whole);
    EXPECT_EQ(run->reaction("guide")[1], 0);
    for (const double v : run->column("bar", "velocity", 0)) EXPECT_NEAR(v, 0, 1e-13);
    for (const double v : run->column("bar", "velocity", 1)) EXPECT_NEAR(v, -run->time(), 2e-3);
}

TEST(BodyPart, MistakesAreTold) {
    const auto told = [](const Json& conditions) -> std::string {
        Json scene = bar();
        scene["boundary_conditions"] = conditions;
        try {
            Simulated run(scene);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    const auto fixed = [](const Json& on) { return Json{{"type", "fixed"}, {"on", on}}; };
    EXPECT_NE(told(Json::array({fixed(Json{{"body", "bor"}})})).find("did you mean \"bar\""),
              std::string::npos);
    EXPECT_NE(told(Json::array({fixed(part(2, 3))})).find("no particle of \"bar\""), std::string::npos);
    // One particle, with 12 % of the mass of the node beside it.
    const Json speck = {{"body", "bar"},
                        {"within", {{"type", "box"}, {"min", {1.02, 0.52}}, {"max", {1.03, 0.53}}}}};
    EXPECT_NE(told(Json::array({fixed(speck)})).find("holds nothing"), std::string::npos);
    EXPECT_NE(told(Json::array({fixed(part(0, 1)), fixed(part(0.9, 2))})).find("prescribes the x component"),
              std::string::npos);
    EXPECT_EQ(told(Json::array({fixed(part(0, 1)), fixed(part(1.2, 2))})), "");
    // Beside a face or a region, another velocity is refused, and what they have in common is not.
    const auto driven = [](const Json& on, double x) {
        return Json{{"type", "velocity"}, {"on", on}, {"velocity", {x, nullptr}}};
    };
    const Json region = {{"type", "box"}, {"min", {0.9, 0}}, {"max", {2, 1}}};
    EXPECT_NE(
        told(Json::array({driven(part(0, 1), 1), driven(region, 2)})).find("where /boundary_conditions/1"),
        std::string::npos);
    EXPECT_EQ(told(Json::array({driven(part(0, 1), 1), driven(region, 1)})), "");
    EXPECT_EQ(told(Json::array({driven(part(0, 1), 1), driven("x_min", 2)})), "");  // 5 cells from there
    EXPECT_NE(told(Json::array({Json{{"type", "slip"}, {"on", part(0, 1)}}})).find("say which component"),
              std::string::npos);
}

}  // namespace
}  // namespace matpoint::conformance
