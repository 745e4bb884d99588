#include "step/artificial_viscosity.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace matpoint {
namespace {

using Form = ArtificialViscosity::Form;
constexpr Form forms[] = {Form::landshoff, Form::chen_brannon};

// In other units of length, time and mass it is the same pressure.
TEST(ArtificialViscosityForm, HasTheUnitsOfAPressure) {
    constexpr double m = 3, s = 0.7, kg = 5, pascal = kg / (m * s * s);
    for (const Form form : forms) {
        const ArtificialViscosity own{
            .form = form, .linear = 0.3, .quadratic = 1.7, .bulk_modulus = 2.5, .length = 0.2};
        ArtificialViscosity other = own;
        other.length *= m;
        *other.bulk_modulus *= pascal;
        const double pressure = own.pressure({1.2, 2, 0.8, 3});
        EXPECT_GT(pressure, 0);
        EXPECT_NEAR(other.pressure({1.2 * kg / (m * m * m), 2 * m / s, 0.8 / s, 3 / s}), pressure * pascal,
                    1e-14 * pressure * pascal);
        EXPECT_EQ(own.pressure({1.2, 2, 0, 3}), 0) << "no compression";
    }
}

TEST(ArtificialViscosityForm, IsThatOfTheTextbooks) {
    // rho 2, h 0.5, c 3, |D| 4: linear part 2 * 0.5 * 4 * 3 = 12, quadratic 2 * 0.25 * 16 = 8.
    const ArtificialViscosity landshoff{.linear = 0.5, .quadratic = 2, .length = 0.5};
    EXPECT_DOUBLE_EQ(landshoff.pressure({2, 3, 4, 4}), 0.5 * 12 + 2 * 8);
    // sqrt(9 * (0.5 / 3) * 2 * 18 * 6) = 18, and half of the largest compression.
    const ArtificialViscosity report{
        .form = Form::chen_brannon, .linear = 0.5, .quadratic = 2, .length = 0.5};
    EXPECT_DOUBLE_EQ(report.pressure({2, 3, 6, 12}), 18 * (0.5 + 2 * 0.5));
}

// u'' = -w^2 u - b u' by central differences, where b u' is of the velocity half a step before, as forces of
// the artificial pressure are: w = 2 c / h, b = w^2 q / (rho c^2 |D|).
TEST(ArtificialViscosityForm, ItsSpeedIsThatOfTheStableStep) {
    const ArtificialViscosity viscosity{.linear = 0.6, .quadratic = 1, .length = 0.5};
    const ArtificialViscosity::State state{2, 3, 4, 4};
    const double q = viscosity.pressure(state);
    const auto swings = [&](double step) {
        const double w = 2 * state.wave_speed / viscosity.length;
        const double b =
            w * w * q / (state.density * state.wave_speed * state.wave_speed * state.compression);
        double u = 1, v = 0;
        for (int k = 0; k < 2000; ++k) {
            v -= (w * w * u + b * v) * step;
            u += v * step;
        }
        return std::abs(u) + std::abs(v);
    };
    const double limit = viscosity.length / viscosity.speed(state, q);
    EXPECT_LT(swings(0.99 * limit), 1);
    EXPECT_GT(swings(1.01 * limit), 1e6);
}

}  // namespace
}  // namespace matpoint
