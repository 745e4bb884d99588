// Walls, open faces and reactions against what must come out of symmetry and of Newton's third law.
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace matpoint::conformance {
namespace {

Json squashed_block(double left, const Json& boundary_conditions) {
    Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, -1], "max": [1.5, 1], "cell_size": 0.125},
        "integrator": {"type": "usl"},
        "time": {"end": 100, "step": 0.002},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}},
        "bodies": {"block": {"material": "rubber", "velocity": ["-2*x", "0.5*sin(2*x)"],
                             "geometry": {"type": "box", "min": [0, -0.5], "max": [1, 0.5]}}},
        "outputs": [{"type": "csv", "fields": ["velocity", "stress"]}]
    })json");
    scene["grid"]["min"][0] = left;
    scene["bodies"]["block"]["geometry"]["min"][0] = left < 0 ? -1.0 : 0.0;
    if (left < 0) scene["bodies"]["block"]["velocity"] = {"-2*x", "0.5*sin(2*abs(x))"};
    scene["boundary_conditions"] = boundary_conditions;
    return scene;
}

class EveryShape : public testing::TestWithParam<Json> {};

TEST_P(EveryShape, SlipWallEqualsTheMirroredBody) {
    const Json slip = {{{"type", "slip"}, {"on", "x_min"}}};
    Json half = squashed_block(0, slip), full = squashed_block(-1.5, Json::array());
    half["shape_function"] = full["shape_function"] = GetParam();
    Simulated walled(half), mirrored(full);
    walled.advance(60);
    mirrored.advance(60);

    // Seeding goes by cells: find the mirror body's particles with x > 0 by their place in y and x.
    const auto keyed = [](Simulated& run) {
        std::vector<std::array<double, 5>> rows;
        const auto x = run->column("block", "position", 0), y = run->column("block", "position", 1);
        const auto u = run->column("block", "velocity", 0), v = run->column("block", "velocity", 1);
        const auto s = run->column("block", "stress", 0);
        for (std::size_t p = 0; p < x.size(); ++p)
            if (x[p] > 0) rows.push_back({x[p], y[p], u[p], v[p], s[p]});
        std::sort(rows.begin(), rows.end());
        return rows;
    };
    const auto expected = keyed(mirrored), found = keyed(walled);
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t p = 0; p < expected.size(); ++p) {
        for (int k = 0; k < 4; ++k)
            EXPECT_NEAR(found[p][static_cast<std::size_t>(k)], expected[p][static_cast<std::size_t>(k)],
                        1e-10);
        EXPECT_NEAR(found[p][4], expected[p][4], 1e-5);
    }
}

TEST_P(EveryShape, BodyOnOpenFacesTranslatesFreely) {
    Json scene = squashed_block(0, Json::array());
    scene["shape_function"] = GetParam();
    scene["bodies"]["block"]["velocity"] = {1.0, 0.25};
    Simulated run(scene);
    run.advance(50);
    for (const double u : run->column("block", "velocity", 0)) EXPECT_NEAR(u, 1.0, 1e-11);
    for (const double v : run->column("block", "velocity", 1)) EXPECT_NEAR(v, 0.25, 1e-11);
    for (const double s : run->column("block", "von_mises_stress", 0)) EXPECT_NEAR(s, 0, 1e-5);
}

TEST_P(EveryShape, WallThatMovesWithTheBodyLeavesItAlone) {
    Json scene = squashed_block(0, {{{"type", "velocity"}, {"on", {"x_min"}}, {"velocity", {0.75, -0.5}}}});
    scene["shape_function"] = GetParam();
    scene["bodies"]["block"]["velocity"] = {0.75, -0.5};
    Simulated run(scene);
    run.advance(40);
    for (const double u : run->column("block", "velocity", 0)) EXPECT_NEAR(u, 0.75, 1e-11);
    EXPECT_LT(run->conservation().momentum_drift, 1e-12);
}

/// Calls test(run) for the scene with every transfer, integrator and precision.
template <class Test>
void with_every_scheme(Json scene, const Test& test) {
    for (const char* precision : {"double", "single"})
        for (const char* transfer : {"flip", "apic"})
            for (const char* integrator : {"usf", "usl", "musl", "uvf", "central_difference"}) {
                SCOPED_TRACE(std::string(precision) + ", " + transfer + ", " + integrator);
                scene["space"]["precision"] = precision;
                scene["transfer"]["type"] = transfer;
                scene["integrator"]["type"] = integrator;
                Simulated run(scene);
                test(run);
            }
}

/// Of all particles, along an axis.
std::array<double, 2> extent(Simulated& run, const std::string& body, int axis) {
    const auto x = run->column(body, "position", axis);
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    return {*low, *high};
}

TEST_P(EveryShape, ClosedBoxKeepsDustForEver) {
    // Without stiffness it comes to the walls ever closer, until rounding pushes it on.
    Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [-0.3, 0.1], "max": [0.7, 1.1], "cell_size": 0.1},
        "time": {"end": 100, "step": 0.03},
        "materials": {"dust": {"type": "linear_elastic", "density": 1, "youngs_modulus": 0}},
        "bodies": {"cloud": {"material": "dust", "particles_per_cell": 1,
                             "geometry": {"type": "box", "min": [0.1, 0.5], "max": [0.3, 0.7]}}},
        "boundary_conditions": [{"type": "slip", "on": ["x_min", "y_max"]}, {"type": "fixed", "on": "x_max"},
                                {"type": "velocity", "velocity": [null, 0], "on": "y_min"}]
    })json");
    scene["shape_function"] = GetParam();
    for (const auto& velocity : {Json{-1, 0.7}, Json{1, -0.7}}) {
        scene["bodies"]["cloud"]["velocity"] = velocity;
        with_every_scheme(scene, [](Simulated& run) {
            ASSERT_NO_THROW(run.advance(400));
            constexpr double rounding = 1e-7;  // of single precision
            EXPECT_GE(extent(run, "cloud", 0)[0], -0.3 - rounding);
            EXPECT_LE(extent(run, "cloud", 0)[1], 0.7 + rounding);
            EXPECT_GE(extent(run, "cloud", 1)[0], 0.1 - rounding);
            EXPECT_LE(extent(run, "cloud", 1)[1], 1.1 + rounding);
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape,
                         testing::Values(Json{{"type", "linear"}}, Json{{"type", "gimp"}},
                                         Json{{"type", "gimp"}, {"domain", "uniform"}},
                                         Json{{"type", "bspline"}, {"order", 2}},
                                         Json{{"type", "bspline"}, {"order", 3}}));

TEST(Reactions, FloorCarriesTheWeightOfABodyAtRest) {
    // Damped to rest by a transfer that takes all velocity from the grid.
    const Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [1, 1], "cell_size": 0.125},
        "shape_function": {"type": "bspline", "order": 2},
        "transfer": {"type": "flip", "pic_fraction": 1},
        "time": {"end": 100, "cfl": 0.4},
        "materials": {"rubber": {"type": "linear_elastic", "density": 1000, "youngs_modulus": 1e6, "poissons_ratio": 0.0}},
        "bodies": {"block": {"material": "rubber", "geometry": {"type": "box", "min": [0, 0], "max": [1, 0.5]}}},
        "loads": [{"type": "gravity", "acceleration": [0, -10]}],
        "boundary_conditions": [{"type": "slip", "on": ["x_min", "x_max"], "name": "sides"},
                                {"type": "fixed", "on": "y_min", "name": "floor"}]
    })json");
    Simulated run(scene);
    run.advance(3000);
    EXPECT_NEAR(run->reaction("floor")[1], 1000 * 0.5 * 10, 5);
    EXPECT_NEAR(run->reaction("sides")[0], 0, 1e-6);
    EXPECT_LT(run->energies().kinetic, 1e-6);
}

TEST(ClosedFace, IsNotToldToBeClosedWhenItIsPassed) {
    // A step in which the bar is thrown across the wall.
    Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 1},
        "grid": {"type": "uniform", "min": [0], "max": [1], "cell_size": 0.1},
        "shape_function": {"type": "gimp"},
        "time": {"end": 10, "step": 0.5},
        "materials": {"dust": {"type": "linear_elastic", "density": 1, "youngs_modulus": 0}},
        "bodies": {"bar": {"material": "dust", "velocity": [-1],
                           "geometry": {"type": "box", "min": [0.1], "max": [0.3]}}},
        "boundary_conditions": [{"type": "slip", "on": "x_min"}],
        "health": {"unstable_step": "ignore"}
    })json");
    const auto told = [](const Json& json) -> std::string {
        try {
            Simulated run(json);
            run.advance(2);
        } catch (const Breakdown& breakdown) {
            return breakdown.what();
        }
        return "";
    };
    EXPECT_NE(told(scene).find("through x_min, "), std::string::npos) << told(scene);
    EXPECT_NE(told(scene).find("although the face is closed"), std::string::npos) << told(scene);
    scene["boundary_conditions"] = {{{"type", "velocity"}, {"velocity", {-1}}, {"on", "x_min"}}};
    EXPECT_NE(told(scene).find("carried by the velocity that is prescribed"), std::string::npos)
        << told(scene);
    scene["boundary_conditions"] = Json::array();
    EXPECT_NE(told(scene).find("through x_min. Enlarge /grid, close the face"), std::string::npos)
        << told(scene);
}

TEST(MovingRegion, StaggeredIntegratorsFollowItToSecondOrder) {
    const auto error = [](const char* integrator, double dt) {
        Json scene = Json::parse(R"json({
            "matpoint": 1,
            "space": {"dimension": 1},
            "grid": {"type": "uniform", "min": [0], "max": [2], "cell_size": 0.25},
            "time": {"end": 100},
            "materials": {"soft": {"type": "linear_elastic", "density": 1, "youngs_modulus": 1}},
            "bodies": {"bar": {"material": "soft", "velocity": [1], "geometry": {"type": "box", "min": [0.5], "max": [1]}}},
            "boundary_conditions": [{"type": "velocity", "velocity": ["cos(5*t)"],
                                     "on": {"type": "box", "min": [0], "max": [2]}}]
        })json");
        scene["integrator"] = {{"type", integrator}};
        scene["time"]["step"] = dt;
        Simulated run(scene);
        const double start = run->column("bar", "position", 0)[0];
        run.advance(std::lround(0.24 / dt));
        return std::abs(run->column("bar", "position", 0)[0] - start - std::sin(5 * 0.24) / 5);
    };
    for (const char* integrator : {"central_difference", "uvf"})
        EXPECT_NEAR(std::log2(error(integrator, 0.02) / error(integrator, 0.01)), 2, 0.1) << integrator;
    EXPECT_NEAR(std::log2(error("usl", 0.02) / error("usl", 0.01)), 1, 0.1);
}

TEST(Reactions, TwoConditionsOnOneComponentAreAMistake) {
    const Json twice = {{{"type", "fixed"}, {"on", "x_min"}}, {{"type", "slip"}, {"on", "x_min"}}};
    EXPECT_THROW(Simulated{squashed_block(0, twice)}, InputError);
}

}  // namespace
}  // namespace matpoint::conformance
