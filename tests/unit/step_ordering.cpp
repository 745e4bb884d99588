#include "step/mixing.hpp"
#include "step/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
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

/// A body whose particles share a cell of 1 m, the fourth along x and y.
class Ordered : public testing::Test {
  protected:
    explicit Ordered(Index count = 1) {
        bodies.emplace_back("block");
        bodies[0].resize(count);
        for (Index p = 0; p < count; ++p) x()[p] = bodies[0].column(Field::position, 1)[p] = 3.5;
        EXPECT_TRUE(update());
    }
    double* x() { return bodies[0].column(Field::position, 0); }
    bool update() { return ordering.update(levels, bodies, Corners()); }

    Patch<S> patch{{0, 0, 0}, {1, 1, 1}, {32, 32}};
    Levels<S> levels{patch, {}, {}};
    std::vector<Particles<S>> bodies;
    Ordering<S> ordering{1};
};

TEST_F(Ordered, forgets_the_colours_of_a_body_with_its_ranges) {
    ASSERT_EQ(ordering.ranges(0).size(), 1U);

    // The last particle leaves the grid: nothing may point into the ranges any more.
    bodies[0].permute({});
    ordering.forget(0);
    update();
    EXPECT_TRUE(ordering.ranges(0).empty());
    for (const auto& colour : ordering.colours(0)) EXPECT_TRUE(colour.empty());
}

TEST_F(Ordered, takes_the_grids_blocks_only_when_it_sorts) {
    EXPECT_EQ(patch.node_count(), 0);
    patch.set_blocks({0, 7});
    x()[0] += 1;
    ASSERT_FALSE(update());
    EXPECT_EQ(patch.existing_blocks(), std::vector({0, 7}));

    ordering.forget(0);
    ASSERT_TRUE(update());
    EXPECT_EQ(patch.node_count(), 0);
}

/// Many particles of one block, numbered by their masses.
class Mixed : public Ordered {
  protected:
    static constexpr Index count = 64;
    Mixed() : Ordered(count) { std::iota(mass(), mass() + count, 0.0); }
    double* mass() { return bodies[0].column(Field::mass); }
    void sort() { sort_if_mixed(patch, bodies[0], ordering.ranges(0)[0], Corners()); }
};

TEST_F(Mixed, are_put_into_the_order_of_cells) {
    for (Index p = 0; p < count; ++p) x()[p] = 3.5 + static_cast<double>(p * 7 % 3);
    const std::vector before(x(), x() + count);
    sort();
    EXPECT_TRUE(std::is_sorted(x(), x() + count));
    for (Index p = 0; p < count; ++p) EXPECT_EQ(x()[p], before[static_cast<std::size_t>(mass()[p])]);
    std::sort(mass(), mass() + count);
    for (Index p = 0; p < count; ++p) EXPECT_EQ(mass()[p], static_cast<double>(p));  // nobody is lost
}

TEST_F(Mixed, stay_where_they_are_if_that_is_in_their_cells_part) {
    for (Index p = 0; p < count; ++p) x()[p] = p < 32 ? 3.5 : 4.5;
    const std::vector<Index> strangers{20, 25, 40, 45};
    for (const Index p : strangers) x()[p] = p < 32 ? 4.5 : 3.5;
    sort();
    EXPECT_TRUE(std::is_sorted(x(), x() + count));
    for (Index p = 0; p < count; ++p)
        EXPECT_EQ(mass()[p] != static_cast<double>(p), std::ranges::count(strangers, p) == 1) << p;
}

TEST_F(Mixed, are_left_in_peace_while_most_share_cells_with_their_neighbours) {
    for (Index p = 0; p < count; ++p) x()[p] = p < 32 ? 4.5 : 3.5;  // two runs, two cells, in the wrong order
    sort();
    EXPECT_TRUE(std::is_sorted(mass(), mass() + count));
}

}  // namespace
}  // namespace matpoint
