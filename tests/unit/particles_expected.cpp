// How many particles a body gets, told before they are made.

#include "particles/expected_count.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace matpoint {
namespace {

class Ball final : public Geometry {
  public:
    Bounds bounds() const override {
        return {Eigen::Vector3d::Constant(-radius), Eigen::Vector3d::Constant(radius)};
    }
    bool contains(const Eigen::Vector3d& point) const override { return point.norm() <= radius; }
    static constexpr double radius = 1;
};

class Everywhere final : public Geometry {
  public:
    Bounds bounds() const override {
        return {Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity()),
                Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity())};
    }
    bool contains(const Eigen::Vector3d&) const override { return true; }
};

TEST(ExpectedParticles, OfABallInEveryDimension) {
    const auto expect = [](auto patch, double measure, double cell_measure) {
        const double count = expected_particles(patch, Ball(), {2, 3, 4});
        EXPECT_NEAR(count * cell_measure / measure, 1, 0.02);
    };
    expect(Patch<Bar>({-2, 0, 0}, {0.1, 0, 0}, {40}), 2, 0.1 / 2);
    expect(Patch<PlaneStrain>({-2, -2, 0}, {0.1, 0.2, 0}, {40, 20}), std::numbers::pi, 0.1 * 0.2 / 6);
    expect(Patch<Solid>({-2, -2, -2}, {0.1, 0.2, 0.4}, {40, 20, 10}), 4 * std::numbers::pi / 3,
           0.1 * 0.2 * 0.4 / 24);
}

TEST(ExpectedParticles, OnlyOnTheGrid) {
    const Patch<PlaneStrain> patch({0, 0, 0}, {0.1, 0.1, 0}, {20, 10});
    EXPECT_NEAR(most_particles(patch, Everywhere(), {2, 2, 1}), 800, 1e-9);
    EXPECT_NEAR(expected_particles(patch, Everywhere(), {2, 2, 1}), 800, 1e-9);
    EXPECT_NEAR(expected_particles(patch, Ball(), {1, 1, 1}), std::numbers::pi / 4 * 100, 1);
    const Patch<PlaneStrain> far({5, 5, 0}, {0.1, 0.1, 0}, {20, 10});
    EXPECT_EQ(expected_particles(far, Ball(), {2, 2, 1}), 0);
}

}  // namespace
}  // namespace matpoint
