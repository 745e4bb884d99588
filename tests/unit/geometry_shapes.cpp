// Box, sphere and cylinder: their volumes, faces and refusals.

#include "geometry_fixture.hpp"

#include <numbers>

namespace matpoint {

using std::numbers::pi;
using GeometryShapes = GeometryTest;

TEST_F(GeometryShapes, BoxHasItsVolumeExactly) {
    EXPECT_DOUBLE_EQ(measured_volume(*make({{"type", "box"}, {"min", {0.5}}, {"max", {2.0}}}, 1), 0.125, 1),
                     1.5);
    EXPECT_DOUBLE_EQ(
        measured_volume(*make({{"type", "box"}, {"min", {0, 1}}, {"max", {2, 1.5}}}, 2), 0.125, 2), 1.0);
    EXPECT_DOUBLE_EQ(
        measured_volume(*make({{"type", "box"}, {"min", {0, 0, -1}}, {"max", {1, 2, 1}}}), 0.125, 3), 4.0);
}

TEST_F(GeometryShapes, BoxesThatShareAFaceShareNoPoint) {
    const auto left = make({{"type", "box"}, {"min", {0, 0}}, {"max", {1, 1}}}, 2);
    const auto right = make({{"type", "box"}, {"min", {1, 0}}, {"max", {2, 1}}}, 2);
    const Eigen::Vector3d shared(1, 0.5, 0);
    EXPECT_FALSE(left->contains(shared));
    EXPECT_TRUE(right->contains(shared));
}

TEST_F(GeometryShapes, BoxRefusesCornersInTheWrongOrder) {
    EXPECT_EQ(refused({{"type", "box"}, {"min", {0, 0}}, {"max", {1, 1}}}), "");
    EXPECT_EQ(refused({{"type", "box"}, {"min", {0, 2}}, {"max", {1, 1}}}), "/max");
    EXPECT_EQ(refused({{"type", "box"}, {"min", {0, 1}}, {"max", {1, 1}}}), "/max");
}

// Only cells that the surface cuts can be counted wrongly: the error is below surface * h.
TEST_F(GeometryShapes, SphereConvergesAtFirstOrder) {
    const double radius = 0.7;
    const double volumes[] = {2 * radius, pi * radius * radius, 4 * pi / 3 * std::pow(radius, 3)};
    const double surfaces[] = {2, 2 * pi * radius, 4 * pi * radius * radius};
    for (int dimension = 1; dimension <= 3; ++dimension) {
        std::vector<double> center(static_cast<std::size_t>(dimension), 0.31);
        const auto sphere = make({{"type", "sphere"}, {"center", center}, {"radius", radius}}, dimension);
        for (const double h : {0.1, 0.05, 0.025})
            EXPECT_NEAR(measured_volume(*sphere, h, dimension), volumes[dimension - 1],
                        0.5 * surfaces[dimension - 1] * h)
                << dimension << "D, h = " << h;
    }
}

TEST_F(GeometryShapes, ObliqueTubeConvergesAtFirstOrder) {
    const double outer = 0.5, inner = 0.3, length = 3;  // end - start = (1, 2, 2)
    const auto tube = make({{"type", "cylinder"},
                            {"start", {0, 0, 0}},
                            {"end", {1, 2, 2}},
                            {"radius", outer},
                            {"inner_radius", inner}});
    const double volume = pi * (outer * outer - inner * inner) * length;
    const double surface = 2 * pi * (outer + inner) * length;
    for (const double h : {0.1, 0.05, 0.025})
        EXPECT_NEAR(measured_volume(*tube, h, 3), volume, 0.25 * surface * h) << "h = " << h;
}

TEST_F(GeometryShapes, CylinderHasTightBounds) {
    const auto cylinder =
        make({{"type", "cylinder"}, {"start", {0, 0, 1}}, {"end", {0, 0, 5}}, {"radius", 2}});
    EXPECT_TRUE(cylinder->bounds().min.isApprox(Eigen::Vector3d(-2, -2, 1)));
    EXPECT_TRUE(cylinder->bounds().max.isApprox(Eigen::Vector3d(2, 2, 5)));
}

TEST_F(GeometryShapes, CylinderRefusesNoLengthAndAWideBore) {
    EXPECT_EQ(refused({{"type", "cylinder"}, {"start", {1, 1, 1}}, {"end", {1, 1, 1}}, {"radius", 1}}),
              "/end");
    EXPECT_EQ(refused({{"type", "cylinder"},
                       {"start", {0, 0, 0}},
                       {"end", {1, 1, 1}},
                       {"radius", 1},
                       {"inner_radius", 1}}),
              "/inner_radius");
}

}  // namespace matpoint
