// Polygon and extrusion: areas by the shoelace formula, edges between neighbours, refusals.

#include "geometry_fixture.hpp"

#include <numbers>
#include <random>

namespace matpoint {

class GeometryPolygons : public GeometryTest {
  protected:
    static Json polygon(const Json& vertices) { return {{"type", "polygon"}, {"vertices", vertices}}; }
    std::string refusal(const Json& vertices) { return error_of(polygon(vertices), 2); }

    /// A star with corners in turns at these radii around (at, at).
    static Json star(int corners, double outer, double inner, double at) {
        Json vertices;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners, radius = k % 2 == 0 ? outer : inner;
            vertices.push_back({at + radius * std::cos(angle), at + radius * std::sin(angle)});
        }
        return vertices;
    }
};

// By the sum of angles under which its edges are seen: 2 pi from within, 0 from outside.
TEST_F(GeometryPolygons, InsideIsWhereItWindsAround) {
    const Json vertices = star(14, 0.9, 0.3, 0.2);
    const auto geometry = make(polygon(vertices), 2);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-0.9, 1.3);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
        const double x = anywhere(random), y = anywhere(random);
        double turns = 0;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Json &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
            const double ax = double(a[0]) - x, ay = double(a[1]) - y, bx = double(b[0]) - x,
                         by = double(b[1]) - y;
            turns += std::atan2(ax * by - ay * bx, ax * bx + ay * by) / (2 * std::numbers::pi);
        }
        EXPECT_EQ(geometry->contains({x, y, 0}), std::abs(turns) > 0.5) << x << " " << y;
        inside += std::abs(turns) > 0.5;
    }
    EXPECT_GT(inside, 300);
}

TEST_F(GeometryPolygons, WhichWayItTurnsDoesNotMatter) {
    const auto one = make(polygon({{0, 0}, {2, 0}, {2, 1}, {0, 3}}), 2);
    const auto other = make(polygon({{0, 3}, {2, 1}, {2, 0}, {0, 0}}), 2);
    for (const Eigen::Vector3d& x : lattice(*one, 0.1, 2)) EXPECT_EQ(one->contains(x), other->contains(x));
}

// Corners, level, upright and oblique edges included.
TEST_F(GeometryPolygons, NeighboursShareNoPoint) {
    const std::vector<Json> parts = {{{0, 0}, {1, 0}, {0.5, 0.3}},
                                     {{1, 0}, {1, 1}, {0.5, 0.3}},
                                     {{1, 1}, {0, 1}, {0.5, 0.3}},
                                     {{0, 1}, {0, 0}, {0.5, 0.3}}};
    std::vector<std::shared_ptr<Geometry>> geometries;
    for (const Json& part : parts) geometries.push_back(make(polygon(part), 2));
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j) {
            const Eigen::Vector3d x(i / 60.0, j / 60.0, 0);
            int owners = 0;
            for (const auto& geometry : geometries) owners += geometry->contains(x);
            EXPECT_EQ(owners, 1) << x.transpose();
        }
}

TEST_F(GeometryPolygons, StraightCornersAndDentsAreFine) {
    EXPECT_EQ(refusal({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}), "");
    EXPECT_EQ(refusal(star(100, 1, 0.01, 1e6)), "");
    EXPECT_EQ(refusal(star(100, 1, 0.5, 0)), "");
}

TEST_F(GeometryPolygons, RefusesEdgesThatMeet) {
    EXPECT_SAYS(refusal({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),
                "edge 0 of `vertices`, from [0, 0] to [1, 1], crosses edge 2 of `vertices`, from [1, 0] to");
    EXPECT_SAYS(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}),
                "edge 0 of `vertices`, from [0, 0] to [2, "
                "0], touches edge 2");
    // Two triangles that have a corner in common, and one edge that comes back on another.
    EXPECT_SAYS(refusal({{0, 0}, {1, 0}, {0.5, 1}, {1, 2}, {0, 2}, {0.5, 1}}), "touches");
    EXPECT_SAYS(refusal({{0, 0}, {3, 0.3}, {2, 0.2}, {1, 2}}),
                "edge 0 of `vertices`, from [0, 0] to [3, 0.3], "
                "touches edge 1");
    EXPECT_SAYS(refusal({{0, 0}, {1, 0}, {2, 0}}), "touches");
    EXPECT_SAYS(refusal({{0, 0}, {1, 0}, {1, 0}, {1, 1}}),
                "edge 1 of `vertices`, from [1, 0] to [1, 0], has no");
    EXPECT_SAYS(refusal({{0, 0}, {1, 0}, {1, 1}, {0, 0}}), "the last vertex needs not repeat the first");
}

TEST_F(GeometryPolygons, ExtrusionIsItsSectionBetweenTwoPlanes) {
    const Json vertices = {{0, 0}, {1, 0}, {1, 1}, {0.5, 0.2}, {0, 1}};
    const auto section = make(polygon(vertices), 2);
    for (int axis = 0; axis < 3; ++axis) {
        const auto solid = make({{"type", "extrusion"},
                                 {"vertices", vertices},
                                 {"axis", std::string(1, "xyz"[axis])},
                                 {"from", 0.25},
                                 {"to", 0.5}});
        const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
        EXPECT_EQ(solid->bounds().min[axis], 0.25);
        EXPECT_EQ(solid->bounds().max[axis], 0.5);
        EXPECT_EQ(solid->bounds().max[u], 1);
        for (int k = 0; k < 1000; ++k) {
            Eigen::Vector3d x;
            x[u] = k % 10 / 10.0;
            x[v] = k / 10 % 10 / 10.0;
            x[axis] = k / 100 / 10.0;
            const bool between = x[axis] >= 0.25 && x[axis] < 0.5;
            EXPECT_EQ(solid->contains(x), between && section->contains({x[u], x[v], 0}));
        }
    }
}

TEST_F(GeometryPolygons, ExtrusionRefusesItsEndsInTheWrongOrder) {
    const Json triangle = {{0, 0}, {1, 0}, {0, 1}};
    EXPECT_EQ(refused({{"type", "extrusion"}, {"vertices", triangle}, {"axis", "x"}, {"from", 1}, {"to", 1}}),
              "/to");
    EXPECT_EQ(refused({{"type", "extrusion"}, {"vertices", triangle}, {"axis", "x"}, {"from", 1}, {"to", 2}}),
              "");
}

}  // namespace matpoint
