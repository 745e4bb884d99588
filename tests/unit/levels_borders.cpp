#include "step/level_borders.hpp"

#include "levels_fixture.hpp"

#include <numeric>

namespace matpoint {
namespace {

class Borders : public ThreeLevels {
  protected:
    Borders() {
        std::vector<std::vector<int>> blocks(3);
        for (int level = 0; level < 3; ++level) {
            layers.push_back(&levels.patch(level));
            // All around the regions; parents are elsewhere too.
            for (int number = 0; number < levels.patch(level).block_count(); ++number) {
                const auto block = levels.patch(level).block_coordinates(number);
                const double edge = 8 * levels.patch(level).cell_size()[0];
                const double x = (block[0] + 0.5) * edge, y = (block[1] + 0.5) * edge;
                if (level > 0 && x > 0.7 && x < 2.8 && y > 0.7 && y < 3.3)
                    blocks[static_cast<std::size_t>(level)].push_back(number);
            }
        }
        LevelBorders<S>::add_parents(levels, blocks);
        patch.set_blocks(layers, blocks);
        borders.locate(levels, layers);
        for (const NodeField field : {NodeField::mass, NodeField::velocity})
            for (int c = 0; c < Patch<S>::components(field); ++c)
                for (Index i = 0; i < patch.node_count(); ++i) patch.column(field, c)[i] = along(numbers);
    }
    std::vector<double> column(NodeField field) {
        const double* begin = patch.column(field);
        return {begin, begin + patch.node_count()};
    }
    static double product(const std::vector<double>& a, const std::vector<double>& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    }
    std::vector<Patch<S>*> layers;
    LevelBorders<S> borders;
};

TEST_P(Borders, FoldIsTheTransposeOfFill) {
    const std::vector<double> written = column(NodeField::mass);
    for (const int level : {1, 2}) borders.fill(patch, NodeField::velocity, level);
    for (const int level : {2, 1}) borders.fold(patch, NodeField::mass, level);
    const std::vector<double> read = column(NodeField::velocity), folded = column(NodeField::mass);
    EXPECT_NEAR(product(folded, read) / product(written, read), 1, 1e-14);
    EXPECT_NEAR(std::accumulate(folded.begin(), folded.end(), 0.0) /
                    std::accumulate(written.begin(), written.end(), 0.0),
                1, 1e-14);
    int followers = 0;
    for (std::size_t i = 0; i < folded.size(); ++i) {
        if (borders.followers()[i] == 0) continue;
        ++followers;
        EXPECT_EQ(folded[i], 0);
        EXPECT_FALSE(borders.parents(static_cast<int>(i)).empty());
    }
    EXPECT_GT(followers, 100);
}

TEST_P(Borders, LinearFieldsStayLinear) {
    const auto field = [](const Position& x) { return 3 + 2 * x[0] - 5 * x[1]; };
    for (int i = 0; i < static_cast<int>(patch.node_count()); ++i)
        if (borders.followers()[static_cast<std::size_t>(i)] == 0)
            patch.column(NodeField::velocity)[i] = field(patch.position_at(i));
    for (const int level : {1, 2}) borders.fill(patch, NodeField::velocity, level);
    for (int i = 0; i < static_cast<int>(patch.node_count()); ++i)
        if (borders.followers()[static_cast<std::size_t>(i)] != 0) {
            EXPECT_NEAR(patch.column(NodeField::velocity)[i], field(patch.position_at(i)), 1e-12);
        }
}

INSTANTIATE_TEST_SUITE_P(Splines, Borders, testing::Values(1, 2, 3));

}  // namespace
}  // namespace matpoint
