#include "mesh_distance.hpp"
#include "stl_file.hpp"
#include "triangle_mesh.hpp"

#include <matpoint/geometry.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <memory>
#include <mutex>
#include <stdexcept>

using namespace matpoint;

/// The inside of a surface of triangles; see README.md.
class Stl final : public Geometry {
  public:
    static Schema schema() {
        return Schema("Inside of a closed surface of triangles, from an STL file")
            .add("file", ParameterType::file, {.doc = "STL file, binary or ASCII"})
            .number("scale",
                    {.unit = "m", .doc = "Length of the file's unit", .default_value = 1, .greater_than = 0})
            .vector("translate", {.unit = "m",
                                  .doc = "Where the file's origin is put, after scaling",
                                  .default_value = Json::array({0, 0, 0})})
            .dimensions({3});
    }
    explicit Stl(const Parameters& parameters) : mesh_(read_mesh(parameters)) {
        if (mesh_.open_edges() == 0) return;
        const std::string name = parameters.file("file").string();
        refuse_undecidable(name);
        parameters.warn(
            name + ": its surface is open: " + std::to_string(mesh_.open_edges()) +
            " edges border on holes; what is inside was told by lines along x, y and z, by majority");
    }

    Bounds bounds() const override { return {mesh_.min(), mesh_.max()}; }

    bool contains(const Eigen::Vector3d& point) const override {
        return mesh_.classify(std::span(&point, 1))[0] == TriangleMesh::Verdict::inside;
    }

    std::vector<char> contains(std::span<const Eigen::Vector3d> points) const override {
        const std::vector<TriangleMesh::Verdict> verdicts = mesh_.classify(points);
        std::vector<char> inside(points.size());
        std::transform(verdicts.begin(), verdicts.end(), inside.begin(),
                       [](TriangleMesh::Verdict v) { return v == TriangleMesh::Verdict::inside; });
        return inside;
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        return mesh_.along_x(lines);
    }

    std::vector<double> breaks(int axis) const override { return mesh_.flat_faces(axis); }

    /// What it takes is made for the first who asks: bodies don't.
    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        std::call_once(distance_is_made_, [this] { distance_ = std::make_unique<MeshDistance>(mesh_); });
        return (*distance_)(point);
    }

  private:
    static TriangleMesh read_mesh(const Parameters& parameters) {
        const std::vector<Triangle> read = read_stl_file(parameters.file("file"));
        const double scale = parameters.number("scale");
        const Eigen::Vector3d translate = Eigen::Vector3d::Map(parameters.vector("translate").data());
        std::vector<TriangleMesh::Triangle> triangles(read.size());
        for (std::size_t t = 0; t < read.size(); ++t)
            for (std::size_t c = 0; c < 3; ++c)
                triangles[t][c] = scale * read[t][c].cast<double>() + translate;
        return TriangleMesh(std::move(triangles));
    }

    /// Tries a lattice of points: if lines along the three axes leave more than one in a thousand
    /// undecided, what the surface encloses is a guess.
    void refuse_undecidable(const std::string& name) const {
        constexpr int n = 32;
        const Eigen::Vector3d spacing = (mesh_.max() - mesh_.min()) / n;
        std::vector<Eigen::Vector3d> lattice;
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    lattice.push_back(mesh_.min() +
                                      spacing.cwiseProduct(Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5)));
        const auto verdicts = mesh_.classify(lattice);
        const auto undecided = std::count(verdicts.begin(), verdicts.end(), TriangleMesh::Verdict::undecided);
        if (1000 * undecided > n * n * n)
            throw std::invalid_argument(
                name + ": its surface is open, so that its inside cannot be told for " +
                std::to_string(undecided) + " of " + std::to_string(n * n * n) +
                " points: of the edges of its " + std::to_string(mesh_.triangle_count()) + " triangles, " +
                std::to_string(mesh_.open_edges()) + " border on a hole and " +
                std::to_string(mesh_.inconsistent_edges()) +
                " join faces that are turned differently; close the holes");
    }

    TriangleMesh mesh_;
    mutable std::once_flag distance_is_made_;
    mutable std::unique_ptr<const MeshDistance> distance_;
};

MATPOINT_PLUGIN("stl", "1.0.0") {
    registry.geometry<Stl>("stl");
}
