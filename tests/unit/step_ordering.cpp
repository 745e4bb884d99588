#include "step/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace matpoint {
namespace {

using S = PlaneStrain;

/// A particle reaches the corners of its cell.
class Corners final : public ShapeFunction<S> {
  public:
    void declare(Particles<S>&) const override {}
    int width() const override { return 2; }
    void base_nodes(const Patch<S>&, const Particles<S>& particles, Index begin, Index end,
                    Coordinates* out) const override {
        for (Index p = begin; p < end; ++p) {
            const Vector x = particles.position(p);
            *out++ = {static_cast<int>(x[0]), static_cast<int>(x[1])};
        }
    }
    Coordinates base_node(const Patch<S>&, const Particles<S>&, const Vector& x) const override {
        return {static_cast<int>(x[0]), static_cast<int>(x[1])};
    }
    void scatter(Patch<S>&, const Particles<S>&, Index, Index, const Scatter&) const override {}
    void gather(const Patch<S>&, const Particles<S>&, Index, Index, const Gather&,
                GatherSink<S>&) const override {}
    void spread(Patch<S>&, std::span<const PointSource<S>>, NodeField) const override {}
    Stencil stencil(const Patch<S>&, const Vector&, const Vector&) const override { return {}; }
};

TEST(ordering, forgets_the_colours_of_a_body_with_its_ranges) {
    Patch<S> patch({0, 0, 0}, {1, 1, 1}, {32, 32});
    std::vector<Particles<S>> bodies;
    bodies.emplace_back("block");
    bodies[0].resize(1);
    bodies[0].column(Field::position, 0)[0] = bodies[0].column(Field::position, 1)[0] = 3.5;
    Ordering<S> ordering(1);
    ASSERT_TRUE(ordering.update(patch, bodies, Corners()));
    ASSERT_EQ(ordering.ranges(0).size(), 1U);

    // The last particle leaves the grid: nothing may point into the ranges any more.
    bodies[0].permute({});
    ordering.forget(0);
    ordering.update(patch, bodies, Corners());
    EXPECT_TRUE(ordering.ranges(0).empty());
    for (const auto& colour : ordering.colours(0)) EXPECT_TRUE(colour.empty());
}

TEST(ordering, takes_the_grids_blocks_only_when_it_sorts) {
    Patch<S> patch({0, 0, 0}, {1, 1, 1}, {32, 32});
    std::vector<Particles<S>> bodies;
    bodies.emplace_back("block");
    bodies[0].resize(1);
    bodies[0].column(Field::position, 0)[0] = bodies[0].column(Field::position, 1)[0] = 3.5;
    Ordering<S> ordering(1);
    patch.set_blocks({0, 7});
    ASSERT_TRUE(ordering.update(patch, bodies, Corners()));
    EXPECT_EQ(patch.node_count(), 0);

    patch.set_blocks({0, 7});
    bodies[0].column(Field::position, 0)[0] += 1;
    ASSERT_FALSE(ordering.update(patch, bodies, Corners()));
    EXPECT_EQ(patch.existing_blocks(), std::vector({0, 7}));
}

/// 64 particles of one block, numbered by their masses, in the cells given by x.
std::vector<double> order_after_moving(const std::vector<double>& x) {
    Patch<S> patch({0, 0, 0}, {1, 1, 1}, {32, 32});
    std::vector<Particles<S>> bodies;
    bodies.emplace_back("block");
    const auto count = static_cast<Index>(x.size());
    bodies[0].resize(count);
    for (Index p = 0; p < count; ++p) {
        bodies[0].column(Field::position, 0)[p] = bodies[0].column(Field::position, 1)[p] = 3.5;
        bodies[0].column(Field::mass)[p] = static_cast<double>(p);
    }
    Ordering<S> ordering(1);
    EXPECT_TRUE(ordering.update(patch, bodies, Corners()));
    std::copy(x.begin(), x.end(), bodies[0].column(Field::position, 0));
    EXPECT_FALSE(ordering.update(patch, bodies, Corners()));
    for (Index p = 0; p < count; ++p)
        EXPECT_EQ(bodies[0].column(Field::position, 0)[p],
                  x[static_cast<std::size_t>(bodies[0].column(Field::mass)[p])]);
    return {bodies[0].column(Field::mass), bodies[0].column(Field::mass) + count};
}

TEST(ordering, sorts_a_blocks_particles_by_cell_when_they_have_become_mixed) {
    std::vector<double> x, expected;
    for (int p = 0; p < 64; ++p) x.push_back(p % 2 == 0 ? 4.5 : 3.5);
    for (int p = 1; p < 64; p += 2) expected.push_back(p);
    for (int p = 0; p < 64; p += 2) expected.push_back(p);
    EXPECT_EQ(order_after_moving(x), expected);
}

TEST(ordering, leaves_a_block_in_peace_whose_particles_mostly_share_cells_with_their_neighbours) {
    std::vector<double> x, expected;
    for (int p = 0; p < 64; ++p) {
        x.push_back(p < 32 ? 4.5 : 3.5);  // two runs, two cells, in the wrong order
        expected.push_back(p);
    }
    EXPECT_EQ(order_after_moving(x), expected);
}

}  // namespace
}  // namespace matpoint
