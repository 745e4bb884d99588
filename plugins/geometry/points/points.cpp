#include "point_file.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// A user's own particles, from a file; see README.md.
class Points final : public Geometry, public PointCloud {
  public:
    static Schema schema() {
        return Schema("Particles given one by one in a CSV file")
            .add("file", ParameterType::file,
                 {.doc = "Its first line names its columns: x, y, z, volume, and if wanted vx, vy, vz; SI "
                         "units"});
    }
    explicit Points(const Parameters& parameters)
        : table_(read_point_file(parameters.file("file"), parameters.context().space.dimension())),
          bounds_{table_.point(0).position, table_.point(0).position} {
        for (Index k = 1; k < size(); ++k) {
            const Eigen::Vector3d position = table_.point(k).position;
            bounds_.min = bounds_.min.cwiseMin(position);
            bounds_.max = bounds_.max.cwiseMax(position);
        }
    }

    Bounds bounds() const override { return bounds_; }
    /// Single points fill no region.
    bool contains(const Eigen::Vector3d&) const override { return false; }
    const PointCloud* points() const override { return this; }

    Index size() const override { return table_.size(); }
    void read(Index first, std::span<Point> points) const override {
        for (Index k = 0; k < std::ssize(points); ++k)
            points[static_cast<std::size_t>(k)] = table_.point(first + k);
    }

  private:
    PointTable table_;
    Bounds bounds_;
};

MATPOINT_PLUGIN("points", "1.0.0") {
    registry.geometry<Points>("points");
}
