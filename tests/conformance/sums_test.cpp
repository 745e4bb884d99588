// Sums over particles of single precision are sums in double precision of what the particles hold.
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matpoint::conformance {
namespace {

TEST(SumsOfSinglePrecision, AreThoseOfTheParticlesNumbersInDouble) {
    Json scene = busy_scene();
    scene["space"]["precision"] = "single";
    Simulated code(scene);
    code.advance(10);
    const auto mass = code->column("square", "mass", 0);
    double kinetic = 0;
    for (int c = 0; c < 2; ++c) {
        const auto velocity = code->column("square", "velocity", c);
        double momentum = 0;
        for (std::size_t p = 0; p < mass.size(); ++p) {
            momentum += mass[p] * velocity[p];
            kinetic += mass[p] * velocity[p] * velocity[p] / 2;
        }
        const double sum = code->momentum()[static_cast<std::size_t>(c)];
        EXPECT_NEAR(sum, momentum, 1e-13 * std::abs(momentum)) << "component " << c;
    }
    EXPECT_NEAR(code->energy().kinetic, kinetic, 1e-13 * kinetic);
}

/// Masses whose energy is beyond the largest number of single precision's reach.
TEST(SumsOfSinglePrecision, HoldTinyEnergies) {
    Json scene = busy_scene();
    scene["space"]["precision"] = "single";
    scene["materials"]["rubber"]["density"] = 1e-30;
    scene["materials"]["rubber"]["youngs_modulus"] = 1e-28;
    scene["loads"] = Json::array();
    scene["bodies"]["square"]["velocity"] = {1e-6, 0};
    Simulated code(scene);
    code.advance(1);
    EXPECT_NEAR(code->energy().kinetic, 0.5 * 1e-30 * 0.64 * 1e-12, 1e-6 * 0.5 * 1e-30 * 0.64 * 1e-12);
}

}  // namespace
}  // namespace matpoint::conformance
