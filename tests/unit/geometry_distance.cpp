// Signed distances and their gradients, against what contains() says of balls around points and of the two
// sides of the nearest place of the surface.

#include "geometry_fixture.hpp"

#include <numbers>
#include <random>

namespace matpoint {

class GeometryDistance : public GeometryTest {
  protected:
    using Vector = Eigen::Vector3d;

    Vector anywhere(int dimension, double low = -0.5, double high = 1.5) {
        std::uniform_real_distribution<double> coordinate(low, high);
        Vector x = Vector::Zero();
        for (int a = 0; a < dimension; ++a) x[a] = coordinate(random_);
        return x;
    }
    Vector direction(int dimension) {
        Vector x;
        do x = anywhere(dimension, -1, 1);
        while (x.norm() > 1 || x.norm() < 0.1);
        return x.normalized();
    }

    /// Whether there is inside and outside close to a place, within a corner's narrow angle too.
    bool is_on_surface(const Geometry& geometry, const Vector& place, int dimension) {
        bool inside = false, outside = false;
        for (int k = 0; k < 2000 && !(inside && outside); ++k)
            (geometry.contains(place + 1e-6 * direction(dimension)) ? inside : outside) = true;
        return inside && outside;
    }

    /// Whether the distance is that to the nearest place of the surface (`exact`), or at least no greater.
    void check(const Geometry& geometry, int dimension, bool exact = true, int points = 2000) {
        constexpr double small = 1e-6;
        int inside = 0, smooth = 0;
        for (int k = 0; k < points; ++k) {
            const Vector x = anywhere(dimension);
            const auto [distance, normal] = geometry.signed_distance(x);
            const std::string at = "at " + std::to_string(x[0]) + " " + std::to_string(x[1]) + " " +
                                   std::to_string(x[2]) + ", distance " + std::to_string(distance);
            EXPECT_NEAR(normal.norm(), 1, 1e-12) << at;
            for (int a = dimension; a < 3; ++a) EXPECT_EQ(normal[a], 0) << at;
            if (std::abs(distance) < 10 * small) continue;
            EXPECT_EQ(geometry.contains(x), distance < 0) << at;
            inside += distance < 0;
            for (int i = 0; i < 20; ++i) {
                const Vector y = x + (std::abs(distance) - small) * direction(dimension);
                EXPECT_EQ(geometry.contains(y), distance < 0) << at;
            }
            if (exact) {
                EXPECT_TRUE(is_on_surface(geometry, x - distance * normal, dimension)) << at;
            }
            // Where it has one gradient, that is the normal.
            Vector slope = Vector::Zero();
            bool jumps = false;
            for (int a = 0; a < dimension; ++a) {
                const SignedDistance after = geometry.signed_distance(x + small * Vector::Unit(a)),
                                     before = geometry.signed_distance(x - small * Vector::Unit(a));
                slope[a] = (after.distance - before.distance) / (2 * small);
                jumps = jumps || (after.normal - before.normal).norm() > 1e-3;
            }
            if (jumps) continue;
            ++smooth;
            EXPECT_NEAR((slope - normal).norm(), 0, 1e-3) << at;
        }
        EXPECT_GT(inside, points / 100);
        EXPECT_LT(inside, points);
        EXPECT_GT(smooth, points / 2);
    }

    std::mt19937 random_{1};
};

TEST_F(GeometryDistance, BoxAndSphereInEveryDimension) {
    for (int dimension = 1; dimension <= 3; ++dimension) {
        const auto d = static_cast<std::size_t>(dimension);
        const std::vector<double> low{0.1, -0.2, 0.3}, high{0.9, 0.4, 1.4}, center{0.4, 0.6, 0.5};
        const auto first = [d](std::vector<double> of) {
            of.resize(d);
            return of;
        };
        check(*make({{"type", "box"}, {"min", first(low)}, {"max", first(high)}}, dimension), dimension);
        check(*make({{"type", "sphere"}, {"center", first(center)}, {"radius", 0.4}}, dimension), dimension);
    }
}

TEST_F(GeometryDistance, CylinderAndTube) {
    for (const double inner : {0.0, 0.2})
        check(*make({{"type", "cylinder"},
                     {"start", {0.1, 0.2, 0.3}},
                     {"end", {0.8, 0.6, 0.9}},
                     {"radius", 0.5},
                     {"inner_radius", inner}}),
              3);
}

TEST_F(GeometryDistance, PolygonEitherWayAround) {
    Json vertices = {{0.1, 0.1}, {0.9, 0.2}, {0.8, 0.9}, {0.5, 0.3}, {0.2, 1.1}, {0.2, 0.4}};
    check(*make({{"type", "polygon"}, {"vertices", vertices}}, 2), 2);
    std::reverse(vertices.begin(), vertices.end());
    check(*make({{"type", "polygon"}, {"vertices", vertices}}, 2), 2);
}

TEST_F(GeometryDistance, ExtrusionAlongEveryAxis) {
    for (const char* axis : {"x", "y", "z"})
        check(*make({{"type", "extrusion"},
                     {"vertices", {{0.1, 0.1}, {0.9, 0.2}, {0.8, 0.9}, {0.5, 0.3}, {0.2, 0.9}}},
                     {"axis", axis},
                     {"from", 0.2},
                     {"to", 0.7}}),
              3);
}

TEST_F(GeometryDistance, UnboundedOnes) {
    for (int dimension = 1; dimension <= 3; ++dimension) {
        std::vector<double> point{0.4, 0.3, 0.2}, normal{-1, 2, 0.5};
        point.resize(static_cast<std::size_t>(dimension));
        normal.resize(static_cast<std::size_t>(dimension));
        check(*make({{"type", "half_space"}, {"point", point}, {"normal", normal}}, dimension), dimension);
    }
    for (const double angle : {20.0, 68.0}) {
        check(
            *make({{"type", "wedge"}, {"tip", {0.4, 0.3}}, {"half_angle", angle}, {"direction", {1, 3}}}, 2),
            2);
        check(*make({{"type", "wedge"},
                     {"tip", {0.4, 0.3, 0.5}},
                     {"half_angle", angle},
                     {"direction", {0, 1, 2}},
                     {"edge", {1, 2, -1}}}),
              3);
        check(*make({{"type", "cone"},
                     {"tip", {0.4, 0.3, 0.5}},
                     {"half_angle", angle},
                     {"direction", {1, 1, -2}}}),
              3);
    }
}

// By the angle under which a point is seen from the tip.
TEST_F(GeometryDistance, HalfAngleIsThatFromTheAxis) {
    const auto wedge =
        make({{"type", "wedge"}, {"tip", {0.4, 0.3}}, {"half_angle", 68}, {"direction", {0, 2}}}, 2);
    const auto cone =
        make({{"type", "cone"}, {"tip", {0.4, 0.3, 0.1}}, {"half_angle", 68}, {"direction", {0, 2, 0}}});
    for (int k = 0; k < 1000; ++k) {
        const auto seen = [](const Vector& from_tip) {
            return std::acos(from_tip[1] / from_tip.norm()) * 180 / std::numbers::pi;
        };
        const Vector in_plane = anywhere(2), in_space = anywhere(3);
        EXPECT_EQ(wedge->contains(in_plane), seen(in_plane - Vector(0.4, 0.3, 0)) < 68);
        EXPECT_EQ(cone->contains(in_space), seen(in_space - Vector(0.4, 0.3, 0.1)) < 68);
    }
}

TEST_F(GeometryDistance, UnboundedOnesRefuseWhatHasNoDirection) {
    EXPECT_EQ(refused({{"type", "half_space"}, {"point", {0, 0}}, {"normal", {0, 0}}}), "/normal");
    EXPECT_EQ(refused({{"type", "half_space"}, {"point", {0, 0}}, {"normal", {0, -1}}}), "");
    EXPECT_EQ(refused({{"type", "cone"}, {"tip", {0, 0, 0}}, {"half_angle", 45}, {"direction", {0, 0, 0}}}),
              "/direction");
    EXPECT_SAYS(error_of({{"type", "wedge"},
                          {"tip", {0, 0, 0}},
                          {"half_angle", 45},
                          {"direction", {0, 1, 0}},
                          {"edge", {0, 1, 1}}}),
                "at right angles");
}

TEST_F(GeometryDistance, BooleansBoundIt) {
    const Json disk = {{"type", "sphere"}, {"center", {0.4, 0.5}}, {"radius", 0.3}};
    const Json square = {{"type", "box"}, {"min", {0.5, 0.3}}, {"max", {1.0, 0.8}}};
    for (const char* type : {"union", "intersection", "difference"})
        check(*make({{"type", type}, {"of", {disk, square}}}, 2), 2, false);
    // Outside of a union, and inside of an intersection, it is exact.
    const auto both = make({{"type", "union"}, {"of", {disk, square}}}, 2);
    EXPECT_DOUBLE_EQ(both->signed_distance({1.4, 1.1, 0}).distance, 0.5);
    const auto lens = make({{"type", "intersection"}, {"of", {disk, square}}}, 2);
    EXPECT_DOUBLE_EQ(lens->signed_distance({0.6, 0.5, 0}).distance, -0.1);
    // In what was cut out, the surface is the cutter's, and points into it.
    const SignedDistance cut =
        make({{"type", "difference"}, {"of", {square, disk}}}, 2)->signed_distance({0.6, 0.5, 0});
    EXPECT_DOUBLE_EQ(cut.distance, 0.1);
    EXPECT_TRUE(cut.normal.isApprox(Vector(-1, 0, 0)));
}

TEST_F(GeometryDistance, SinglePointsHaveNone) {
    write("points.csv", "x, y, volume\n0, 0, 1\n");
    const auto points = make({{"type", "points"}, {"file", "points.csv"}}, 2);
    EXPECT_THROW(points->signed_distance({0, 0, 0}), std::invalid_argument);
    const auto lattice = make({{"type", "lattice"}, {"min", {0, 0}}, {"max", {1, 1}}, {"counts", {2, 2}}}, 2);
    EXPECT_THROW(lattice->signed_distance({0, 0, 0}), std::invalid_argument);
}

}  // namespace matpoint
