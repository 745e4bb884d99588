// A scene that asks for something that can't be, or that does nothing, is refused or told so.
#include "run/run.hpp"
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>

namespace matpoint::conformance {
namespace {

/// What is said of a scene before it runs, one a line; empty if nothing is.
std::string told(const Json& scene) {
    try {
        std::string all;
        const Simulated simulated(scene);
        for (const std::string& warning : simulated.simulation->warnings()) all += warning + "\n";
        return all;
    } catch (const InputError& error) {
        return error.what();
    }
}

testing::AssertionResult says(const Json& scene, const std::vector<std::string>& parts) {
    const std::string text = told(scene);
    for (const std::string& part : parts)
        if (text.find(part) == std::string::npos)
            return testing::AssertionFailure() << "expected \"" << part << "\" in:\n" << text;
    return testing::AssertionSuccess();
}

Json box(const std::vector<double>& min, const std::vector<double>& max) {
    return {{"type", "box"}, {"min", min}, {"max", max}};
}

/// A block in the middle of the unit square.
Json scene(const Json& boundary_conditions = Json::array()) {
    Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [1, 1], "cell_size": 0.1},
        "shape_function": {"type": "gimp"},
        "time": {"end": 0.01},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}},
        "bodies": {"block": {"material": "rubber", "geometry": {"type": "box", "min": [0.3, 0.3], "max": [0.7, 0.7]}}}
    })json");
    scene["boundary_conditions"] = boundary_conditions;
    return scene;
}

Json axisymmetric_scene() {
    Json json = scene({{{"type", "slip"}, {"on", "x_min"}}});
    json["space"]["mode"] = "axisymmetric";
    return json;
}

Json with_body(Json json, const std::string& name, const Json& geometry) {
    json["bodies"][name] = json["bodies"]["block"];
    json["bodies"][name]["geometry"] = geometry;
    return json;
}

Json with_only(Json json, const Json& geometry) {
    json["bodies"]["block"]["geometry"] = geometry;
    return json;
}

// Regions.

TEST(AskedFor, RegionBetweenNodesIsRefused) {
    const Json between = {{{"type", "fixed"}, {"on", box({0.3, 0.31}, {0.7, 0.39})}}};
    EXPECT_TRUE(says(scene(between), {"error: /boundary_conditions/0/on", "no node", "0.1 and 0.1 m"}));
    const Json around = {{{"type", "fixed"}, {"on", box({0.3, 0.31}, {0.7, 0.41})}}};
    EXPECT_EQ(told(scene(around)), "");
}

TEST(AskedFor, RegionOffTheGridIsRefused) {
    EXPECT_TRUE(says(scene({{{"type", "fixed"}, {"on", box({2, 2}, {3, 3})}}}), {"error", "no node"}));
}

TEST(AskedFor, AllRegionsAreToldAtOnce) {
    EXPECT_TRUE(says(scene({{{"type", "fixed"}, {"on", box({2, 2}, {3, 3})}},
                            {{"type", "slip"}, {"axis", "x"}, {"on", box({0.31, 0.31}, {0.39, 0.39})}}}),
                     {"/boundary_conditions/0/on", "/boundary_conditions/1/on"}));
}

TEST(AskedFor, RegionThatNoBodyIsAtIsToldUnlessItWaits) {
    // The block's particles reach nodes to 0.8: gimp's domain touches 0.7, and hats reach a cell further.
    Json ahead = scene({{{"type", "fixed"}, {"on", box({0.3, 0.85}, {0.7, 0.95})}}});
    EXPECT_TRUE(says(ahead, {"warning: /boundary_conditions/0/on", "no body is there", "\"waits\": true"}));
    ahead["boundary_conditions"][0]["waits"] = true;
    EXPECT_EQ(told(ahead), "");
    EXPECT_EQ(told(scene({{{"type", "fixed"}, {"on", box({0.3, 0.65}, {0.7, 0.95})}}})), "");
}

TEST(AskedFor, FaceNeedNotWait) {
    EXPECT_EQ(told(scene({{{"type", "fixed"}, {"on", "y_max"}}})), "");
    EXPECT_TRUE(says(scene({{{"type", "fixed"}, {"on", "y_max"}, {"waits", true}}}),
                     {"error: /boundary_conditions/0/waits"}));
}

/// At the end of a run of `steps` steps.
std::vector<std::string> told_at_the_end(Json json, double upward, int steps) {
    json["boundary_conditions"] = {
        {{"type", "fixed"}, {"on", box({0.3, 0.85}, {0.7, 0.95})}, {"waits", true}}};
    json["bodies"]["block"]["velocity"] = {0, upward};
    json["time"] = {{"end", 1}, {"step", 1e-3}, {"max_steps", steps}};
    Simulated run(json);
    return run.advance(steps)->warnings();
}

TEST(AskedFor, RegionThatNoBodyEverReachedIsToldAtTheEnd) {
    const auto missed = told_at_the_end(scene(), -1, 60), met = told_at_the_end(scene(), 2, 60);
    ASSERT_EQ(missed.size(), 1U);
    EXPECT_NE(missed[0].find("/boundary_conditions/0"), std::string::npos) << missed[0];
    EXPECT_TRUE(met.empty());
}

TEST(AskedFor, RegionThatHeldBeforeACheckpointHasHeld) {
    // The block falls out of a region that holds it sideways: by 0.16 m before the checkpoint.
    Json json = scene({{{"type", "slip"}, {"axis", "x"}, {"on", box({0.3, 0.65}, {0.7, 0.75})}}});
    json["bodies"]["block"]["velocity"] = {0, -20};
    json["time"] = {{"end", 1}, {"step", 1e-3}, {"max_steps", 11}};
    Simulated first(json), second(json);
    first.advance(8);
    second->restore(first->state());
    second.advance(3);
    EXPECT_TRUE(second->warnings().empty());
}

// Conditions at one node.

Json velocity(const Json& on, const Json& components) {
    return {{"type", "velocity"}, {"on", on}, {"velocity", components}};
}

TEST(AskedFor, RegionsThatPrescribeDifferentVelocitiesAtANodeAreRefused) {
    const Json left = box({0.25, 0.25}, {0.55, 0.75}), right = box({0.45, 0.25}, {0.75, 0.75});
    EXPECT_TRUE(
        says(scene({velocity(left, {0, nullptr}), velocity(right, {1, 0})}),
             {"error: /boundary_conditions/1/on", "x component", "/boundary_conditions/0 prescribes 0"}));
    // Later only.
    EXPECT_TRUE(says(scene({velocity(left, {0, nullptr}), velocity(right, {"100*t", 0})}), {"error"}));
    // Not the same component, the same velocity, or no node in common.
    EXPECT_EQ(told(scene({velocity(left, {0, nullptr}), velocity(right, {nullptr, 0})})), "");
    EXPECT_EQ(told(scene({velocity(left, {0, nullptr}), velocity(right, {"0*t", 0})})), "");
    EXPECT_EQ(told(scene({velocity(left, {0, 0}), velocity(box({0.56, 0.25}, {0.75, 0.75}), {1, 0})})), "");
}

TEST(AskedFor, RegionAndFaceThatPrescribeDifferentVelocitiesAreRefused) {
    const Json body = box({0, 0}, {0.5, 0.5});
    const Json floor = {{"type", "fixed"}, {"on", {"y_min", "x_max"}}};
    const auto with = [&](const Json& on, const Json& components) {
        return with_only(scene({floor, velocity(on, components)}), body);
    };
    EXPECT_TRUE(says(with(box({-0.05, -0.05}, {0.25, 0.25}), {1, nullptr}),
                     {"error: /boundary_conditions/1/on", "/boundary_conditions/0 on \"y_min\""}));
    EXPECT_EQ(told(with(box({-0.05, 0.05}, {0.25, 0.25}), {1, nullptr})), "");
    EXPECT_EQ(told(with(box({-0.05, -0.05}, {0.25, 0.25}), {0, nullptr})), "");
}

TEST(AskedFor, EveryFaceThatTwoConditionsPrescribeIsRefused) {
    EXPECT_TRUE(says(scene({{{"type", "fixed"}, {"on", {"x_min", "y_max"}}},
                            {{"type", "slip"}, {"on", "x_min"}},
                            {{"type", "slip"}, {"on", "y_max"}}}),
                     {"/boundary_conditions/1/on: prescribes the x component of velocity on \"x_min\"",
                      "/boundary_conditions/2/on: prescribes the y component of velocity on \"y_max\""}));
}

TEST(AskedFor, ConditionThatLeavesAllFreeIsRefused) {
    EXPECT_TRUE(says(scene(Json::array({velocity("x_min", {nullptr, nullptr})})),
                     {"error: /boundary_conditions/0/velocity"}));
}

// Bodies and the grid.

TEST(AskedFor, BodyThatTheGridCutsIsRefused) {
    EXPECT_TRUE(says(with_only(scene(), box({0.3, 0.3}, {1.7, 0.7})),
                     {"error: /bodies/block/geometry", "x_max, and 50 % of the body"}));
    EXPECT_TRUE(says(with_only(scene(), {{"type", "sphere"}, {"center", {0, 1}}, {"radius", 0.3}}),
                     {"x_min and y_max, and 75 % of the body"}));
    EXPECT_EQ(told(with_only(scene(), box({0, 0}, {1, 1}))), "");
}

TEST(AskedFor, BodyThatEndsAtTheGridToRoundingIsNotCut) {
    Json json = with_only(scene(), box({0.3, 0.3}, {0.1 + 0.2 + 0.7, 1.0000000000000002}));
    EXPECT_EQ(told(json), "");
    json["space"]["precision"] = "single";
    EXPECT_EQ(told(json), "");
}

TEST(AskedFor, PlaneOfSymmetryMayCutABody) {
    const Json disk = {{"type", "sphere"}, {"center", {0, 0}}, {"radius", 0.3}};
    const Json symmetry = {{{"type", "slip"}, {"on", {"x_min", "y_min"}}}};
    EXPECT_EQ(told(with_only(scene(symmetry), disk)), "");
    EXPECT_TRUE(says(with_only(scene({{{"type", "slip"}, {"on", "x_min"}}}), disk), {"y_min, and 50 %"}));
    EXPECT_TRUE(
        says(with_only(scene({{{"type", "fixed"}, {"on", {"x_min", "y_min"}}}}), disk), {"x_min and y_min"}));
    EXPECT_EQ(
        told(with_only(axisymmetric_scene(), {{"type", "sphere"}, {"center", {0, 0.5}}, {"radius", 0.3}})),
        "");
}

// Bodies and each other.

TEST(AskedFor, OverlapIsToldWithItsVolume) {
    Json json = with_body(scene(), "other", box({0.6, 0.3}, {0.9, 0.7}));
    EXPECT_TRUE(says(json, {"warning: /bodies/other/geometry", "\"block\"", "0.04 m^2", "33.3 %"}));
    json["bodies"]["block"]["overlaps"] = "other";
    EXPECT_EQ(told(json), "");
}

TEST(AskedFor, OverlapThinnerThanAParticleIsTold) {
    EXPECT_TRUE(says(with_body(scene(), "other", box({0.69, 0.3}, {0.9, 0.7})), {"0.004 m^2"}));
}

TEST(AskedFor, ThreeBodiesAreTwoOverlaps) {
    const Json two = with_body(scene(), "other", box({0.6, 0.3}, {0.9, 0.7}));
    EXPECT_TRUE(says(with_body(two, "third", box({0.35, 0.65}, {0.5, 0.9})),
                     {"/bodies/other/geometry", "/bodies/third/geometry"}));
}

TEST(AskedFor, BodiesThatTouchDoNotOverlap) {
    // Between particles, and where the decimals round the other way.
    for (const double x : {0.7, 0.7123, 0.1 + 0.2 + 0.4}) {
        const Json left = with_only(scene(), box({0.3, 0.3}, {x, 0.7}));
        EXPECT_EQ(told(with_body(left, "other", box({x, 0.3}, {0.9, 0.7}))), "");
        EXPECT_EQ(told(with_body(left, "other", box({std::nextafter(x, 0), 0.3}, {0.9, 0.7}))), "");
    }
    const Json disk = {{"type", "sphere"}, {"center", {0.5, 0.8}}, {"radius", 0.1}};
    EXPECT_EQ(told(with_body(scene(), "disk", disk)), "");
    // A disk in a hole of its size.
    const Json low_disk = {{"type", "sphere"}, {"center", {0.5, 0.6}}, {"radius", 0.15}};
    Json holed =
        with_only(scene(), {{"type", "difference"}, {"of", {box({0.3, 0.3}, {0.7, 0.9}), low_disk}}});
    EXPECT_EQ(told(with_body(holed, "disk", low_disk)), "");
}

Json lattice(const std::vector<double>& min, const std::vector<double>& max, double jitter = 0) {
    return {{"type", "lattice"}, {"min", min}, {"max", max}, {"counts", {7, 5}}, {"jitter", jitter}};
}

TEST(AskedFor, ListedParticlesOverlap) {
    // With a region, with each other, and with themselves a second time.
    EXPECT_TRUE(says(with_body(scene(), "dust", lattice({0.5, 0.5}, {0.9, 0.9})), {"/bodies/dust/geometry"}));
    const Json dust = with_only(scene(), lattice({0.3, 0.3}, {0.7, 0.7}));
    EXPECT_TRUE(says(with_body(dust, "more", lattice({0.5, 0.5}, {0.9, 0.9})), {"/bodies/more/geometry"}));
    EXPECT_TRUE(says(with_body(dust, "more", lattice({0.3, 0.3}, {0.7, 0.7})), {"0.16 m^2", "100 %"}));
    EXPECT_EQ(told(with_body(dust, "more", lattice({0.7, 0.3}, {0.9, 0.7}, 0.1))), "");
    EXPECT_EQ(told(with_body(dust, "more", box({0.7, 0.3}, {0.9, 0.7}))), "");
}

// The axis.

TEST(AskedFor, GravityAlongTheRadiusIsRefused) {
    Json json = axisymmetric_scene();
    json["loads"] = {{{"type", "gravity"}, {"acceleration", {-9.81, 0}}}};
    EXPECT_TRUE(says(json, {"error: /loads/0/acceleration", "radius"}));
    json["loads"][0]["acceleration"] = {0, -9.81};
    EXPECT_EQ(told(json), "");
}

TEST(AskedFor, BodyForceAlongTheRadiusVanishesAtTheAxis) {
    Json json = axisymmetric_scene();
    json["loads"] = {{{"type", "body_force"}, {"acceleration", {"5 + 0*x", 0}}}};
    EXPECT_EQ(told(json), "");
    json["bodies"]["block"]["geometry"] = box({0, 0.3}, {0.4, 0.7});
    EXPECT_TRUE(says(json, {"error: /loads/0", "\"block\" is at the axis"}));
    json["loads"][0]["acceleration"][0] = "5*x";
    EXPECT_EQ(told(json), "");
}

TEST(AskedFor, VelocityAlongTheRadius) {
    Json json = axisymmetric_scene();
    json["bodies"]["block"]["velocity"] = {3, 1};
    EXPECT_TRUE(says(json, {"warning: /bodies/block/velocity/0", "rings widen", "\"3\""}));
    json["bodies"]["block"]["velocity"][0] = "3";
    EXPECT_EQ(told(json), "");
    json["bodies"]["block"]["geometry"] = box({0, 0.3}, {0.4, 0.7});
    EXPECT_TRUE(says(json, {"error: /bodies/block/velocity/0", "axis"}));
    json["bodies"]["block"]["velocity"][0] = "3*x";
    EXPECT_EQ(told(json), "");
}

TEST(AskedFor, ConditionsOnTheAxis) {
    Json json = axisymmetric_scene();
    json["boundary_conditions"] = Json::array({velocity("x_min", {1, nullptr})});
    EXPECT_TRUE(says(json, {"error: /boundary_conditions/0", "axis"}));
    json["boundary_conditions"] = {{{"type", "fixed"}, {"on", "x_min"}}};
    EXPECT_TRUE(says(json, {"warning: /boundary_conditions/0/on", "\"slip\""}));
    json["boundary_conditions"] = {{{"type", "slip"}, {"on", "x_min"}},
                                   velocity(box({-0.05, 0.35}, {0.45, 0.65}), {"x", nullptr})};
    EXPECT_EQ(told(json), "");
}

// Loads, exact solutions, checkpoints.

TEST(AskedFor, TractionWithoutAFaceIsRefused) {
    Json json = axisymmetric_scene();
    json["bodies"]["block"]["geometry"] = box({0, 0.3}, {0.4, 0.7});
    json["loads"] = {{{"type", "traction"}, {"body", "block"}, {"face", "x_min"}, {"traction", {1e3, 0}}}};
    EXPECT_TRUE(says(json, {"error: /loads/0", "no area"}));
    json["loads"][0]["face"] = "y_max";
    EXPECT_EQ(told(json), "");
}

TEST(AskedFor, BoundaryLayerThickerThanTheBodyIsRefused) {
    Json json = scene();
    json["loads"] = {{{"type", "traction"},
                      {"body", "block"},
                      {"face", "x_max"},
                      {"traction", {1e3, 0}},
                      {"method", "boundary_layer"},
                      {"thickness", 0.5}}};
    EXPECT_TRUE(says(json, {"error: /loads/0", "thicker than the body"}));
    json["loads"][0]["thickness"] = 0.4;
    EXPECT_EQ(told(json), "");
}

TEST(AskedFor, ExactSolutionComparedWithNothingIsRefused) {
    Json json = scene();
    json["exact_solution"] = {{"type", "free_flight"},
                              {"body", "block"},
                              {"velocity", {1, 0}},
                              {"within", box({0.8, 0.8}, {0.9, 0.9})}};
    EXPECT_TRUE(says(json, {"error: /exact_solution/within", "no particle"}));
    json["exact_solution"]["quantity"] = "nodal_velocity";
    json["exact_solution"]["within"] = box({0.81, 0.81}, {0.89, 0.89});
    EXPECT_TRUE(says(json, {"error: /exact_solution/within", "no node"}));
}

TEST(AskedFor, ErrorOfNothingIsNotZero) {
    Json json = scene();
    json["time"] = {{"end", 1}, {"step", 1e-4}, {"max_steps", 2}};
    json["exact_solution"] = {{"type", "free_flight"},
                              {"body", "block"},
                              {"velocity", {1, 0}},
                              {"quantity", "nodal_velocity"},
                              {"within", box({0.85, 0.85}, {0.95, 0.95})}};
    Simulated run(json);
    for (int k = 0; k < 2; ++k) {
        run->measure_error();
        run->advance();
    }
    EXPECT_FALSE(run->error());
    ASSERT_FALSE(run->warnings().empty());
    EXPECT_NE(run->warnings().back().find("/exact_solution"), std::string::npos) << run->warnings().back();
}

TEST(AskedFor, CheckpointsThatAreNeverDueAreTold) {
    Json json = scene();
    json["checkpoint"] = {{"every", 0.02}};
    EXPECT_TRUE(says(json, {"warning: /checkpoint/every"}));
    json["checkpoint"]["every"] = 0.01;
    EXPECT_EQ(told(json), "");
}

// A particle is called by its number of seeding, wherever sorting has put it.

TEST(Naming, DoesNotDependOnOutputs) {
    Json json = scene();
    json["time"] = {{"end", 1}, {"step", 1e-3}};
    json["bodies"]["block"]["velocity"] = {"x > 0.65 && y > 0.65 ? 5 : 1", "2"};
    const auto reason = [](const Json& own) {
        const auto folder =
            std::filesystem::temp_directory_path() / ("matpoint_naming_" + std::to_string(getpid()));
        PluginCatalogue catalogue;
        const Scene scene = load_scene(parse_document(own.dump(), "scene.json"), {}, catalogue);
        const RunResult result = run_scene(scene, catalogue, {.output = folder, .quiet = true});
        std::filesystem::remove_all(folder);
        return result.reason.substr(0, result.reason.find('\n'));
    };
    const std::string alone = reason(json);
    EXPECT_NE(alone.find("left the grid"), std::string::npos) << alone;
    json["outputs"] = {{{"type", "csv"}, {"fields", {"velocity"}}}};
    EXPECT_EQ(reason(json), alone);
}

}  // namespace
}  // namespace matpoint::conformance
