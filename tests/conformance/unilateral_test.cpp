// Walls that push and rub but do not pull, with every shape, integrator and transfer.
#include "every_plugin.hpp"
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace matpoint::conformance {
namespace {

/// A block of rubber above a floor that lets go, clear of the other faces.
Json thrown_block(double height, const Json& velocity) {
    Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [2, 2], "cell_size": 0.1},
        "time": {"end": 100, "cfl": 0.3},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}},
        "bodies": {"block": {"material": "rubber", "geometry": {"type": "box", "min": [0.55, 0], "max": [1.15, 0]}}},
        "boundary_conditions": [{"type": "unilateral", "on": "y_min", "name": "floor"}],
        "outputs": [{"type": "csv", "fields": ["velocity", "displacement_gradient"]}]
    })json");
    scene["bodies"]["block"]["velocity"] = velocity;
    scene["bodies"]["block"]["geometry"]["min"][1] = height;
    scene["bodies"]["block"]["geometry"]["max"][1] = height + 0.4;
    return scene;
}

double lowest(Simulated& run) {
    const auto y = run->column("block", "position", 1);
    return *std::min_element(y.begin(), y.end());
}

double total(const Simulated& run) {
    const Energies energies = run.simulation->energies();
    return energies.kinetic + energies.strain;
}

// Falls at a hundredth of the speed of sound from a quarter of a cell, is pushed off and leaves: the impulse
// is the change of momentum, never pulls, and takes energy.
TEST(Unilateral, LetsGoOfWhatItThrowsBack) {
    with_every_scheme(thrown_block(0.025, {0, -0.1}), [](const Json& scene) {
        Simulated run(scene);
        const double energy = total(run);
        double gap = -1;
        for (int k = 0; k < 400; ++k) {
            const double before = lowest(run) - 0.0125;  // half of a particle of what is in the lowest cell
            run.advance(1);
            const auto force = run->reaction("floor");
            ASSERT_GE(force[1], 0);
            ASSERT_EQ(force[0], 0);
            if (gap < 0 && force[1] > 0) gap = before;
        }
        EXPECT_NEAR(gap, 0, 5e-4) << "where it touches first";
        EXPECT_GT(run->momentum()[1], 0.5 * 24) << "a wall that pulls gives none";
        EXPECT_GT(lowest(run), 0.03) << "it has left";
        EXPECT_LT(total(run), energy * 1.001);
        EXPECT_LT(run->conservation().momentum_drift, 1e-12);
    });
}

// Nodes of the floor feel it, but it never touches.
TEST(Unilateral, LeavesAloneWhatPassesBy) {
    with_every_scheme(thrown_block(0.01, {1, 0.01}), [](Json scene) {
        Simulated beside(scene);
        beside.advance(40);
        scene["boundary_conditions"] = Json::array();
        scene["outputs"][0]["fields"].push_back("initial_half_size");
        Simulated alone(scene);
        alone.advance(40);
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_EQ(beside->column("block", "velocity", axis), alone->column("block", "velocity", axis));
    });
}

// A wall on the upper face, and one on the right, do what one on the lower does.
TEST(Unilateral, IsTheSameOnEveryFace) {
    const auto moved = [](const Json& box_min, const Json& box_max, const Json& velocity, const char* face,
                          int axis) {
        Json scene = thrown_block(0, velocity);
        scene["bodies"]["block"]["geometry"] = {{"type", "box"}, {"min", box_min}, {"max", box_max}};
        scene["boundary_conditions"][0]["on"] = face;
        Simulated run(scene);
        run.advance(60);
        return run->momentum()[static_cast<std::size_t>(axis)];
    };
    const double below = moved({0.5, 0.02}, {1.1, 0.42}, {0, -0.2}, "y_min", 1);
    EXPECT_GT(below, 0);
    EXPECT_NEAR(moved({0.5, 1.58}, {1.1, 1.98}, {0, 0.2}, "y_max", 1), -below, 1e-9);
    EXPECT_NEAR(moved({0.02, 0.5}, {0.42, 1.1}, {-0.2, 0}, "x_min", 0), below, 1e-9);
    EXPECT_NEAR(moved({1.58, 0.5}, {1.98, 1.1}, {0.2, 0}, "x_max", 0), -below, 1e-9);
}

// Pressed against the floor and drawn along it: mu times what presses, against the motion.
TEST(Unilateral, RubsWithFrictionTimesPressure) {
    for (const Json& integrator : every_plugin("integrator"))
        for (const Json& transfer : every_plugin("transfer")) {
            SCOPED_TRACE(integrator.dump() + transfer.dump());
            Json scene = thrown_block(0, {1, 0});
            scene["integrator"] = integrator;
            scene["transfer"] = transfer;
            scene["loads"] = {{{"type", "gravity"}, {"acceleration", {0, -10}}}};
            scene["boundary_conditions"][0]["friction"] = 0.2;
            Simulated run(scene);
            double pressed = 0, rubbed = 0;
            for (int k = 0; k < 100; ++k) {
                run.advance(1);
                pressed += run->reaction("floor")[1] * run->time_step();
                rubbed += run->reaction("floor")[0] * run->time_step();
            }
            EXPECT_GT(pressed, 0);
            EXPECT_NEAR(rubbed, -0.2 * pressed, 0.2e-6 * pressed);
            EXPECT_LT(run->conservation().momentum_drift, 1e-12);
        }
}

// In 3D the force is against the motion, whatever its direction.
TEST(Unilateral, RubsAgainstTheDirectionOfMotion) {
    Json scene = thrown_block(0, {1, 0});
    scene["space"]["dimension"] = 3;
    scene["grid"]["min"] = {0, 0, 0};
    scene["grid"]["max"] = {1.2, 1.2, 1};
    scene["bodies"]["block"]["geometry"] = {
        {"type", "box"}, {"min", {0.3, 0.3, 0}}, {"max", {0.7, 0.7, 0.3}}};
    scene["bodies"]["block"]["velocity"] = {0.8, 0.3, 0};
    scene["loads"] = {{{"type", "gravity"}, {"acceleration", {0, 0, -10}}}};
    scene["boundary_conditions"][0] = {
        {"type", "unilateral"}, {"on", "z_min"}, {"name", "floor"}, {"friction", 0.2}};
    Simulated run(scene);
    double along = 0, across = 0, pressed = 0;
    for (int k = 0; k < 40; ++k) {
        run.advance(1);
        const auto force = run->reaction("floor");
        pressed += force[2];
        along += 0.8 * force[0] + 0.3 * force[1];
        across += -0.3 * force[0] + 0.8 * force[1];
    }
    const double speed = std::hypot(0.8, 0.3);
    EXPECT_NEAR(along / speed, -0.2 * pressed, 0.002 * pressed);
    EXPECT_NEAR(across / speed, 0, 0.002 * pressed);
}

// More friction than it takes holds a block that is drawn along.
TEST(Unilateral, HoldsWhatIsDrawnWithLessThanItsFriction) {
    for (const Json& integrator : every_plugin("integrator")) {
        SCOPED_TRACE(integrator.dump());
        Json scene = thrown_block(0, {0, 0});
        scene["integrator"] = integrator;
        scene["loads"] = {{{"type", "gravity"}, {"acceleration", {4, -10}}}};
        scene["boundary_conditions"][0]["friction"] = 0.6;
        Simulated run(scene);
        run.advance(600);
        const auto v = run->column("block", "velocity", 0);
        const double mean = std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
        EXPECT_LT(std::abs(mean), 0.005 * 4 * run->time()) << "of free flight";
    }
}

}  // namespace
}  // namespace matpoint::conformance
