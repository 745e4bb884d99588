// The exact solutions in more than one dimension.
#include "made_solution.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace matpoint::conformance {
namespace {

using Vector = Eigen::Vector3d;

TEST(AxisAlignedVibration, ConformsInEveryDimension) {
    for (const char* mode : {"bar", "plane_strain", "solid"})
        for (const double nu : {0.0, 0.3, -0.4, 0.48})
            for (const double amplitude : {1e-3, 0.1, -0.25}) {
                SCOPED_TRACE(std::string(mode) + ", nu " + std::to_string(nu) + ", A " +
                             std::to_string(amplitude));
                const Made made(mode, rubber("neo_hookean", 1, 1e4, nu), axis_aligned(amplitude));
                made.check({.min = Vector::Zero(), .max = Vector::Ones(), .end = 0.05});
            }
    const Made small("solid", rubber("neo_hookean", 1200, 3e6, 0.4), axis_aligned(2e-3, 0.02));
    small.check({.min = Vector::Zero(), .max = Vector::Constant(0.02), .end = 1e-3});
}

/// [Wallstedt & Guilkey 2008, eq. 56]: x is a cosine, y a sine; the period is 2 L / c.
TEST(AxisAlignedVibration, HasThePapersPhases) {
    const Made made("plane_strain", rubber("neo_hookean", 1, 1e4, 0.3), axis_aligned(0.1));
    const Vector middle(0.5, 0.5, 0);
    EXPECT_LT((made.solution->displacement(middle, 0) - Vector(0.1, 0, 0)).norm(), 1e-16);
    EXPECT_LT((made.solution->displacement(middle, 0.005) - Vector(0, 0.1, 0)).norm(), 1e-16);
    EXPECT_LT((made.solution->displacement(middle, 0.02) - Vector(0.1, 0, 0)).norm(), 1e-15);
    EXPECT_NEAR(made.solution->velocity(middle, 0)[1], 0.1 * 100 * std::numbers::pi, 1e-13);
}

TEST(AxisAlignedVibration, RefusesWhatTurnsItInsideOut) {
    const Json material = rubber("neo_hookean", 1, 1e4, 0.3);
    EXPECT_TRUE(Made("plane_strain", material, axis_aligned(-0.32)).has_rule(true, "/amplitude"));
    EXPECT_FALSE(Made("plane_strain", material, axis_aligned(-0.31)).has_rule(true, "/amplitude"));
    EXPECT_TRUE(Made("axisymmetric", material, axis_aligned(0.1)).has_rule(true, ""));
    EXPECT_TRUE(
        Made("plane_strain", rubber("linear_elastic", 1, 1, 0), axis_aligned(0.1)).has_rule(true, "/body"));
    EXPECT_TRUE(Made("plane_strain", material, axis_aligned(0.1)).has_rule(false, ""));
}

TEST(ExpandingRing, ConformsForOtherRings) {
    for (const Json& own :
         {ring(0.4, 0.6, 0.1), ring(0.4, 0.6, -0.06, 3), ring(0.1, 0.9, 0.05), ring(2, 5, 0.4)}) {
        SCOPED_TRACE(own.dump());
        const double inner = own.at("inner_radius"), outer = own.at("outer_radius");
        const Made made("plane_strain", rubber("neo_hookean", 3, 2e4, 0), own);
        EXPECT_FALSE(Made(made.scene["space"]["mode"], made.scene["materials"]["rubber"], own)
                         .has_rule(true, "/amplitude"));
        made.check({.min = {-outer, -outer, 0},
                    .max = {outer, outer, 0},
                    .end = 0.1,
                    .within = [=](const Vector& x) { return x.norm() >= inner && x.norm() <= outer; }});
    }
}

/// Both surfaces at any time and place: no traction; the outer one moves by A, the inner one by what eq. 60
/// gives, 1.037 A.
TEST(ExpandingRing, HasFreeSurfaces) {
    const double e = 1e4, amplitude = 0.1, period = 0.02;
    const Made made("plane_strain", rubber("neo_hookean", 1, e, 0), ring(0.4, 0.6, amplitude));
    for (double angle = 0; angle < 6.28; angle += 0.37)
        for (double time = 0; time < 0.03; time += 0.0011) {
            const Vector n(std::cos(angle), std::sin(angle), 0);
            for (const double r : {0.4, 0.6})
                EXPECT_LT((made.solution->stress(r * n, time) * n).norm(), 1e-14 * e);
            const double wave = std::cos(2 * std::numbers::pi * time / period);
            EXPECT_LT((made.solution->displacement(0.6 * n, time) - amplitude * wave * n).norm(), 1e-15);
            EXPECT_LT(
                (made.solution->displacement(0.4 * n, time) - 0.224 / 0.216 * amplitude * wave * n).norm(),
                1e-15);
        }
}

/// body_force.csv comes from symbolic algebra: derive.py.
TEST(ExpandingRing, HasTheBodyForceOfThePapersDerivation) {
    std::ifstream file(std::filesystem::path(PLUGIN_SOURCES) /
                       "exact_solution/expanding_ring/body_force.csv");
    std::string line;
    std::getline(file, line);
    ASSERT_EQ(line, "youngs_modulus,density,inner_radius,outer_radius,amplitude,length,x,y,t,b_x,b_y");
    int rows = 0;
    for (; std::getline(file, line); ++rows) {
        std::vector<double> v;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) v.push_back(std::stod(cell));
        ASSERT_EQ(v.size(), 11U);
        const Made made("plane_strain", rubber("neo_hookean", v[1], v[0], 0), ring(v[2], v[3], v[4], v[5]));
        const Vector exact(v[9], v[10], 0), b = made.solution->body_force({v[6], v[7], 0}, v[8]);
        EXPECT_LT((b - exact).norm(), 1e-12 * exact.norm()) << line;
    }
    EXPECT_EQ(rows, 54);
}

TEST(ExpandingRing, RefusesWhatItIsNoSolutionFor) {
    const Json material = rubber("neo_hookean", 1, 1e4, 0);
    const auto refuses = [&](const Json& own, const char* pointer) {
        return Made("plane_strain", material, own).has_rule(true, pointer);
    };
    EXPECT_TRUE(refuses(ring(0.6, 0.6, 0.01), "/inner_radius"));
    EXPECT_TRUE(refuses(ring(0.2, 0.6, 0.01), "/amplitude"));  // no solution of eq. 61
    EXPECT_TRUE(refuses(ring(0.4, 0.6, 0.4), "/amplitude"));
    EXPECT_FALSE(refuses(ring(0.4, 0.6, 0.3), "/amplitude"));
    EXPECT_TRUE(Made("axisymmetric", material, ring(0.4, 0.6, 0.1)).has_rule(true, ""));
    EXPECT_TRUE(Made("plane_strain", rubber("neo_hookean", 1, 1e4, 0.1), ring(0.4, 0.6, 0.1))
                    .has_rule(true, "/body"));
    EXPECT_TRUE(Made("plane_strain", material, ring(0.4, 0.6, 0.1)).has_rule(false, ""));
}

/// What is left out is quadratic in the amplitude, which the kit allows for: at 1e-9 the terms of first order
/// are what it sees.
TEST(PlateVibration, ConformsInBothModes) {
    for (const char* mode : {"shear", "dilatation"})
        for (const double amplitude : {1e-9, 4e-5, 1e-3}) {
            SCOPED_TRACE(std::string(mode) + ", A " + std::to_string(amplitude));
            const Made made("plane_strain", rubber("linear_elastic", 1, 1000, 0.3), plate(amplitude, mode));
            made.check({.min = Vector::Zero(), .max = Vector(1, 1, 0), .end = 0.1, .infinitesimal = true});
        }
    const Made large("plane_strain", rubber("neo_hookean", 1200, 3e6, 0.4), plate(1e-6, "shear", 2));
    large.check({.min = Vector::Zero(), .max = Vector(2, 2, 0), .end = 0.1, .infinitesimal = true});
}

/// "Particles can move normal to the side, but not tangentially" [Wallstedt & Guilkey 2007, section 5.3].
TEST(PlateVibration, HasFreeNormalsAndHeldTangents) {
    for (const char* mode : {"shear", "dilatation"}) {
        const Made made("plane_strain", rubber("linear_elastic", 1, 1000, 0.3), plate(1e-4, mode));
        for (const double along : {0.1, 0.4, 0.8})
            for (const double side : {0.0, 1.0}) {
                const Vector x(side, along, 0), y(along, side, 0);
                EXPECT_NEAR(made.solution->velocity(x, 0.01)[1], 0, 1e-16);
                EXPECT_NEAR(made.solution->velocity(y, 0.01)[0], 0, 1e-16);
                EXPECT_GT(std::abs(made.solution->velocity(x, 0.01)[0]), 1e-5);
                EXPECT_NEAR(made.solution->stress(x, 0.01)(0, 0), 0, 1e-15);
                EXPECT_NEAR(made.solution->stress(y, 0.01)(1, 1), 0, 1e-15);
            }
        const double volume = made.solution->deformation_gradient({0.5, 0.5, 0}, 0).determinant() - 1;
        EXPECT_EQ(std::abs(volume) > 1e-4, std::string(mode) == "dilatation");
    }
}

TEST(PlateVibration, WarnsOfLargeAmplitudes) {
    const Json material = rubber("linear_elastic", 1, 1000, 0.3);
    EXPECT_TRUE(Made("plane_strain", material, plate(0.011, "shear")).has_rule(false, "/amplitude"));
    EXPECT_FALSE(Made("plane_strain", material, plate(0.009, "shear")).has_rule(false, "/amplitude"));
    EXPECT_TRUE(
        Made("plane_strain", rubber("j2_plasticity", 1, 1, 0), plate(1e-5, "shear")).has_rule(true, "/body"));
}

}  // namespace
}  // namespace matpoint::conformance
