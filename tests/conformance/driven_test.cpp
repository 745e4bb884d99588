// Bodies all of whose nodes are driven by a field: its flow carries their particles.
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace matpoint::conformance {
namespace {

using Complex = std::complex<double>;
constexpr double degree = std::numbers::pi / 180;
constexpr Complex centre{0.3, 0.2};

/// Off the middle of its grid, driven from its first velocity on.
Json driven_disk(const Json& velocity, double step) {
    Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [-1, -1], "max": [2, 2], "cell_size": 0.25},
        "health": {"energy_gain": 1e9},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 100, "poissons_ratio": 0.3}},
        "bodies": {"disk": {"material": "rubber",
                            "geometry": {"type": "sphere", "center": [0.3, 0.2], "radius": 0.5}}},
        "outputs": [{"type": "csv", "fields": ["velocity", "deformation_gradient"]}],
        "boundary_conditions": [{"type": "velocity", "name": "drive",
                                 "on": {"type": "box", "min": [-1, -1], "max": [2, 2]}}]
    })json");
    scene["time"] = {{"end", 1e9}, {"step", step}};
    scene["boundary_conditions"][0]["velocity"] = scene["bodies"]["disk"]["velocity"] = velocity;
    return scene;
}

struct Driven : Simulated {
    using Simulated::Simulated;

    /// A field of the particles as complex numbers.
    std::vector<Complex> plane(const std::string& field) const {
        const auto x = simulation->column("disk", field, 0), y = simulation->column("disk", field, 1);
        std::vector<Complex> all;
        for (std::size_t p = 0; p < x.size(); ++p) all.emplace_back(x[p], y[p]);
        return all;
    }
};

class EveryIntegrator : public testing::TestWithParam<const char*> {
  protected:
    static Json with(Json scene, const char* transfer = "affine_flip") {
        scene["integrator"] = {{"type", GetParam()}};
        scene["transfer"] = {{"type", transfer}};
        return scene;
    }
    static bool staggered() {
        const std::string name = GetParam();
        return name == "uvf" || name == "central_difference";
    }
};

// Five turns and an eighth at one degree a step, where the chord's radius would be 1.32 times as large.
TEST_P(EveryIntegrator, TurnsADrivenDisk) {
    constexpr int steps = 5 * 360 + 45;
    const Complex turn = std::polar(1.0, steps * degree);
    for (const char* transfer : {"flip", "apic"})
        for (const bool single : {false, true}) {
            Json scene = with(driven_disk({"0.2 - y", "x - 0.3"}, degree), transfer);
            if (single) scene["space"]["precision"] = "single";
            Driven run(scene);
            const auto start = run.plane("position");
            run.advance(steps);
            const auto x = run.plane("position"), v = run.plane("velocity"),
                       f = run.plane("deformation_gradient");
            for (std::size_t p = 0; p < x.size(); ++p) {
                const Complex arm = turn * (start[p] - centre);
                EXPECT_LT(std::abs(x[p] - centre - arm), single ? 1e-6 : 1e-7);
                EXPECT_LT(std::abs(f[p] - turn), single ? 1e-5 : 1e-7);
                // The mean over the last step is that of its middle, and shorter as the chord is.
                const Complex middle =
                    Complex(0, 1) * arm * std::polar(std::sin(degree / 2) / (degree / 2), -degree / 2);
                EXPECT_LT(std::abs(v[p] - middle), single ? 2e-4 : 1e-7) << transfer;
            }
        }
}

// m w^2 R towards the centre, 0.7 m away.
TEST_P(EveryIntegrator, ABodyOnAnArmIsHeldTowardsTheCentre) {
    Json scene = with(driven_disk({"-0.2 - y", "x + 0.2"}, degree / 8));
    scene["bodies"]["disk"]["geometry"]["radius"] = 0.3;
    Driven run(scene);
    run.advance(10);
    const auto mass = run->column("disk", "mass", 0);
    const auto x = run.plane("position");
    Complex expected = 0;
    for (std::size_t p = 0; p < x.size(); ++p) expected -= mass[p] * (x[p] - Complex(-0.2, -0.2));
    const auto reaction = run->reaction("drive");
    EXPECT_LT(std::abs(Complex(reaction[0], reaction[1]) - expected), 0.01 * std::abs(expected));
    EXPECT_LT(run->conservation().momentum_drift, 1e-12);
}

// Faster and faster: by t^2 / 2. Of second order where velocities live at half steps, of first elsewhere.
TEST_P(EveryIntegrator, FollowsARotationThatGrows) {
    const auto error = [&](int steps) {
        Json scene = with(driven_disk({0, 0}, 1.0 / steps));
        scene["boundary_conditions"][0]["velocity"] = {"t*(0.2 - y)", "t*(x - 0.3)"};
        Driven run(scene);
        const auto start = run.plane("position");
        run.advance(steps);
        double largest = 0;
        for (std::size_t p = 0; const Complex& x : run.plane("position"))
            largest = std::max(largest, std::abs(x - centre - std::polar(1.0, 0.5) * (start[p++] - centre)));
        return largest;
    };
    if (staggered())
        EXPECT_LT(error(16), 1e-6) << "the mean rate of a step is that of its middle";
    else
        EXPECT_NEAR(std::log2(error(16) / error(32)), 1, 0.1);
}

// The flow of [x - 0.3, 0.2 - y] is a stretch by e^t and e^-t; so is F.
TEST_P(EveryIntegrator, StretchesByTheExponential) {
    Driven run(with(driven_disk({"x - 0.3", "0.2 - y"}, 0.02)));
    const auto start = run.plane("position");
    run.advance(25);
    const auto x = run.plane("position");
    const auto f = run->column("disk", "deformation_gradient", 0);
    for (std::size_t p = 0; p < x.size(); ++p) {
        const Complex arm = start[p] - centre;
        EXPECT_LT(std::abs(x[p] - centre - Complex(std::exp(0.5) * arm.real(), std::exp(-0.5) * arm.imag())),
                  1e-7);
        EXPECT_NEAR(f[p], std::exp(0.5), 1e-7);
    }
}

// What does not change along the path is prescribed as it is given.
TEST_P(EveryIntegrator, AFieldThatIsTheSameAllAlongIsAConstant) {
    const auto moved = [&](const Json& velocity, const Json& drive) {
        Json scene = with(driven_disk(velocity, 0.01));
        scene["boundary_conditions"][0]["velocity"] = drive;
        return Driven(scene).advance(20)->column("disk", "position", 0);
    };
    const Json still = {0, 0}, table = {{"times", {0, 1}}, {"values", {0, 0.3}}};
    EXPECT_EQ(moved(still, {"0.1 + 0*x", "x"}), moved(still, {0.1, "x"}));
    EXPECT_EQ(moved(still, {table, 0}), moved(still, {table, "x - 0.3"}));
    const auto v = Driven(with(driven_disk({0.1, 0}, 0.01))).advance(20)->column("disk", "velocity", 0);
    for (const double one : v) EXPECT_NEAR(one, 0.1, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Driven, EveryIntegrator,
                         testing::Values("usf", "usl", "musl", "uvf", "central_difference"),
                         [](const auto& integrator) { return std::string(integrator.param); });

}  // namespace
}  // namespace matpoint::conformance
