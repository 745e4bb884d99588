#include "levels_fixture.hpp"

#include <cmath>

namespace matpoint {
namespace {

/// sum N = 1, sum N x_i = x, none negative, wherever particles may be.
TEST_P(ThreeLevels, KeepConstantsAndLinearFields) {
    for (int k = 0; k < 2000; ++k) {
        const Position x(along(numbers), along(numbers));
        double sum = 0;
        Position mean = Position::Zero();
        for (const auto& [node, weight] : weights(levels.at(x), x)) {
            EXPECT_GE(weight, 0);
            sum += weight;
            mean += weight * levels.patch(node.first).node_position(node.second);
        }
        EXPECT_NEAR(sum, 1, 1e-14);
        EXPECT_NEAR((mean - x).norm(), 0, 1e-13);
    }
}

/// Beside a border a particle may be of either level: what it reads is the same.
TEST_P(ThreeLevels, AgreeWhereTwoMayBe) {
    int found = 0;
    for (int k = 0; k < 20000; ++k) {
        const Position x(along(numbers), along(numbers));
        for (int level = 0; level + 1 < levels.count(); ++level) {
            if (!levels.may_be(level, x) || !levels.may_be(level + 1, x)) continue;
            ++found;
            auto coarse = weights(level, x), fine = weights(level + 1, x);
            for (const auto& [node, weight] : fine) EXPECT_NEAR(coarse[node], weight, 1e-14);
            for (const auto& [node, weight] : coarse) EXPECT_NEAR(fine[node], weight, 1e-14);
        }
    }
    EXPECT_GT(found, 500);
}

TEST_P(ThreeLevels, TellWhatIsLeftOfAFunction) {
    std::map<std::pair<int, Coordinates>, double> integrals;
    constexpr int places = 16;  // of a cell of the finest level, per axis
    const double h = levels.finest().cell_size()[0] / places;
    for (double x = 0.75 + h / 2; x < 2; x += h)
        for (double y = 0.75 + h / 2; y < 2; y += h)
            for (const auto& [node, weight] : weights(levels.at({x, y}), {x, y}))
                integrals[node] += weight * h * h / levels.patch(node.first).cell_size().prod();
    int less = 0;
    for (const auto& [node, integral] : integrals) {
        const Position at = levels.patch(node.first).node_position(node.second);
        if ((at.array() < 1.1).any() || (at.array() > 1.6).any()) continue;  // not all of it was added up
        const double left = levels.left_of(node.first, node.second);
        EXPECT_NEAR(integral, left, 2e-3);
        less += left < 0.99 ? 1 : 0;
    }
    EXPECT_GT(less, 5);
}

TEST_P(ThreeLevels, HaveAllParentsAmongNodesThatMove) {
    for (int level = 1; level < levels.count(); ++level)
        for (int x = 0; x <= levels.patch(level).cells()[0]; ++x)
            for (int y = 0; y <= levels.patch(level).cells()[1]; ++y) {
                const Coordinates node{x, y};
                if (levels.free(level, node) || !levels.reached(level, node)) continue;
                for (const auto& parent : levels.parents(level, node))
                    EXPECT_TRUE(levels.free(level - 1, parent.node));
            }
}

/// A particle that comes and goes across a border changes its level when it has gone on by half a cell at the
/// least.
TEST_P(ThreeLevels, DoNotFlicker) {
    for (int k = 0; k < 2000; ++k) {
        const Position x(along(numbers), along(numbers));
        const int level = levels.at(x);
        EXPECT_TRUE(levels.may_be(level, x));
        const Position beside = x + Position(along(numbers) - 2, along(numbers) - 2).normalized() *
                                        (0.49 * levels.patch(level).cell_size()[0]);
        EXPECT_TRUE(levels.may_be(level, beside));
        if (levels.may_all_be(level, x.cwiseMin(beside), x.cwiseMax(beside))) {
            EXPECT_TRUE(levels.may_be(level, (x + beside) / 2));
        }
    }
}

TEST_P(ThreeLevels, NumberTheirBlocks) {
    for (int level = 0; level < levels.count(); ++level)
        for (const int block : {0, levels.patch(level).block_count() - 1}) {
            const int number = levels.number_of(level, block);
            EXPECT_EQ(levels.level_of(number), level);
            EXPECT_EQ(levels.block_of(number), block);
        }
}

INSTANTIATE_TEST_SUITE_P(Splines, ThreeLevels, testing::Values(1, 2, 3));

std::string mistake_of(const Boxes& region, int degree) {
    Patch<PlaneStrain> patch({0, 0, 0}, {0.125, 0.125, 0.125}, {32, 32});
    try {
        const Levels<PlaneStrain> levels(patch, {&region}, refinements.at(degree));
    } catch (const std::invalid_argument& mistake) {
        return mistake.what();
    }
    return "";
}

TEST(LevelRegions, MustHoldANode) {
    const Boxes one_cell({{{1, 1, 0}, {1.125, 1.125, 0}}}), four({{{1, 1, 0}, {1.25, 1.25, 0}}}),
        outside({{{5, 5, 0}, {6, 6, 0}}});
    EXPECT_EQ(mistake_of(one_cell, 1), "");
    EXPECT_NE(mistake_of(one_cell, 2).find("must hold 2 cells of level 0"), std::string::npos);
    EXPECT_NE(mistake_of(one_cell, 3).find("must hold 2 cells of level 0"), std::string::npos);
    EXPECT_EQ(mistake_of(four, 2), "");
    EXPECT_EQ(mistake_of(four, 3), "");
    EXPECT_NE(mistake_of(outside, 1).find("no cell of the grid"), std::string::npos);
}

TEST(LevelRegions, CountTheirCells) {
    const Boxes region({{{1, 1, 0}, {2, 1.5, 0}}});
    Patch<PlaneStrain> patch({0, 0, 0}, {0.125, 0.125, 0.125}, {32, 32});
    Levels<PlaneStrain> levels(patch, {&region}, refinements.at(1));
    EXPECT_EQ(levels.cells(0), 32 * 32 - 8 * 4);
    EXPECT_EQ(levels.cells(1), 4 * 8 * 4);
    EXPECT_EQ(levels.cells_with_border(1), 4 * 10 * 6);

    // It moves, and leaves the grid.
    const Eigen::Vector3d aside(2.5, 0, 0), away(9, 0, 0);
    levels.move({&aside, 1});
    EXPECT_EQ(levels.cells(1), 4 * 4 * 4);
    EXPECT_EQ(levels.at({3.9, 1.2}), 1);
    EXPECT_EQ(levels.at({1.5, 1.2}), 0);
    levels.move({&away, 1});
    EXPECT_EQ(levels.cells(1), 0);
    EXPECT_EQ(levels.at({3.9, 1.2}), 0);
}

}  // namespace
}  // namespace matpoint
