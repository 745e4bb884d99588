// Equally spaced particles in a box.

#include "geometry_fixture.hpp"

#include <cmath>
#include <numbers>

namespace matpoint {

class GeometryLattice : public GeometryTest {
  protected:
    static double volume(const Geometry& geometry) {
        double sum = 0;
        for (const PointCloud::Point& point : listed(geometry)) sum += point.volume;
        return sum;
    }
};

TEST_F(GeometryLattice, FillsABar) {
    const auto bar = make({{"type", "lattice"}, {"min", {-1}}, {"max", {1}}, {"counts", {5}}}, 1);
    ASSERT_NE(bar->points(), nullptr);
    const auto points = listed(*bar);
    ASSERT_EQ(points.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(points[k].position[0], -0.8 + 0.4 * static_cast<double>(k), 1e-15);
        EXPECT_NEAR(points[k].volume, 0.4, 1e-15);
        ASSERT_TRUE(points[k].half_size);
        EXPECT_NEAR((*points[k].half_size)[0], 0.2, 1e-15);
        EXPECT_EQ(points[k].velocity, Eigen::Vector3d::Zero());
    }
    EXPECT_EQ(bar->bounds().min[0], -1);
    EXPECT_EQ(bar->bounds().max[0], 1);
}

TEST_F(GeometryLattice, DomainsTileTheBox) {
    const auto brick =
        make({{"type", "lattice"}, {"min", {0, 1, 2}}, {"max", {1, 4, 2.5}}, {"counts", {4, 3, 1}}}, 3);
    const auto points = listed(*brick);
    ASSERT_EQ(points.size(), 12U);
    for (const PointCloud::Point& point : points) {
        EXPECT_NEAR((*point.half_size - Eigen::Vector3d(0.125, 0.5, 0.25)).norm(), 0, 1e-15);
        EXPECT_NEAR(8 * point.half_size->prod(), point.volume, 1e-15);
    }
    EXPECT_NEAR((points[5].position - Eigen::Vector3d(0.375, 2.5, 2.25)).norm(), 0, 1e-15);
    EXPECT_NEAR(volume(*brick), 1.5, 1e-14);
}

TEST_F(GeometryLattice, RingsAreWhole) {
    ASSERT_NE(catalogue.find("geometry", "lattice"), nullptr);
    const Json own = {
        {"type", "lattice"}, {"min", {0.5, 0}}, {"max", {2, 3}}, {"counts", {7, 2}}, {"jitter", 0}};
    const auto tube = catalogue.registry().make<Geometry>(
        "geometry", own, {{Mode::axisymmetric, false}, folder, &catalogue.registry(), nullptr});
    EXPECT_NEAR(volume(*tube), std::numbers::pi * (2 * 2 - 0.5 * 0.5) * 3, 1e-12);
}

TEST_F(GeometryLattice, JitterIsUniformBoundedAndRepeatable) {
    const Json own = {{"type", "lattice"}, {"min", {0, 0, 0}}, {"max", {1, 2, 4}}, {"counts", {20, 20, 20}}};
    Json shaken = own;
    shaken["jitter"] = 0.25;
    const auto places = listed(*make(own, 3)), once = listed(*make(shaken, 3)),
               twice = listed(*make(shaken, 3));
    const Eigen::Vector3d spacing(0.05, 0.1, 0.2);
    const std::size_t count = 8000;
    ASSERT_EQ(once.size(), count);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < count; ++k) {
        const PointCloud::Point& point = once[k];
        const Eigen::Vector3d shift = (point.position - places[k].position).cwiseQuotient(spacing);
        ASSERT_LE(shift.cwiseAbs().maxCoeff(), 0.25 + 1e-12);
        EXPECT_EQ(point.position, twice[k].position);
        EXPECT_EQ(point.volume, places[k].volume);
        mean += shift / static_cast<double>(count);
        moment += shift * shift.transpose() / static_cast<double>(count);
    }
    // Variance of the uniform distribution, independent axes; five standard errors of 8000 samples.
    EXPECT_NEAR(mean.cwiseAbs().maxCoeff(), 0, 5 * 0.25 / std::sqrt(3.0 * 8000));
    EXPECT_NEAR((moment - Eigen::Matrix3d::Identity() * 0.25 * 0.25 / 3).cwiseAbs().maxCoeff(), 0, 1.5e-3);
}

TEST_F(GeometryLattice, RefusesWhatIsNoLattice) {
    const Json square = {{"type", "lattice"}, {"min", {0, 0}}, {"max", {1, 1}}, {"counts", {2, 3}}};
    EXPECT_EQ(refused(square), "");
    Json flat = square, half = square, huge = square;
    flat["max"] = {1, 0};
    half["counts"] = {2, 2.5};
    huge["counts"] = {1e5, 1e5};
    EXPECT_EQ(refused(flat), "/max");
    EXPECT_EQ(refused(half), "/counts");
    EXPECT_EQ(refused(huge), "/counts");
}

}  // namespace matpoint
