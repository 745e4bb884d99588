#include "../plane_polygon.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// The inside of a closed line of straight edges, in 2D; see README.md.
class Polygon final : public Geometry {
  public:
    static Schema schema() {
        Schema schema("Inside of a closed line of straight edges");
        declare_vertices(schema, "Corners [x, y] in their order around it, either way");
        return schema.dimensions({2});
    }
    explicit Polygon(const Parameters& parameters) : plane_(parameters.json().at("vertices")) {}

    Bounds bounds() const override {
        return {{plane_.min()[0], plane_.min()[1], 0}, {plane_.max()[0], plane_.max()[1], 0}};
    }

    bool contains(const Eigen::Vector3d& point) const override { return plane_.contains(point[0], point[1]); }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) found[i] = plane_.along_u(lines[i][0]);
        return found;
    }

    /// Between its corners a section's length is linear.
    std::vector<double> breaks(int axis) const override {
        return axis < 2 ? plane_.corners(axis) : std::vector<double>{0, 0};
    }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        const auto [distance, normal] = plane_.signed_distance(point.head<2>());
        return {distance, {normal[0], normal[1], 0}};
    }

  private:
    PlanePolygon plane_;
};

MATPOINT_PLUGIN("polygon", "1.0.0") {
    registry.geometry<Polygon>("polygon");
}
