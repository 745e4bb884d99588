// Bars: what is built from reflected waves, against Fourier series and what is conserved.

#include "solutions_fixture.hpp"

#include <cmath>
#include <numbers>

namespace matpoint {

namespace {

constexpr double length = 1.5, period = 4 * length / 5;  ///< m, s
constexpr int terms = 4000;
/// The series' rest: the sum of 1/k_n^2 over the terms that are left out.
constexpr double rest = 4 * length * length / (std::numbers::pi * std::numbers::pi) / (4 * terms);

/// Wave number of the n-th mode of a bar with one fixed and one free end, n from 0.
double wave_number(int n) {
    return (2 * n + 1) * std::numbers::pi / (2 * length);
}

}  // namespace

class SolutionsBars : public SolutionsTest {
  protected:
    /// Kinetic plus strain energy (J/m^2) and momentum (kg/(m s)) of the part [min, max] of the bar.
    struct Totals {
        double energy = 0, momentum = 0;
    };
    static Totals totals(const ExactSolution& solution, double min, double max, double time) {
        Totals totals;
        const int parts = 3000;
        const double dx = (max - min) / parts;
        for (int i = 0; i < parts; ++i) {
            const Eigen::Vector3d x(min + (i + 0.5) * dx, 0, 0);
            const double v = solution.velocity(x, time)[0], stress = solution.stress(x, time)(0, 0);
            totals.energy += (density * v * v / 2 + stress * stress / (2 * modulus)) * dx;
            totals.momentum += density * v * dx;
        }
        return totals;
    }
};

/// u = sum_n 2 v / (L k_n^2 c) sin(k_n X) sin(k_n c t): modes that have v as their velocity at the start.
TEST_F(SolutionsBars, StoppedBarIsItsFourierSeries) {
    constexpr double v = 0.7;
    const auto bar = make({{"type", "bar_stop"}, {"velocity", v}, {"length", length}}, elastic());
    for (const double x : {0.01, 0.4, 1.1, 1.5})
        for (double t = 0; t < 2 * period; t += 0.037) {
            double u = 0;
            for (int n = 0; n < terms; ++n) {
                const double k = wave_number(n);
                u += 2 * v / (length * k * k * c) * std::sin(k * x) * std::sin(k * c * t);
            }
            EXPECT_NEAR(bar->displacement({x, 0, 0}, t)[0], u, 2 * v / (length * c) * rest) << x << " " << t;
        }
    EXPECT_NEAR(bar->displacement({length, 0, 0}, period / 4)[0], v * length / c, 1e-15);
}

/// u = f X / E - sum_n 2 f (-1)^n / (E L k_n^2) sin(k_n X) cos(k_n c t): the static solution less modes that
/// have it as their displacement at the start.
TEST_F(SolutionsBars, DrawnBarIsItsFourierSeries) {
    constexpr double f = 3;
    const auto bar = make({{"type", "bar_step"}, {"traction", f}, {"length", length}}, elastic());
    for (const double x : {0.01, 0.4, 1.1, 1.5})
        for (double t = 0; t < 2 * period; t += 0.037) {
            double u = f * x / modulus;
            for (int n = 0; n < terms; ++n) {
                const double k = wave_number(n);
                u -= 2 * f * (n % 2 ? -1 : 1) / (modulus * length * k * k) * std::sin(k * x) *
                     std::cos(k * c * t);
            }
            EXPECT_NEAR(bar->displacement({x, 0, 0}, t)[0], u, 2 * f / (modulus * length) * rest)
                << x << " " << t;
        }
}

/// The stress of [Chen & Brannon 2002, figure 2]: a front f, doubled by the wall, taken back by the end.
TEST_F(SolutionsBars, FrontsOfTheDrawnBarAreWhereTheyBelong) {
    const auto bar = make({{"type", "bar_step"}, {"traction", 3}, {"length", length}}, elastic());
    const auto stress = [&](double x, double lengths_run) {
        return bar->stress({x, 0, 0}, lengths_run * length / c)(0, 0);
    };
    EXPECT_NEAR(stress(0.9 * length, 0.3), 3, 1e-12);
    EXPECT_NEAR(stress(0.6 * length, 0.3), 0, 1e-12);
    EXPECT_NEAR(stress(0.2 * length, 1.3), 6, 1e-12);
    EXPECT_NEAR(stress(0.4 * length, 1.3), 3, 1e-12);
    EXPECT_NEAR(stress(0.8 * length, 2.3), 3, 1e-12);
    EXPECT_NEAR(stress(0.6 * length, 2.3), 6, 1e-12);
    EXPECT_NEAR(stress(0.5 * length, 4), 0, 1e-12);
}

TEST_F(SolutionsBars, EnergyOfAStandingWaveStays) {
    const auto bar =
        make({{"type", "bar_wave"}, {"amplitude", 0.02}, {"mode", 3}, {"length", length}}, elastic());
    const double k = 3 * std::numbers::pi / length, energy = modulus * std::pow(0.02 * k, 2) * length / 4;
    for (const double t : {0.0, 0.03, 0.11, 0.4})
        EXPECT_NEAR(totals(*bar, 0, length, t).energy, energy, 1e-12 * energy);
    EXPECT_EQ(bar->displacement({0, 0, 0}, 0.1)[0], 0);
    EXPECT_NEAR(bar->displacement({length, 0, 0}, 0.1)[0], 0, 1e-15);
}

/// Momentum goes over at the constant force rho c v, until all of it is turned round after 2 L / c.
TEST_F(SolutionsBars, ImpactTurnsTheMomentumRound) {
    constexpr double v = 0.2, start = -1, gap = 0.4, near = 0.1, contact = (gap - near) / (2 * v);
    const auto bars = make({{"type", "bar_impact"},
                            {"velocity", v},
                            {"start", start},
                            {"length", length},
                            {"gap", gap},
                            {"contact_distance", near}},
                           elastic());
    const double left_end = start + length, right_end = left_end + gap, mass = density * length;
    for (const double part : {-0.5, 0.0, 0.1, 0.5, 0.8, 1.0, 1.7}) {  // of 2 L / c since contact
        const double t = contact + part * 2 * length / c, done = std::clamp(part, 0.0, 1.0);
        const Totals left = totals(*bars, start, left_end, t),
                     right = totals(*bars, right_end, right_end + length, t);
        EXPECT_NEAR(left.momentum, mass * v * (1 - 2 * done), 1e-3 * mass * v) << part;
        EXPECT_NEAR(right.momentum, -left.momentum, 1e-9);
        EXPECT_NEAR(left.energy, mass * v * v / 2, 1e-9);
        EXPECT_NEAR(right.energy, mass * v * v / 2, 1e-9);
        // The bars' ends: `near` apart in contact.
        const double distance =
            gap + bars->displacement({right_end, 0, 0}, t)[0] - bars->displacement({left_end, 0, 0}, t)[0];
        const double flight = std::max({-part, part - 1, 0.0}) * 2 * length / c;
        EXPECT_NEAR(distance, near + 2 * v * flight, 1e-12) << part;
    }
    EXPECT_NEAR(bars->stress({left_end - 0.01, 0, 0}, contact + 0.1)(0, 0), -density * c * v, 1e-12);
    EXPECT_NEAR(bars->stress({right_end + 0.01, 0, 0}, contact + 0.1)(0, 0), -density * c * v, 1e-12);
    EXPECT_NEAR(bars->stress({start + 0.01, 0, 0}, contact + 0.1)(0, 0), 0, 1e-12);
}

}  // namespace matpoint
