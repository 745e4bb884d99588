// One particle in one cell, held at its left node [Wallstedt & Guilkey 2008, section 3].
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matpoint::conformance {
namespace {

constexpr double cell = 0.5, modulus = 80, density = 5, wave_speed = 4;  // m, Pa, kg/m^3, m/s

Json one_particle_scene(const std::string& integrator, const Json& time) {
    Json json = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 1},
        "grid": {"type": "uniform", "min": [0]},
        "shape_function": {"type": "linear"},
        "transfer": {"type": "flip"},
        "materials": {"rubber": {"type": "neo_hookean"}},
        "bodies": {"bar": {"material": "rubber", "particles_per_cell": 1}},
        "boundary_conditions": [{"type": "fixed", "on": "x_min"}],
        "health": {"enabled": false}
    })json");
    json["grid"]["max"] = {cell};
    json["grid"]["cell_size"] = cell;
    json["integrator"] = {{"type", integrator}};
    json["time"] = time;
    json["time"]["end"] = 1e9;
    json["materials"]["rubber"]["density"] = density;
    json["materials"]["rubber"]["youngs_modulus"] = modulus;
    json["bodies"]["bar"]["geometry"] = {{"type", "box"}, {"min", {0}}, {"max", {cell}}};
    return json;
}

/// The particle, seeded in the cell's middle, is put at x with the velocity v.
struct OneParticle : Simulated {
    OneParticle(const std::string& integrator, const Json& time, double x, double v)
        : Simulated(one_particle_scene(integrator, time)) {
        CheckpointData state = simulation->state();
        for (auto& column : state.bodies.at(0).columns) {
            if (column.field == "position") column.values = std::vector<double>{x};
            if (column.field == "velocity") column.values = std::vector<double>{v};
        }
        simulation->restore(state);
    }
    double value(const std::string& field) const { return simulation->column("bar", field, 0).at(0); }
};

/// x, v and F, advanced by eq. 34-39. There the force of eq. 27 has the wrong sign, that of eq. 14 is right.
struct Recursion {
    double x, v, f = 1;

    static double acceleration(double stretch) {
        return -modulus / (2 * cell) * (stretch * stretch - 1) / density;
    }
    void usf(double dt) {
        f *= 1 + v / cell * dt;  // eq. 36
        const double a = acceleration(f);
        x += v * (x / cell) * dt + a * dt * dt;  // eq. 34
        v += a * dt;                             // eq. 35
    }
    void usl(double dt) {
        const double a = acceleration(f);
        f *= 1 + (v / cell + a / x * dt) * dt;   // eq. 39
        x += v * (x / cell) * dt + a * dt * dt;  // eq. 37
        v += a * dt;                             // eq. 38
    }
};

TEST(OneParticle, FollowsTheRecursionOfUpdateStressFirst) {
    const double dt = 0.1 * cell / wave_speed;
    OneParticle code("usf", {{"step", dt}}, 0.55 * cell, 0.2);
    Recursion exact{0.55 * cell, 0.2};
    for (int step = 0; step < 2000; ++step) {
        code.advance(1);
        exact.usf(dt);
        ASSERT_NEAR(code.value("position"), exact.x, 1e-12 * cell) << "step " << step;
        ASSERT_NEAR(code.value("velocity"), exact.v, 1e-12 * wave_speed) << "step " << step;
        ASSERT_NEAR(code.value("deformation_gradient"), exact.f, 1e-12) << "step " << step;
    }
    EXPECT_GT(std::abs(exact.f - 1) + std::abs(exact.v) / wave_speed, 0.01);  // it still vibrates
}

TEST(OneParticle, FollowsTheRecursionOfUpdateStressLast) {
    const double dt = 0.01 * cell / wave_speed;
    OneParticle code("usl", {{"step", dt}}, 0.55 * cell, 0.2);
    Recursion exact{0.55 * cell, 0.2};
    for (int step = 0; step < 2000; ++step) {
        code.advance(1);
        exact.usl(dt);
        ASSERT_NEAR(code.value("position"), exact.x, 1e-12 * cell) << "step " << step;
        ASSERT_NEAR(code.value("velocity"), exact.v, 1e-12 * wave_speed) << "step " << step;
        ASSERT_NEAR(code.value("deformation_gradient"), exact.f, 1e-12) << "step " << step;
    }
    EXPECT_GT(std::abs(exact.f - 1) + std::abs(exact.v) / wave_speed, 0.01);
}

/// Whether a vibration too small to move the particle grows in `steps` at the Courant number k.
bool grows(const std::string& integrator, double x, double k) {
    constexpr double first = 1e-6 * wave_speed;
    constexpr int steps = 4000;
    OneParticle code(integrator, {{"step", k * cell / wave_speed}}, x, first);
    try {
        for (int step = 0; step < steps; ++step) {
            code.advance(1);
            if (std::abs(code.value("velocity")) > 100 * first) return true;
        }
    } catch (const Breakdown&) {
        return true;
    }
    return false;
}

class OneParticleLimit : public testing::TestWithParam<double> {};

/// Small vibrations e = F - 1, V = v / c: eq. 38, 39 become e' = (1 - k^2 h/x) e + k V, V' = V - k e with
/// k = c dt / h, which decay for k < 2 / sqrt(2 h/x - 1): the nearer to the held node, the shorter the step.
TEST_P(OneParticleLimit, OfUpdateStressLastDependsOnTheParticlesPlace) {
    const double x = GetParam() * cell, limit = 2 / std::sqrt(2 * cell / x - 1);
    for (const std::string integrator : {"usl", "central_difference"}) {
        EXPECT_FALSE(grows(integrator, x, 0.99 * limit)) << integrator;
        EXPECT_TRUE(grows(integrator, x, 1.01 * limit)) << integrator;
    }
}

/// Here the gradient is that of the particle's own velocity, v / h, and the limit is k = 2 wherever it is.
TEST_P(OneParticleLimit, OfOtherIntegratorsDoesNot) {
    for (const std::string integrator : {"usf", "musl", "uvf"}) {
        EXPECT_FALSE(grows(integrator, GetParam() * cell, 0.99 * 2)) << integrator;
        EXPECT_TRUE(grows(integrator, GetParam() * cell, 1.01 * 2)) << integrator;
    }
}

/// So an automatic step that is stable for these integrators may be too long for the others.
TEST_P(OneParticleLimit, IsNotWhatTheAutomaticStepLooksAt) {
    const OneParticle code("usl", {{"cfl", 0.4}}, GetParam() * cell, 0);
    EXPECT_DOUBLE_EQ(code.simulation->next_time_step(), 0.4 * cell / wave_speed);
}

INSTANTIATE_TEST_SUITE_P(Places, OneParticleLimit, testing::Values(0.05, 0.2, 0.5, 0.9),
                         [](const auto& place) {
                             return "Percent" + std::to_string(std::lround(100 * place.param));
                         });

}  // namespace
}  // namespace matpoint::conformance
