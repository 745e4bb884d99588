#include "point_file.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// A user's own particles, from a file; see README.md.
class Points final : public Geometry {
  public:
    static Schema schema() {
        return Schema("Particles given one by one in a CSV file")
            .add("file", ParameterType::file,
                 {.doc = "Its first line names its columns: x, y, z, volume, and if wanted vx, vy, vz; SI "
                         "units"});
    }
    explicit Points(const Parameters& parameters)
        : cloud_(read_point_file(parameters.file("file"), parameters.context().space.dimension())),
          bounds_{cloud_.points[0].position, cloud_.points[0].position} {
        for (const PointCloud::Point& point : cloud_.points) {
            bounds_.min = bounds_.min.cwiseMin(point.position);
            bounds_.max = bounds_.max.cwiseMax(point.position);
        }
    }

    Bounds bounds() const override { return bounds_; }
    /// Single points fill no region.
    bool contains(const Eigen::Vector3d&) const override { return false; }
    const PointCloud* points() const override { return &cloud_; }

  private:
    PointCloud cloud_;
    Bounds bounds_;
};

MATPOINT_PLUGIN("points", "1.0.0") {
    registry.geometry<Points>("points");
}
