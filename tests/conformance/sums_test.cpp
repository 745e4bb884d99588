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
    EXPECT_NEAR(code->energies().kinetic, kinetic, 1e-13 * kinetic);
}

TEST(SumsOfSinglePrecision, HoldEnergiesBelowItsSmallestNumber) {
    constexpr double density = 1e-24, speed = 1e-8, area = 0.64;  // kg/m^3, m/s, m^2
    Json scene = busy_scene();
    scene["space"]["precision"] = "single";
    scene["materials"]["rubber"]["density"] = density;
    scene["materials"]["rubber"]["youngs_modulus"] = 1e-22;
    scene["loads"] = Json::array();
    scene["bodies"]["square"]["velocity"] = {speed, 0};
    Simulated code(scene);
    code.advance(1);
    const double exact = density * area * speed * speed / 2;
    EXPECT_NEAR(code->energies().kinetic, exact, 1e-6 * exact);
}

}  // namespace
}  // namespace matpoint::conformance
