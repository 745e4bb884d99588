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
        light.locate(patch, inside, prescribed, false);
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
    double mass_at(int x, int y) const { return patch.column(NodeField::mass)[patch.node_index({x, y})]; }

    Patch<S> patch{{0, 0, 0}, {1, 1, 1}, {8, 8}};
    std::vector<char> inside;
    std::vector<unsigned char> prescribed;
    LightNodes<S> light{0.1, 1.0};
};

TEST_F(LightNodesTest, FullNodesKeepWhatTheyHave) {
    fill_mass(5);
    EXPECT_TRUE(light.empty());
}

TEST_F(LightNodesTest, LinearFieldsStayLinear) {
    fill_mass(5.2);
    ASSERT_FALSE(light.empty());
    const auto field = [](const Eigen::Vector2d& x) { return 3 + 2 * x[0] - 5 * x[1]; };
    set(NodeField::velocity, field);
    // What a light node has of its own is not read.
    patch.column(NodeField::velocity)[patch.node_index({6, 4})] = 1e9;
    patch.column(NodeField::velocity)[patch.node_index({6, 6})] = -1e9;
    light.fill(patch, NodeField::velocity);
    for (int x = 2; x <= 6; ++x)
        for (int y = 2; y <= 6; ++y)
            EXPECT_NEAR(patch.column(NodeField::velocity)[patch.node_index({x, y})], field({x, y}), 1e-12);
}

TEST_F(LightNodesTest, MassIsKeptAndNoNodeHasLessThanNothing) {
    for (const double edge : {5.001, 5.1, 5.2, 5.31, 5.33, 5.35, 5.4, 5.5}) {
        fill_mass(edge);
        const double before = sum(NodeField::mass);
        light.fold(patch, NodeField::mass);
        EXPECT_NEAR(sum(NodeField::mass), before, 1e-13);
        for (Index i = 0; i < patch.node_count(); ++i) EXPECT_GE(patch.column(NodeField::mass)[i], 0);
    }
    fill_mass(5.2);
    light.fold(patch, NodeField::mass);
    EXPECT_EQ(mass_at(6, 4), 0);
    fill_mass(5.33);  // partly its own
    const double own = mass_at(6, 4);
    light.fold(patch, NodeField::mass);
    EXPECT_GT(mass_at(6, 4), 0);
    EXPECT_LT(mass_at(6, 4), own);
}

TEST_F(LightNodesTest, FoldIsTheTransposeOfFill) {
    std::mt19937 numbers(1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const double edge : {5.1, 5.33}) {
        fill_mass(edge);
        set(NodeField::velocity, [&](const auto&) { return any(numbers); });
        set(NodeField::force, [&](const auto&) { return any(numbers); });
        const auto product = [&] {
            double total = 0;
            for (int c = 0; c < 2; ++c)
                for (Index i = 0; i < patch.node_count(); ++i)
                    total += patch.column(NodeField::velocity, c)[i] * patch.column(NodeField::force, c)[i];
            return total;
        };
        light.fill(patch, NodeField::velocity);
        const double read = product();
        light.restore(patch, NodeField::velocity);
        light.fold(patch, NodeField::force);
        EXPECT_NEAR(product(), read, 1e-12);
    }
}

TEST_F(LightNodesTest, ThoseOnAWallFollowOthersOnIt) {
    prescribed.clear();
    fill_mass(5.2);
    for (int x = 0; x <= 8; ++x) prescribed[static_cast<std::size_t>(patch.node_index({x, 4}))] = 2;  // v_y
    light.locate(patch, inside, prescribed, false);
    set(NodeField::velocity, [](const Eigen::Vector2d& x) { return x[1] == 4 ? 0 : 7; });
    light.fill(patch, NodeField::velocity);
    EXPECT_EQ(patch.column(NodeField::velocity, 1)[patch.node_index({6, 4})], 0);
    EXPECT_EQ(patch.column(NodeField::velocity, 1)[patch.node_index({6, 5})], 7);
}

}  // namespace
}  // namespace matpoint
