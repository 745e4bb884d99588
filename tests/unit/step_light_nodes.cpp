#include "step/light_nodes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace matpoint {
namespace {

/// A grid of 8 x 8 cells of 1 m whose nodes have the mass of a body from 2 to `edge` on both axes, density 1.
class LightNodesTest : public testing::Test {
  protected:
    using S = PlaneStrain;

    void fill_mass(double edge) {
        patch.set_blocks({0, 1, 2, 3});
        inside.assign(static_cast<std::size_t>(patch.node_count()), 0);
        prescribed.assign(inside.size(), 0);
        for (int i = 0; i < static_cast<int>(patch.node_count()); ++i) {
            const auto node = patch.node_coordinates(i);
            inside[static_cast<std::size_t>(i)] = patch.inside(node);
            patch.column(NodeField::mass)[i] = share(node[0], edge) * share(node[1], edge);
        }
        light.locate(layers, inside, prescribed, {}, false);
    }
    /// Integral of a tent over [2, edge].
    static double share(int node, double edge) {
        const auto below = [&](double x) {
            const double u = std::clamp(x - node, -1.0, 1.0);
            return u < 0 ? (1 + u) * (1 + u) / 2 : 1 - (1 - u) * (1 - u) / 2;
        };
        return below(edge) - below(2);
    }
    template <class Value>
    void set(NodeField field, const Value& value) {
        for (int i = 0; i < static_cast<int>(patch.node_count()); ++i)
            for (int c = 0; c < Patch<S>::components(field); ++c)
                patch.column(field, c)[i] = value(patch.node_position(patch.node_coordinates(i)));
    }
    double sum(NodeField field) const {
        double total = 0;
        for (Index i = 0; i < patch.node_count(); ++i) total += patch.column(field)[i];
        return total;
    }
    struct Motion {
        Eigen::Vector2d momentum{0, 0};
        double angular_momentum = 0, energy = 0;
    };
    Motion motion() const {
        Motion all;
        for (int i = 0; i < static_cast<int>(patch.node_count()); ++i) {
            const Eigen::Vector2d x = patch.node_position(patch.node_coordinates(i));
            const Eigen::Vector2d v(patch.column(NodeField::velocity, 0)[i],
                                    patch.column(NodeField::velocity, 1)[i]);
            const double m = patch.column(NodeField::mass)[i];
            all.momentum += m * v;
            all.angular_momentum += m * (x[0] * v[1] - x[1] * v[0]);
            all.energy += m * v.squaredNorm() / 2;
        }
        return all;
    }

    Patch<S> patch{{0, 0, 0}, {1, 1, 1}, {8, 8}};
    std::array<Patch<S>*, 1> layers{&patch};
    std::vector<char> inside;
    std::vector<unsigned char> prescribed;
    LightNodes<S> light{0.1, 1.0};
    std::mt19937 numbers{1};
    std::uniform_real_distribution<double> any{-1, 1};
};

TEST_F(LightNodesTest, FullNodesKeepWhatTheyHave) {
    fill_mass(5);
    EXPECT_TRUE(light.empty());
}

TEST_F(LightNodesTest, LinearFieldsStayLinear) {
    for (const double edge : {5.001, 5.2, 5.33}) {
        fill_mass(edge);
        ASSERT_FALSE(light.empty());
        const auto field = [](const Eigen::Vector2d& x) { return 3 + 2 * x[0] - 5 * x[1]; };
        set(NodeField::velocity, field);
        light.follow_velocity(patch, NodeField::velocity);
        for (int x = 2; x <= 6; ++x)
            for (int y = 2; y <= 6; ++y)
                EXPECT_NEAR(patch.column(NodeField::velocity)[patch.node_index({x, y})], field({x, y}),
                            1e-12);
    }
}

TEST_F(LightNodesTest, WhatIsLighterThanHalfTheShareHasNothingOfItsOwn) {
    fill_mass(5.2);
    const auto at = [&](int x, int y) -> double& {
        return patch.column(NodeField::velocity)[patch.node_index({x, y})];
    };
    set(NodeField::velocity, [](const Eigen::Vector2d& x) { return x[0]; });
    at(6, 3) = 1e3;
    light.follow_velocity(patch, NodeField::velocity);
    EXPECT_NEAR(at(6, 3), 2 * at(5, 3) - at(4, 3), 1e-10);
    fill_mass(5.33);  // partly its own
    set(NodeField::velocity, [](const Eigen::Vector2d& x) { return x[0]; });
    at(6, 3) = 1e3;
    light.follow_velocity(patch, NodeField::velocity);
    EXPECT_GT(at(6, 3), 1.1 * (2 * at(5, 3) - at(4, 3)));
    EXPECT_LT(at(6, 3), 1e3);
}

TEST_F(LightNodesTest, MomentaAreKeptAndEnergyIsNotAdded) {
    for (const double edge : {5.001, 5.1, 5.2, 5.31, 5.33, 5.35, 5.4}) {
        fill_mass(edge);
        set(NodeField::velocity, [&](const auto&) { return any(numbers); });
        const Motion before = motion();
        light.follow_velocity(patch, NodeField::velocity);
        const Motion after = motion();
        EXPECT_NEAR((after.momentum - before.momentum).norm(), 0, 1e-13);
        EXPECT_NEAR(after.angular_momentum, before.angular_momentum, 1e-12);
        EXPECT_LT(after.energy, before.energy);
    }
}

/// f . u = p . a, so that the work of forces is the energy that nodes get.
TEST_F(LightNodesTest, AccelerationsAreTheAdjointOfVelocities) {
    for (const double edge : {5.001, 5.1, 5.33}) {
        fill_mass(edge);
        set(NodeField::velocity, [&](const auto&) { return any(numbers); });
        set(NodeField::force, [&](const auto&) { return any(numbers); });
        double gained = 0, work = 0;
        const auto for_all = [&](const auto& visit) {
            for (int c = 0; c < 2; ++c)
                for (Index i = 0; i < patch.node_count(); ++i)
                    visit(patch.column(NodeField::mass)[i], patch.column(NodeField::velocity, c)[i],
                          patch.column(NodeField::force, c)[i], patch.column(NodeField::acceleration, c)[i]);
        };
        for_all([](double m, double& v, double& f, double& a) {
            if (m == 0) v = f = 0;
            a = m > 0 ? f / m : 0;
        });
        light.follow_acceleration(patch);
        for_all([&](double m, double v, double, double a) { gained += m * v * a; });
        light.follow_velocity(patch, NodeField::velocity);
        for_all([&](double, double v, double f, double) { work += f * v; });
        EXPECT_NEAR(gained, work, 1e-11);
    }
}

TEST_F(LightNodesTest, WallsTakeWhatTheyAreGiven) {
    fill_mass(5.2);
    // The edge's last full nodes don't move.
    for (int y = 0; y <= 8; ++y) prescribed[static_cast<std::size_t>(patch.node_index({5, y}))] = 3;
    light.locate(layers, inside, prescribed, {}, false);
    set(NodeField::velocity, [](const Eigen::Vector2d& x) { return x[0] == 5 ? 0 : 7; });
    const double before = motion().momentum[0];
    light.follow_velocity(patch, NodeField::velocity, 2);
    EXPECT_LT(motion().momentum[0], before);
    EXPECT_NEAR(motion().momentum[0] + sum(NodeField::force) / 2, before, 1e-12);
    EXPECT_EQ(patch.column(NodeField::velocity)[patch.node_index({5, 3})], 0);
    EXPECT_NEAR(patch.column(NodeField::velocity)[patch.node_index({6, 3})],
                -patch.column(NodeField::velocity)[patch.node_index({4, 3})], 1e-12);
}

TEST_F(LightNodesTest, ThoseOnAWallFollowOthersOnIt) {
    prescribed.clear();
    fill_mass(5.2);
    for (int x = 0; x <= 8; ++x) prescribed[static_cast<std::size_t>(patch.node_index({x, 4}))] = 2;  // v_y
    light.locate(layers, inside, prescribed, {}, false);
    set(NodeField::velocity, [](const Eigen::Vector2d& x) { return x[1] == 4 ? 0 : 7; });
    light.follow_velocity(patch, NodeField::velocity);
    EXPECT_EQ(patch.column(NodeField::velocity, 1)[patch.node_index({6, 4})], 0);
    EXPECT_NEAR(patch.column(NodeField::velocity, 1)[patch.node_index({6, 5})], 7, 1e-12);
}

/// Two bodies whose edges are a cell apart give a node between them mass of their own, and nothing to each
/// other.
TEST_F(LightNodesTest, NothingCrossesAGap) {
    fill_mass(5.001);
    for (int y = 0; y <= 8; ++y)
        for (int x = 7; x <= 8; ++x) patch.column(NodeField::mass)[patch.node_index({x, y})] = 1;
    light.locate(layers, inside, prescribed, {}, false);
    set(NodeField::velocity, [](const Eigen::Vector2d& x) { return x[0] >= 7 ? 1 : 0; });
    patch.column(NodeField::velocity)[patch.node_index({6, 3})] = 1e3;
    light.follow_velocity(patch, NodeField::velocity);
    EXPECT_EQ(patch.column(NodeField::velocity)[patch.node_index({7, 3})], 1);
    EXPECT_EQ(patch.column(NodeField::velocity)[patch.node_index({5, 3})], 0);
}

}  // namespace
}  // namespace matpoint
