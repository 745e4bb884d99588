#include "point_file.hpp"

#include <matpoint/plugin.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

using namespace matpoint;

/// A user's own particles, from a file; see README.md.
class Points final : public Geometry, public PointCloud {
  public:
    static Schema schema() {
        return Schema("Particles given one by one in a CSV file")
            .add("file", ParameterType::file,
                 {.doc = "Its first line names its columns: x, y, z, volume, and if wanted vx, vy, vz, and "
                         "edges dx, dy, dz; SI units"});
    }
    explicit Points(const Parameters& parameters)
        : table_(read_point_file(parameters.file("file"), parameters.context().space.dimension())),
          bounds_{table_.point(0).position, table_.point(0).position} {
        for (Index k = 1; k < size(); ++k) {
            const Eigen::Vector3d position = table_.point(k).position;
            bounds_.min = bounds_.min.cwiseMin(position);
            bounds_.max = bounds_.max.cwiseMax(position);
        }
        check_domains(parameters.context().space);
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
    /// Area and mass are to belong together.
    void check_domains(const SpaceId& space) const {
        for (Index k = 0; k < size(); ++k) {
            const Point point = table_.point(k);
            if (!point.half_size) return;
            const double width =
                             space.mode == Mode::axisymmetric ? 2 * std::numbers::pi * point.position[0] : 1,
                         product = (2 * *point.half_size).head(space.dimension()).prod() * width;
            if (std::abs(product - point.volume) > 1e-3 * point.volume)
                throw std::invalid_argument("point " + std::to_string(k + 1) + " has volume " +
                                            std::to_string(point.volume) + ", but its edges make " +
                                            std::to_string(product));
        }
    }

    PointTable table_;
    Bounds bounds_;
};

MATPOINT_PLUGIN("points", "1.0.0") {
    registry.geometry<Points>("points");
}
