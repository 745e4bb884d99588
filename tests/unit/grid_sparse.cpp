#include <matpoint/grid.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace matpoint {
namespace {

Patch<Solid> cube(int cells) {
    return {{0, 0, 0}, {1, 1, 1}, {cells, cells, cells}};
}

TEST(patch, memory_depends_on_the_blocks_that_exist_alone) {
    std::array<std::size_t, 2> bytes{};
    for (std::size_t k = 0; k < 2; ++k) {
        Patch<Solid> patch = cube(k == 0 ? 50 : 5000);
        patch.set_blocks({0, 1, 7});
        bytes[k] = patch.bytes();
    }
    EXPECT_EQ(bytes[0], bytes[1]);
}

TEST(patch, finds_every_block_that_exists_and_no_other) {
    Patch<Solid> patch = cube(400);
    std::vector<int> numbers;
    for (int k = 0; k < 5000; ++k) numbers.push_back(37 * k);
    patch.set_blocks(numbers);
    for (int k = 0; k < 5000; ++k) {
        EXPECT_EQ(patch.block_place(patch.block_coordinates(37 * k)), Index{64} * k);
        auto node = patch.node_coordinates(64 * k);
        EXPECT_EQ(patch.node_index(node), 64 * k);
        const auto absent = patch.block_coordinates(37 * k + 1);
        for (std::size_t a = 0; a < 3; ++a) node[a] = absent[a] * 4 - 1;
        EXPECT_EQ(patch.node_index(node), -1);
    }
}

TEST(patch, refuses_more_blocks_than_can_be_numbered) {
    EXPECT_THROW(cube(8000), std::invalid_argument);
    EXPECT_NO_THROW(cube(5000));
}

}  // namespace
}  // namespace matpoint
