// Surfaces of tools for pictures: against areas, volumes and corners.

#include "run/dual_contour.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace matpoint {
namespace {

using Vector = Eigen::Vector3d;

Lattice lattice(int dimension) {
    Lattice own{dimension, Vector::Zero(), 0.1, {1, 1, 1}};
    for (int a = 0; a < dimension; ++a) {
        own.min[a] = -1.03;
        own.nodes[static_cast<std::size_t>(a)] = 22;
    }
    return own;
}

Vector point(const SurfaceMesh& mesh, std::size_t cell, std::size_t corner) {
    const auto number = mesh.cells[cell * static_cast<std::size_t>(mesh.corners) + corner];
    return Eigen::Map<const Vector>(mesh.points.data() + 3 * number);
}

SignedDistance ball(const Vector& x) {
    return {x.norm() - 0.7, x.normalized()};
}

/// A cube of edge 1, turned about an axis.
SignedDistance cube(const Vector& x) {
    const Eigen::AngleAxisd turn(0.3, Vector(0.2, 0.3, 1).normalized());
    const Vector own = turn.inverse() * x, over = own.cwiseAbs() - Vector::Constant(0.5);
    Eigen::Index axis;
    const double most = over.maxCoeff(&axis);
    Vector normal = Vector::Zero();
    if (most > 0 && (over.array() > 0).count() > 1)
        normal = over.cwiseMax(0).cwiseProduct(own.cwiseSign()).normalized();
    else
        normal[axis] = own[axis] < 0 ? -1 : 1;
    return {most > 0 ? over.cwiseMax(0).norm() : most, turn * normal};
}

TEST(SurfaceContour, OfADiskIsAClosedLineOfItsLength) {
    const SurfaceMesh mesh = dual_contour(lattice(2), ball);
    ASSERT_EQ(mesh.corners, 2);
    std::map<std::int64_t, int> ends;
    for (const std::int64_t number : mesh.cells) ++ends[number];
    for (const auto& [number, count] : ends) EXPECT_EQ(count, 2) << number;
    double length = 0, area = 0;
    for (std::size_t k = 0; k < mesh.cells.size() / 2; ++k) {
        const Vector from = point(mesh, k, 0), to = point(mesh, k, 1);
        length += (to - from).norm();
        area += from.cross(to).z() / 2;
    }
    EXPECT_NEAR(length, 2 * std::numbers::pi * 0.7, 0.02);
    EXPECT_NEAR(area, std::numbers::pi * 0.49, 0.01);  // above 0: the disk is to the left
}

TEST(SurfaceContour, OfAWedgeHasItsTip) {
    const double half_angle = 68 * std::numbers::pi / 180;
    const Vector tip(0.012, -0.25, 0);
    const auto wedge = [&](const Vector& x) -> SignedDistance {
        const Vector normal(x[0] < tip[0] ? -std::cos(half_angle) : std::cos(half_angle),
                            -std::sin(half_angle), 0);
        return {normal.dot(x - tip), normal};
    };
    const SurfaceMesh mesh = dual_contour(lattice(2), wedge);
    double nearest = 1;
    for (std::size_t k = 0; k < mesh.points.size(); k += 3)
        nearest = std::min(nearest, (Eigen::Map<const Vector>(mesh.points.data() + k) - tip).norm());
    EXPECT_LT(nearest, 1e-9);
}

TEST(SurfaceContour, OfACubeHasItsVolumeAndArea) {
    const SurfaceMesh mesh = dual_contour(lattice(3), cube);
    ASSERT_EQ(mesh.corners, 4);
    double volume = 0, area = 0;
    for (std::size_t k = 0; k < mesh.cells.size() / 4; ++k)
        for (std::size_t c : {1U, 2U}) {
            const Vector a = point(mesh, k, 0), b = point(mesh, k, c), d = point(mesh, k, c + 1);
            volume += a.dot(b.cross(d)) / 6;  // above 0: normals point outwards
            area += (b - a).cross(d - a).norm() / 2;
        }
    EXPECT_NEAR(volume, 1, 2e-3);
    EXPECT_NEAR(area, 6, 0.03);
}

TEST(SurfaceContour, OfAHalfLineIsItsEnd) {
    const SurfaceMesh mesh = dual_contour(lattice(1), [](const Vector& x) {
        return SignedDistance{0.31 - x[0], -Vector::UnitX()};
    });
    ASSERT_EQ(mesh.points.size(), 3U);
    EXPECT_NEAR(mesh.points[0], 0.31, 1e-15);
    EXPECT_EQ(mesh.cells, std::vector<std::int64_t>{0});
}

TEST(SurfaceContour, OfNothingIsEmptyAndOpenAtTheLatticesEdge) {
    EXPECT_TRUE(dual_contour(lattice(3), [](const Vector&) {
                    return SignedDistance{1, Vector::UnitX()};
                }).points.empty());
    const SurfaceMesh mesh = dual_contour(lattice(3), [](const Vector& x) {
        return SignedDistance{x[2], Vector::UnitZ()};
    });
    EXPECT_EQ(mesh.cells.size(), 4U * 20 * 20);
    for (std::size_t k = 2; k < mesh.points.size(); k += 3) EXPECT_NEAR(mesh.points[k], 0, 1e-15);
}

}  // namespace
}  // namespace matpoint
