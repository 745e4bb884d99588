// Surfaces of triangles: a cube and spheres, sound and damaged, against their volumes.

#include "geometry_fixture.hpp"

#include <Eigen/Geometry>

#include <cstring>
#include <numbers>
#include <sstream>

namespace matpoint {

namespace {

using Corner = Eigen::Vector3f;
using Mesh = std::vector<std::array<Corner, 3>>;

/// The unit cube; its faces' diagonals and edges run through lattice points.
Mesh cube() {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const auto corner = [&](float u, float v) {
                Corner c;
                c[axis] = static_cast<float>(side);
                c[(axis + 1) % 3] = side ? u : v;
                c[(axis + 2) % 3] = side ? v : u;
                return c;
            };
            mesh.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
            mesh.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
        }
    return mesh;
}

/// A unit octahedron whose triangles are split in four `levels` times, its corners on the unit sphere.
Mesh sphere(int levels) {
    Mesh mesh;
    for (const float x : {-1.f, 1.f})
        for (const float y : {-1.f, 1.f})
            for (const float z : {-1.f, 1.f}) {
                std::array<Corner, 3> t{Corner(x, 0, 0), Corner(0, y, 0), Corner(0, 0, z)};
                if (x * y * z < 0) std::swap(t[1], t[2]);
                mesh.push_back(t);
            }
    for (int level = 0; level < levels; ++level) {
        Mesh finer;
        for (const auto& [a, b, c] : mesh) {
            const Corner ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh = finer;
    }
    return mesh;
}

/// By the divergence theorem: the sum of the tetrahedra between the origin and the faces.
double enclosed_volume(const Mesh& mesh) {
    double volume = 0;
    for (const auto& [a, b, c] : mesh)
        volume += a.cast<double>().dot(b.cast<double>().cross(c.cast<double>())) / 6;
    return volume;
}

std::string binary(const Mesh& mesh, const std::string& header = "made for a test") {
    std::string data = header;
    data.resize(80, ' ');
    const auto put = [&](const void* bytes, std::size_t size) {
        data.append(static_cast<const char*>(bytes), size);
    };
    const auto count = static_cast<std::uint32_t>(mesh.size());
    put(&count, 4);
    for (const auto& triangle : mesh) {
        const float normal[3] = {0, 0, 0};
        put(normal, 12);
        for (const Corner& corner : triangle) put(corner.data(), 12);
        put("\0\0", 2);
    }
    return data;
}

std::string ascii(const Mesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    text << "solid a test's mesh\n";
    for (const auto& triangle : mesh) {
        text << "  facet normal 0 0 0\n    outer loop\n";
        for (const Corner& c : triangle)
            text << "      vertex " << c[0] << " " << c[1] << " " << c[2] << "\n";
        text << "    endloop\n  endfacet\n";
    }
    text << "endsolid a test's mesh\n";
    return text.str();
}

}  // namespace

class GeometryStl : public GeometryTest {
  protected:
    std::shared_ptr<Geometry> make_stl(const std::string& data) {
        write("mesh.stl", data);
        return make({{"type", "stl"}, {"file", "mesh.stl"}});
    }
    std::string error_of_stl(const std::string& data) {
        write("mesh.stl", data);
        return error_of({{"type", "stl"}, {"file", "mesh.stl"}});
    }
};

TEST_F(GeometryStl, CubeHasItsVolumeExactly) {
    EXPECT_DOUBLE_EQ(measured_volume(*make_stl(binary(cube())), 1.0 / 16, 3), 1);
    EXPECT_DOUBLE_EQ(measured_volume(*make_stl(ascii(cube())), 1.0 / 16, 3), 1);
}

TEST_F(GeometryStl, SphereConvergesToTheMeshAndTheMeshToTheSphere) {
    const Mesh mesh = sphere(4);
    const auto geometry = make_stl(binary(mesh));
    for (const double h : {0.1, 0.05, 0.025})
        EXPECT_NEAR(measured_volume(*geometry, h, 3), enclosed_volume(mesh), 0.1 * 4 * std::numbers::pi * h)
            << "h = " << h;
    EXPECT_NEAR(measured_volume(*geometry, 0.025, 3), 4 * std::numbers::pi / 3,
                0.01 * 4 * std::numbers::pi / 3);
}

TEST_F(GeometryStl, BinaryAndAsciiAgree) {
    const auto a = make_stl(binary(sphere(3))), b = make_stl(ascii(sphere(3)));
    const auto points = lattice(*a, 0.05, 3);
    EXPECT_EQ(a->contains(points), b->contains(points));
}

// Lines along the axes through these points meet edges, diagonals and corners exactly.
TEST_F(GeometryStl, LinesThroughEdgesAndCornersDoNotLeak) {
    const auto a_cube = make_stl(binary(cube())), a_sphere = make_stl(binary(sphere(3)));
    for (int k = -12; k <= 12; ++k)
        for (int j = -12; j <= 12; ++j)
            for (int i = -12; i <= 12; ++i) {
                const Eigen::Vector3d x(i / 8.0, j / 8.0, k / 8.0);
                const double from_center = (x.array() - 0.5).abs().maxCoeff();
                if (from_center != 0.5) {
                    EXPECT_EQ(a_cube->contains(x), from_center < 0.5) << x.transpose();
                }
                if (std::abs(x.norm() - 0.98) > 0.03) {
                    EXPECT_EQ(a_sphere->contains(x), x.norm() < 0.98) << x.transpose();
                }
            }
}

TEST_F(GeometryStl, FlippedFacesDoNotMatter) {
    Mesh mesh = sphere(3);
    const auto sound = make_stl(binary(mesh));
    for (std::size_t t = 0; t < mesh.size(); t += 3) std::swap(mesh[t][0], mesh[t][1]);
    const auto flipped = make_stl(binary(mesh));
    const auto points = lattice(*sound, 0.05, 3);
    EXPECT_EQ(flipped->contains(points), sound->contains(points));
}

TEST_F(GeometryStl, SmallHolesAreVotedAwayWithAWarning) {
    Mesh mesh = sphere(4);
    const auto sound = make_stl(binary(mesh));
    EXPECT_TRUE(warnings.empty());
    for (const std::size_t t : {1500, 700, 11}) mesh.erase(mesh.begin() + static_cast<std::ptrdiff_t>(t));
    const auto holed = make_stl(binary(mesh));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_SAYS(warnings[0], "mesh.stl: its surface is open: 9 edges border on holes");
    const auto points = lattice(*sound, 0.05, 3);
    const std::vector<char> expected = sound->contains(points), found = holed->contains(points);
    std::size_t different = 0;
    for (std::size_t i = 0; i < points.size(); ++i) different += expected[i] != found[i];
    EXPECT_LE(different, points.size() / 1000);
}

TEST_F(GeometryStl, AnOpenBowlIsRefusedWithItsOpenEdges) {
    Mesh mesh = sphere(3);
    std::erase_if(mesh, [](const auto& t) { return (t[0] + t[1] + t[2]).sum() > 0; });
    const std::string error = error_of_stl(binary(mesh));
    EXPECT_SAYS(error, "mesh.stl");
    EXPECT_SAYS(error, "its surface is open");
    EXPECT_SAYS(error, "border on a hole");
    // The octahedron less one face: a hole of three edges, and too wide for the vote.
    Mesh octahedron = sphere(0);
    octahedron.pop_back();
    EXPECT_SAYS(error_of_stl(binary(octahedron)), "its 7 triangles, 3 border on a hole and 0 join faces");
}

// Corners, edges and faces are the nearest place in turns.
TEST_F(GeometryStl, DistanceIsThatOfTheBox) {
    Mesh mesh = cube();
    for (std::size_t t = 0; t < mesh.size(); t += 3) std::swap(mesh[t][0], mesh[t][1]);
    const auto from_mesh = make_stl(binary(mesh));
    const auto box = make({{"type", "box"}, {"min", {0, 0, 0}}, {"max", {1, 1, 1}}});
    for (int k = 0; k < 17 * 17 * 17; ++k) {
        const Eigen::Vector3d x(k % 17 * 0.11 - 0.4, k / 17 % 17 * 0.112 - 0.41, k / 289 * 0.114 - 0.42);
        const SignedDistance found = from_mesh->signed_distance(x), expected = box->signed_distance(x);
        EXPECT_NEAR(found.distance, expected.distance, 1e-14) << x.transpose();
        EXPECT_NEAR((found.normal - expected.normal).norm(), 0, 1e-13) << x.transpose();
    }
}

// Of a shell: all triangles, one by one, by many points on each; the inside by contains().
TEST_F(GeometryStl, DistanceIsThatOfTheNearestTriangle) {
    Mesh mesh = sphere(2);
    for (const auto& [a, b, c] : sphere(1)) mesh.push_back({0.5f * a, 0.5f * b, 0.5f * c});
    const auto shell = make_stl(binary(mesh));
    constexpr int n = 24;
    for (int k = 0; k < 6 * 6 * 6; ++k) {
        const Eigen::Vector3d x(k % 6 * 0.5 - 1.23, k / 6 % 6 * 0.5 - 1.24, k / 36 * 0.5 - 1.26);
        double least = 10;
        for (const auto& [a, b, c] : mesh)
            for (int i = 0; i <= n; ++i)
                for (int j = 0; i + j <= n; ++j) {
                    const Eigen::Vector3d y =
                        (i * a.cast<double>() + j * b.cast<double>() + (n - i - j) * c.cast<double>()) / n;
                    least = std::min(least, (x - y).norm());
                }
        const auto [distance, normal] = shell->signed_distance(x);
        const double spacing = 0.8 / n;  // of the points on the longest edge
        EXPECT_LE(std::abs(distance), least + 1e-12) << x.transpose();
        EXPECT_GE(std::abs(distance), std::sqrt(std::max(0.0, least * least - spacing * spacing)))
            << x.transpose();
        EXPECT_EQ(distance < 0, shell->contains(x)) << x.transpose();
        EXPECT_NEAR(normal.norm(), 1, 1e-12);
        EXPECT_NEAR(shell->signed_distance(x - distance * normal).distance, 0, 1e-12) << x.transpose();
    }
}

TEST_F(GeometryStl, DegenerateTrianglesAreIgnored) {
    Mesh mesh = cube();
    mesh.push_back({Corner(0, 0, 0), Corner(0, 0, 0), Corner(5, 5, 5)});
    mesh.push_back({Corner(9, 0, 0), Corner(9, 0, 0), Corner(9, 0, 0)});
    const auto geometry = make_stl(binary(mesh));
    EXPECT_EQ(geometry->bounds().max, Eigen::Vector3d(1, 1, 1));
    EXPECT_DOUBLE_EQ(measured_volume(*geometry, 0.125, 3), 1);
}

TEST_F(GeometryStl, ScalesThenMoves) {
    write("mesh.stl", binary(cube()));
    const auto geometry =
        make({{"type", "stl"}, {"file", "mesh.stl"}, {"scale", 0.001}, {"translate", {1, 2, 3}}});
    EXPECT_TRUE(geometry->bounds().min.isApprox(Eigen::Vector3d(1, 2, 3)));
    EXPECT_TRUE(geometry->bounds().max.isApprox(Eigen::Vector3d(1.001, 2.001, 3.001)));
}

TEST_F(GeometryStl, ABinaryFileMaySaySolid) {
    EXPECT_DOUBLE_EQ(measured_volume(*make_stl(binary(cube(), "solid facet")), 0.125, 3), 1);
}

TEST_F(GeometryStl, TellsWhatIsWrongWithAFile) {
    const std::string sound = binary(cube()), text = ascii(cube());  // 12 triangles: 684 bytes
    EXPECT_SAYS(error_of_stl(""), "mesh.stl is empty");
    EXPECT_SAYS(error_of_stl("hello"), "5 bytes and is not ASCII STL");
    EXPECT_SAYS(error_of_stl(sound.substr(0, 500)),
                "announces 12 triangles, which take 684 bytes, but the file has 500");
    EXPECT_SAYS(error_of_stl(binary(cube(), "solid").substr(0, 500)), "announces 12 triangles");
    std::string huge = sound;
    std::memset(huge.data() + 80, 0xff, 4);
    EXPECT_SAYS(error_of_stl(huge), "announces 4294967295 triangles");
    EXPECT_SAYS(error_of_stl(binary({})), "has no triangles");
    EXPECT_SAYS(error_of_stl("solid nothing\nendsolid nothing\n"), "has no triangles");
    EXPECT_SAYS(error_of_stl(text.substr(0, text.size() / 2)), "truncated");
    std::string misspelt = text;
    misspelt.replace(misspelt.find("vertex"), 6, "vortex");
    EXPECT_SAYS(error_of_stl(misspelt), "mesh.stl:4: expected \"vertex\", found \"vortex");
    std::string not_finite = text;
    not_finite.replace(not_finite.find("vertex") + 7, 1, "nan");
    EXPECT_SAYS(error_of_stl(not_finite), "mesh.stl:4: expected \"vertex\" and three finite numbers");
    EXPECT_SAYS(error_of({{"type", "stl"}, {"file", "missing.stl"}}), "missing.stl");
}

}  // namespace matpoint
