// What geometries say of lines through them, and the volume of bodies that are seeded from it.

#include "geometry_fixture.hpp"

#include "particles/region_volume.hpp"
#include "particles/seeding.hpp"

#include <limits>
#include <numbers>
#include <random>

namespace matpoint {

using std::numbers::pi;

class GeometryVolume : public GeometryTest {
  protected:
    /// Cells of 0.1 over [-0.05, 2.05] along each axis; radii begin at 0.05 when axisymmetric.
    template <class S>
    static Particles<S> seeded(const Geometry& geometry, int per_axis) {
        typename Patch<S>::Coordinates cells;
        cells.fill(21);
        Particles<S> particles("body");
        particles.require(Field::initial_half_size);
        seed(particles, Patch<S>({S::axisymmetric ? 0.05 : -0.05, -0.05, -0.05}, {0.1, 0.1, 0.1}, cells),
             geometry, {per_axis, per_axis, per_axis}, 1000);
        return particles;
    }

    template <class S>
    static double volume(const Particles<S>& particles) {
        double sum = 0;
        for (Index p = 0; p < particles.size(); ++p)
            sum += static_cast<double>(particles.column(Field::volume)[p]);
        return sum;
    }

    /// Bodies of 1 to 3 particles an axis and cell, and the geometry by itself.
    template <class S>
    void expect_volume(const Json& own, double volume_of_it, double relative) {
        const auto geometry = make(own, S::mode);
        ASSERT_TRUE(volume_of<S>(*geometry));
        EXPECT_NEAR(*volume_of<S>(*geometry) / volume_of_it, 1, relative) << own;
        for (int per_axis = 1; per_axis <= 3; ++per_axis)
            EXPECT_NEAR(volume(seeded<S>(*geometry, per_axis)) / volume_of_it, 1, relative)
                << own << " with " << per_axis;
    }
};

// In turns inside and outside, as contains() has it.
TEST_F(GeometryVolume, LinesAgreeWithPoints) {
    const Json box = {{"type", "box"}, {"min", {0.3, 0.2, 0.1}}, {"max", {0.7, 0.9, 0.55}}};
    const Json ball = {{"type", "sphere"}, {"center", {0.5, 0.4, 0.6}}, {"radius", 0.35}};
    const auto tube = [](std::vector<double> start, std::vector<double> end) {
        return Json{
            {"type", "cylinder"}, {"start", start}, {"end", end}, {"radius", 0.3}, {"inner_radius", 0.2}};
    };
    const Json oblique = tube({0.2, 0.3, 0.2}, {0.8, 0.5, 0.9});
    std::vector<Json> all = {box,
                             ball,
                             oblique,
                             tube({0.1, 0.5, 0.5}, {0.9, 0.5, 0.5}),
                             tube({0.5, 0.1, 0.5}, {0.5, 0.9, 0.5}),
                             tube({0.5, 0.5, 0.9}, {0.5, 0.5, 0.1})};
    for (const char* axis : {"x", "y", "z"})
        all.push_back({{"type", "extrusion"},
                       {"vertices", {{0.1, 0.1}, {0.9, 0.2}, {0.8, 0.9}, {0.5, 0.3}, {0.2, 0.9}}},
                       {"axis", axis},
                       {"from", 0.2},
                       {"to", 0.7}});
    const Json half = {{"type", "half_space"}, {"point", {0.5, 0.4, 0.6}}, {"normal", {1, -2, 0.5}}};
    all.push_back(half);
    all.push_back({{"type", "half_space"}, {"point", {0.5, 0.4, 0.6}}, {"normal", {0, -2, 0.5}}});
    all.push_back({{"type", "wedge"},
                   {"tip", {0.5, 0.4, 0.6}},
                   {"half_angle", 40},
                   {"direction", {0, 1, 2}},
                   {"edge", {1, 2, -1}}});
    all.push_back(
        {{"type", "cone"}, {"tip", {0.5, 0.2, 0.6}}, {"half_angle", 40}, {"direction", {0.2, 1, -0.3}}});
    for (const char* type : {"union", "intersection", "difference"}) {
        all.push_back({{"type", type}, {"of", {half, box}}});
        all.push_back({{"type", type}, {"of", {ball, box}}});
        all.push_back({{"type", type}, {"of", {oblique, all.back(), ball}}});
    }
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(0, 1);
    for (const Json& own : all) {
        const auto geometry = make(own);
        std::vector<Eigen::Vector2d> lines(200);
        for (Eigen::Vector2d& line : lines) line << anywhere(random), anywhere(random);
        const std::vector<Intervals> sections = geometry->along_x(lines, {0, 1}, 0.01),
                                     searched = geometry->Geometry::along_x(lines, {0, 1}, 0.001);
        ASSERT_EQ(sections.size(), lines.size());
        int inside = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            double length = 0, searched_length = 0, end = -std::numeric_limits<double>::infinity();
            for (const Interval& part : sections[i]) {
                EXPECT_LE(end, part.begin) << own;
                EXPECT_LE(part.begin, part.end) << own;
                end = part.end;
                length += std::max(0.0, std::min(part.end, 1.0) - std::max(part.begin, 0.0));
            }
            for (const Interval& part : searched[i]) searched_length += part.end - part.begin;
            EXPECT_NEAR(searched_length, length, 4e-3) << own;
            for (int k = 0; k < 50; ++k) {
                const double x = anywhere(random);
                const auto around = [&](const Interval& part) { return part.begin <= x && x < part.end; };
                const bool found = std::ranges::any_of(sections[i], around);
                EXPECT_EQ(geometry->contains({x, lines[i][0], lines[i][1]}), found) << own << x;
                inside += found;
            }
        }
        EXPECT_GT(inside, 10) << own;
    }
}

TEST_F(GeometryVolume, BoxesHaveTheirsWhereverTheyLie) {
    for (const double at : {0.3, 0.35, 0.3333, 0.349999999, 0.37})
        for (const double size : {0.07, 0.013, 0.1, 0.56, 0.46123}) {
            const double end = at + size;
            expect_volume<Bar>({{"type", "box"}, {"min", {at}}, {"max", {end}}}, end - at, 1e-12);
            const Json square = {{"type", "box"}, {"min", {at, 0.3}}, {"max", {end, 0.76}}};
            expect_volume<PlaneStrain>(square, (end - at) * (0.76 - 0.3), 1e-12);
            expect_volume<Axisymmetric>(square, pi * (end * end - at * at) * (0.76 - 0.3), 1e-12);
            expect_volume<Solid>({{"type", "box"}, {"min", {at, 0.3, at}}, {"max", {end, 0.76, end}}},
                                 (end - at) * (end - at) * (0.76 - 0.3), 1e-12);
            expect_volume<PlaneStrainSingle>(square, (end - at) * (0.76 - 0.3), 1e-5);
        }
}

TEST_F(GeometryVolume, WhatIsPutTogetherFromBoxesHasIts) {
    const Json foot = {{"type", "box"}, {"min", {0.11, 0.12}}, {"max", {1.53, 0.47}}};
    const Json leg = {{"type", "box"}, {"min", {0.33, 0.2}}, {"max", {0.72, 1.61}}};
    const double both = (0.72 - 0.33) * (0.47 - 0.2);
    const double a = (1.53 - 0.11) * (0.47 - 0.12), b = (0.72 - 0.33) * (1.61 - 0.2);
    expect_volume<PlaneStrain>({{"type", "union"}, {"of", {foot, leg}}}, a + b - both, 1e-12);
    expect_volume<PlaneStrain>({{"type", "intersection"}, {"of", {foot, leg}}}, both, 1e-12);
    expect_volume<PlaneStrain>({{"type", "difference"}, {"of", {foot, leg}}}, a - both, 1e-12);
    const Json outer = {{"type", "box"}, {"min", {0.11, 0.12, 0.13}}, {"max", {1.5, 1.4, 1.3}}};
    const Json inner = {{"type", "box"}, {"min", {0.14, 0.16, 0.18}}, {"max", {1.48, 1.37, 1.21}}};
    expect_volume<Solid>({{"type", "difference"}, {"of", {outer, inner}}},
                         1.39 * 1.28 * 1.17 - 1.34 * 1.21 * 1.03, 1e-12);
}

/// Twice the area and six times the first moment about u = 0 of a polygon [shoelace formula].
std::pair<double, double> shoelace(const Json& vertices) {
    double area = 0, moment = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Json &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
        const double cross = double(a[0]) * double(b[1]) - double(b[0]) * double(a[1]);
        area += cross;
        moment += (double(a[0]) + double(b[0])) * cross;
    }
    return {area, moment};
}

TEST_F(GeometryVolume, PolygonsHaveTheirs) {
    for (const double at : {0.0, 0.0333, 0.07}) {
        Json dented = {{0.31, 0.2},  {1.1, 0.27}, {1.53, 0.2}, {1.2, 0.9},
                       {1.41, 1.63}, {0.7, 0.6},  {0.36, 1.2}};
        Json thin = {{0.3, 0.3}, {1.7, 0.3005}, {1.0, 0.317}};
        for (Json* const vertices : {&dented, &thin}) {
            for (Json& vertex : *vertices) vertex[0] = double(vertex[0]) + at;
            const auto [area, moment] = shoelace(*vertices);
            const Json plane = {{"type", "polygon"}, {"vertices", *vertices}};
            expect_volume<PlaneStrain>(plane, area / 2, 1e-12);
            expect_volume<PlaneStrainSingle>(plane, area / 2, 1e-5);
            expect_volume<Axisymmetric>(plane, 2 * pi * moment / 6, 1e-12);
            const auto drawn = [&](const char* axis) {
                return Json{{"type", "extrusion"},
                            {"vertices", *vertices},
                            {"axis", axis},
                            {"from", 0.413},
                            {"to", 0.83}};
            };
            expect_volume<Solid>(drawn("y"), 0.417 * area / 2, 1e-12);
            expect_volume<Solid>(drawn("z"), 0.417 * area / 2, 1e-12);
            if (vertices == &dented) expect_volume<Solid>(drawn("x"), 0.417 * area / 2, 1e-3);
        }
    }
}

TEST_F(GeometryVolume, RoundBodiesHaveTheirs) {
    for (const double radius : {0.13, 0.31, 0.5, 0.97})
        for (const double center : {1.0, 1.017, 1.05}) {
            const Json ball = {{"type", "sphere"}, {"center", {center, 1, center}}, {"radius", radius}};
            const Json disk = {{"type", "sphere"}, {"center", {center, 1}}, {"radius", radius}};
            expect_volume<Solid>(ball, 4 * pi / 3 * std::pow(radius, 3), 1e-3);
            expect_volume<PlaneStrain>(disk, pi * radius * radius, 1e-3);
            if (radius < 0.9) expect_volume<Axisymmetric>(disk, 2 * pi * center * pi * radius * radius, 1e-3);
        }
    const double length = std::sqrt(0.4 * 0.4 + 0.4 * 0.4 + 0.2 * 0.2);
    for (const double bore : {0.0, 0.3, 0.39}) {
        const Json oblique = {{"type", "cylinder"},
                              {"start", {0.7, 0.8, 0.6}},
                              {"end", {1.1, 1.2, 0.8}},
                              {"radius", 0.4},
                              {"inner_radius", bore}};
        const Json upright = {{"type", "cylinder"},
                              {"start", {0.7, 0.8, 0.63}},
                              {"end", {0.7, 0.8, 1.27}},
                              {"radius", 0.4},
                              {"inner_radius", bore}};
        expect_volume<Solid>(oblique, pi * (0.16 - bore * bore) * length, 1e-3);
        expect_volume<Solid>(upright, pi * (0.16 - bore * bore) * 0.64, 1e-3);
    }
    const Json block = {{"type", "box"}, {"min", {0.31, 0.33, 0.37}}, {"max", {1.29, 1.11, 1.13}}};
    const Json hole = {{"type", "sphere"}, {"center", {0.8, 0.7, 0.8}}, {"radius", 0.3}};
    expect_volume<Solid>({{"type", "difference"}, {"of", {block, hole}}},
                         0.98 * 0.78 * 0.76 - 4 * pi / 3 * 0.027, 1e-3);
}

TEST_F(GeometryVolume, FacesOfABodyAreItsGeometrys) {
    const auto box = make({{"type", "box"}, {"min", {0.3333, 0.21, 0.4}}, {"max", {1.27, 0.274, 1.5}}});
    const auto particles = seeded<Solid>(*box, 2);
    const Geometry::Bounds bounds = box->bounds();
    for (int a = 0; a < 3; ++a) {
        double min = 1e9, max = -1e9;
        for (Index p = 0; p < particles.size(); ++p) {
            min = std::min(min, particles.position(p)[a] - particles.vector(Field::initial_half_size, p)[a]);
            max = std::max(max, particles.position(p)[a] + particles.vector(Field::initial_half_size, p)[a]);
        }
        EXPECT_NEAR(min, bounds.min[a], 1e-13);
        EXPECT_NEAR(max, bounds.max[a], 1e-13);
    }
}

}  // namespace matpoint
