// Union, intersection and difference against set logic, point by point.

#include "geometry_fixture.hpp"

namespace matpoint {

class GeometryBooleans : public GeometryTest {
  protected:
    const Json disk = {{"type", "sphere"}, {"center", {0.4, 0.5}}, {"radius", 0.3}};
    const Json square = {{"type", "box"}, {"min", {0.5, 0.3}}, {"max", {1.0, 0.8}}};
    const Json bar = {{"type", "box"}, {"min", {0.0, 0.45}}, {"max", {1.0, 0.6}}};

    /// Compares the type's answers for [disk, square, bar], in bulk and one by one, with `expected`.
    template <class Logic>
    void check(const char* type, Logic expected) {
        const auto combined = make({{"type", type}, {"of", {disk, square, bar}}}, 2);
        const auto a = make(disk, 2), b = make(square, 2), c = make(bar, 2);
        const auto everywhere =
            lattice(*make({{"type", "box"}, {"min", {-0.1, 0}}, {"max", {1.2, 1}}}, 2), 0.02, 2);
        const std::vector<char> bulk = combined->contains(everywhere);
        int found = 0;
        for (std::size_t i = 0; i < everywhere.size(); ++i) {
            const Eigen::Vector3d& x = everywhere[i];
            const bool inside = expected(a->contains(x), b->contains(x), c->contains(x));
            EXPECT_EQ(bulk[i] != 0, inside) << x.transpose();
            EXPECT_EQ(combined->contains(x), inside) << x.transpose();
            if (!inside) continue;
            ++found;
            EXPECT_TRUE((x.array() >= combined->bounds().min.array()).all() &&
                        (x.array() <= combined->bounds().max.array()).all());
        }
        EXPECT_GT(found, 10);
    }
};

TEST_F(GeometryBooleans, UnionIsInAny) {
    check("union", [](bool a, bool b, bool c) { return a || b || c; });
}

TEST_F(GeometryBooleans, IntersectionIsInAll) {
    check("intersection", [](bool a, bool b, bool c) { return a && b && c; });
}

TEST_F(GeometryBooleans, DifferenceIsInTheFirstOnly) {
    check("difference", [](bool a, bool b, bool c) { return a && !b && !c; });
}

TEST_F(GeometryBooleans, Nest) {
    const auto ring =
        make({{"type", "difference"}, {"of", {{{"type", "union"}, {"of", {disk, square}}}, bar}}}, 2);
    EXPECT_TRUE(ring->contains({0.4, 0.7, 0}));
    EXPECT_FALSE(ring->contains({0.4, 0.5, 0}));
    EXPECT_TRUE(ring->contains({0.9, 0.7, 0}));
}

TEST_F(GeometryBooleans, RefuseAnEmptyList) {
    for (const char* type : {"union", "intersection", "difference"})
        EXPECT_EQ(refused({{"type", type}, {"of", Json::array()}}), "/of") << type;
}

TEST_F(GeometryBooleans, RefuseSinglePoints) {
    write("points.csv", "x, y, volume\n0, 0, 1\n");
    const Json points = {{"type", "points"}, {"file", "points.csv"}};
    for (const char* type : {"union", "intersection", "difference"})
        EXPECT_SAYS(error_of({{"type", type}, {"of", {disk, points}}}, 2), "\"of\"[1]") << type;
}

}  // namespace matpoint
