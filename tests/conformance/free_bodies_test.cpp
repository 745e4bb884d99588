// Disks and balls with free surfaces, that vibrate or spin: solutions for small strains.
#include "made_solution.hpp"

namespace matpoint::conformance {
namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

Json vibration(const char* type, double amplitude, double radius, const Json& more = Json::object()) {
    Json own = {{"type", type}, {"amplitude", amplitude}, {"radius", radius}};
    own.update(more);
    return own;
}
Json disk(double amplitude, double radius, const Json& more = Json::object()) {
    return vibration("free_disk_vibration", amplitude, radius, more);
}
Json sphere(const char* mode, double amplitude, double radius, const Json& more = Json::object()) {
    Json own = vibration("free_sphere_vibration", amplitude, radius, more);
    own["mode"] = mode;
    return own;
}
Json spin(double rate, double radius) {
    return {{"type", "spinning_disk"}, {"angular_velocity", rate}, {"radius", radius}};
}
/// lambda + 2 mu = rho = 1: a speed of sound of 1.
Json unit_rubber(double nu) {
    return rubber("linear_elastic", 1, (1 + nu) * (1 - 2 * nu) / (1 - nu), nu);
}

Samples ball(const Vector& center, double radius, int dimension, double end) {
    Vector reach = Vector::Zero();
    reach.head(dimension).setConstant(radius);
    return {.min = center - reach,
            .max = center + reach,
            .end = end,
            .within = [=](const Vector& x) { return (x - center).norm() <= radius; },
            .infinitesimal = true};
}

/// w R over the speed of a wave, of u = A U(X) sin(wt), where `rim` has the largest displacement.
double root(const Made& made, const Vector& rim, double amplitude, double speed) {
    return made.solution->velocity(rim, 0).norm() / amplitude * rim.norm() / speed;
}

/// The largest traction that Hooke's law, in an isotropic material of these constants, finds from difference
/// quotients of the displacement on a ball's surface, over the largest stress in it.
double surface_traction(const ExactSolution& solution, int dimension, double radius, double lambda, double mu,
                        double time) {
    const double h = 1e-3 * radius;
    double surface = 0, inside = 0;
    for (double angle = 0.1; angle < 6.2; angle += 0.37)
        for (double height = dimension == 2 ? 0 : -0.9; height < 1; height += dimension == 2 ? 1 : 0.3)
            for (const double part : {1.0, 0.5}) {
                const double around = std::sqrt(1 - height * height);
                const Vector n(around * std::cos(angle), around * std::sin(angle), height);
                Matrix gradient = Matrix::Zero();
                for (int a = 0; a < dimension; ++a)
                    gradient.col(a) =
                        derivative(
                            [&](double s) -> Vector {
                                return solution.displacement(part * radius * n + s * Vector::Unit(a), time);
                            },
                            h)
                            .value;
                const Matrix stress =
                    lambda * gradient.trace() * Matrix::Identity() + mu * (gradient + gradient.transpose());
                (part < 1 ? inside : surface) =
                    std::max(part < 1 ? inside : surface, part < 1 ? stress.norm() : (stress * n).norm());
            }
    return surface / inside;
}

TEST(FreeDiskVibration, ConformsForOtherDisks) {
    for (const double amplitude : {1e-9, 1e-4})
        for (const double nu : {-0.3, 0.0, 0.3, 0.49}) {
            SCOPED_TRACE(nu);
            const Made made("plane_strain", rubber("neo_hookean", 1200, 3e6, nu),
                            disk(amplitude * 0.2, 0.2, {{"center", {1, -2}}}));
            made.check(ball({1, -2, 0}, 0.2, 2, 0.02));
        }
    const Made flying("plane_strain", unit_rubber(0.3), disk(1e-4, 1, {{"drift", {0.1, -0.03}}}));
    flying.check(ball(Vector::Zero(), 1, 2, 10));
    EXPECT_LT((flying.solution->displacement(Vector::Zero(), 4) - Vector(0.4, -0.12, 0)).norm(), 1e-15);
}

/// In plane stress with nu = 0.3, which is plane strain with 0.3/1.3: kR = 2.0488 [IRE Standards on
/// Piezoelectric Crystals 1961]; and the equation, with the library's Bessel functions.
TEST(FreeDiskVibration, HasTextbookFrequencies) {
    const auto kr = [](double nu) {
        return root({"plane_strain", unit_rubber(nu), disk(1e-3, 1)}, {0.6, -0.8, 0}, 1e-3, 1);
    };
    EXPECT_NEAR(kr(0.3), 2.125749, 1e-6);
    EXPECT_NEAR(kr(0.3 / 1.3), 2.0488, 1e-4);
    for (const double nu : {-0.9, 0.0, 0.2, 0.45, 0.4999})
        EXPECT_NEAR(kr(nu) * std::cyl_bessel_j(0, kr(nu)),
                    (1 - 2 * nu) / (1 - nu) * std::cyl_bessel_j(1, kr(nu)), 1e-13);
}

TEST(FreeDiskVibration, IsABesselFunctionOfTheRadius) {
    const Made made("plane_strain", unit_rubber(0.3), disk(1e-3, 2));
    const double k = 2.125749 / 2, quarter = std::numbers::pi / 2 / k;
    for (const double r : {0.0, 1e-8, 0.3, 1.0, 2.0})
        EXPECT_NEAR(made.solution->displacement({0, r, 0}, quarter)[1],
                    1e-3 * std::cyl_bessel_j(1, k * r) / std::cyl_bessel_j(1, 2 * k), 1e-9);
}

TEST(FreeDiskVibration, HasAFreeRim) {
    const Made made("plane_strain", rubber("neo_hookean", 1, 1, 0.3), disk(1e-3, 1.5));
    const double lambda = 0.3 / 1.3 / 0.4, mu = 1 / 2.6;
    for (const double time : {0.3, 1.0, 7.0})
        EXPECT_LT(surface_traction(*made.solution, 2, 1.5, lambda, mu, time), 1e-9);
    EXPECT_GT(surface_traction(*made.solution, 2, 1.5, lambda, 1.01 * mu, 1.0), 1e-4);
}

TEST(FreeDiskVibration, TellsWhatItIsNoSolutionFor) {
    Made made("plane_strain", unit_rubber(0.3), disk(0.011, 1));
    EXPECT_TRUE(made.has_rule(false, "/amplitude"));
    EXPECT_FALSE(Made("plane_strain", unit_rubber(0.3), disk(0.011, 2)).has_rule(false, "/amplitude"));
    EXPECT_TRUE(Made("axisymmetric", unit_rubber(0.3), disk(1e-3, 1)).has_rule(true, ""));
    EXPECT_TRUE(
        Made("plane_strain", rubber("j2_plasticity", 1, 1, 0), disk(1e-3, 1)).has_rule(true, "/body"));
}

TEST(FreeBodies, MustBeWhereTheirSolutionIs) {
    const auto warned = [](Json own, const Json& geometry) {
        Made made("plane_strain", rubber("neo_hookean", 1, 1, 0.3), own);
        made.scene["bodies"]["body"]["geometry"] = geometry;
        return made.has_rule(false, "/body");
    };
    const auto at = [](double x, double radius) {
        return Json{{"type", "sphere"}, {"center", {x, 0}}, {"radius", radius}};
    };
    for (const Json& own : {disk(1e-3, 1), spin(0.01, 1)}) {
        EXPECT_FALSE(warned(own, at(0, 1)));
        EXPECT_TRUE(warned(own, at(0.1, 1)));
        EXPECT_TRUE(warned(own, at(0, 1.1)));
        EXPECT_FALSE(warned(own, {{"type", "csv"}}));
        Json moved = own;
        moved["center"] = {0.1, 0};
        EXPECT_FALSE(warned(moved, at(0.1, 1)));
    }
}

TEST(FreeSphereVibration, ConformsInEverySpaceAndMode) {
    for (const double amplitude : {1e-9, 1e-4})
        for (const double nu : {-0.3, 0.0, 0.45}) {
            SCOPED_TRACE(nu);
            const Json material = rubber("neo_hookean", 1200, 3e6, nu);
            for (const char* mode : {"radial", "torsional"})
                Made("solid", material,
                     sphere(mode, amplitude * 0.2, 0.2, {{"center", {1, -2, 3}}, {"drift", {1, 2, 3}}}))
                    .check(ball({1, -2, 3}, 0.2, 3, 0.02));
            Samples half = ball({0, -2, 0}, 0.2, 2, 0.02);
            half.min[0] = 1e-3;
            Made("axisymmetric", material,
                 sphere("radial", amplitude * 0.2, 0.2, {{"center", {0, -2}}, {"drift", {0, 3}}}))
                .check(half);
        }
}

/// kR / pi [Lamb 1882]: radial by Poisson's ratio, torsional of the second order; and their equations, with
/// the library's Bessel functions.
TEST(FreeSphereVibration, HasTextbookFrequencies) {
    const Vector equator(0, 1, 0), between(std::sqrt(0.5), 0, std::sqrt(0.5));
    const auto radial = [&](double nu) {
        return root({"solid", unit_rubber(nu), sphere("radial", 1e-3, 1)}, equator, 1e-3, 1);
    };
    EXPECT_NEAR(radial(0) / std::numbers::pi, 0.6626, 5e-5);
    EXPECT_NEAR(radial(0.25) / std::numbers::pi, 0.8160, 5e-5);
    for (const double nu : {-0.9, 0.1, 0.3, 0.49}) {
        const double x = radial(nu), ratio = (1 - 2 * nu) / (2 - 2 * nu);  // of squared speeds
        EXPECT_NEAR(std::sin(x) * (1 - x * x / (4 * ratio)), x * std::cos(x), 1e-12) << nu;
    }
    for (const double nu : {0.0, 0.3}) {
        const double shear_speed = std::sqrt((1 - 2 * nu) / (2 - 2 * nu));
        const double x =
            root({"solid", unit_rubber(nu), sphere("torsional", 1e-3, 1)}, between, 1e-3, shear_speed);
        EXPECT_NEAR(x / std::numbers::pi, 0.7961, 5e-5);
        EXPECT_NEAR(x * std::sph_bessel(1, x), 4 * std::sph_bessel(2, x), 1e-12);  // j_2' = j_1 - 3 j_2 / x
    }
}

TEST(FreeSphereVibration, HasAFreeSurface) {
    const double lambda = 0.3 / 1.3 / 0.4, mu = 1 / 2.6;
    for (const char* mode : {"radial", "torsional"}) {
        const Made made("solid", rubber("neo_hookean", 1, 1, 0.3), sphere(mode, 1e-3, 1.5));
        for (const double time : {0.3, 1.0, 7.0})
            EXPECT_LT(surface_traction(*made.solution, 3, 1.5, lambda, mu, time), 1e-9) << mode;
    }
    const Made larger("solid", rubber("neo_hookean", 1, 1, 0.3), sphere("torsional", 1e-3, 1.51));
    EXPECT_GT(surface_traction(*larger.solution, 3, 1.5, lambda, mu, 1.0), 1e-3);
}

TEST(FreeSphereVibration, TellsWhatItIsNoSolutionFor) {
    const auto refuses = [](const char* space, const Json& own, const char* pointer) {
        return Made(space, unit_rubber(0.3), own).has_rule(true, pointer);
    };
    EXPECT_TRUE(refuses("plane_strain", sphere("radial", 1e-3, 1), ""));
    EXPECT_FALSE(refuses("axisymmetric", sphere("radial", 1e-3, 1), ""));
    EXPECT_TRUE(refuses("axisymmetric", sphere("torsional", 1e-3, 1), "/mode"));
    EXPECT_TRUE(refuses("axisymmetric", sphere("radial", 1e-3, 1, {{"center", {0.1, 0}}}), "/center"));
    EXPECT_TRUE(refuses("axisymmetric", sphere("radial", 1e-3, 1, {{"drift", {0.1, 0}}}), "/drift"));
    EXPECT_FALSE(refuses("axisymmetric", sphere("radial", 1e-3, 1, {{"drift", {0, 0.1}}}), "/drift"));
}

/// What is left out is of the order of the strain, (w R / c)^2, times what is there: at 1e-3 next to nothing.
TEST(SpinningDisk, ConformsForOtherDisks) {
    for (const double rate : {1e-3, -0.03})
        for (const double nu : {-0.3, 0.0, 0.3, 0.45})
            for (const double radius : {0.5, 2.0}) {
                SCOPED_TRACE(nu);
                Json own = spin(rate / radius, radius), material = unit_rubber(nu);
                own["center"] = {3, 1};
                material["type"] = "neo_hookean";
                Made("plane_strain", material, own).check(ball({3, 1, 0}, radius, 2, 200));
            }
}

/// The closed form u = rho w^2 r [(3 - 2 nu) R^2 - r^2] / (8 (lambda + 2 mu)) at the rim, and a free rim, by
/// differences.
TEST(SpinningDisk, WidensByTheTextbook) {
    const double nu = 0.3, rate = 0.01;
    Json material = unit_rubber(nu);
    material["type"] = "neo_hookean";
    const Made made("plane_strain", material, spin(rate, 1));
    EXPECT_NEAR(made.solution->displacement({0.6, 0.8, 0}, 0).norm() / (rate * rate), (2 - 2 * nu) / 8, 1e-9);
    EXPECT_LT(surface_traction(*made.solution, 2, 1, nu / (1 - nu), (1 - 2 * nu) / (2 - 2 * nu), 0), 1e-7);
    EXPECT_GT(surface_traction(*made.solution, 2, 1, nu / (1 - nu), 0.3, 0), 1e-3);
    const double quarter = std::numbers::pi / 2 / rate;
    EXPECT_LT((made.solution->displacement({0.5, 0, 0}, quarter) - Vector(-0.5, 0.5, 0)).norm(), 1e-4);
}

TEST(SpinningDisk, TellsWhatItIsNoSolutionFor) {
    Json material = unit_rubber(0.3);
    EXPECT_TRUE(Made("plane_strain", material, spin(0.05, 1)).has_rule(true, "/body"));
    material["type"] = "neo_hookean";
    EXPECT_FALSE(Made("plane_strain", material, spin(0.05, 1)).has_rule(true, "/body"));
    EXPECT_TRUE(Made("plane_strain", material, spin(-0.11, 1)).has_rule(false, "/angular_velocity"));
    EXPECT_FALSE(Made("plane_strain", material, spin(-0.11, 0.9)).has_rule(false, "/angular_velocity"));
    EXPECT_TRUE(Made("axisymmetric", material, spin(0.05, 1)).has_rule(true, ""));
}

}  // namespace
}  // namespace matpoint::conformance
