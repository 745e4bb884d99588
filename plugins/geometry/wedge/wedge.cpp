#include "../unbounded.hpp"

#include <matpoint/plugin.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <stdexcept>

using namespace matpoint;

/// The room between two half planes that meet in an edge; see README.md.
class Wedge final : public Unbounded {
  public:
    static Schema schema() {
        Schema schema("Wedge without end, between two planes that meet in its tip");
        declare_tip(schema);
        const auto is_solid = [](const Json& scene) { return scene.at("space").at("dimension") == 3; };
        return schema
            .vector("edge", {.doc = "In 3D: direction of the edge in which the planes meet; in 2D it is z",
                             .optional = true})
            .dimensions({2, 3})
            .refuse("/edge", "in 3D a wedge needs the direction of its \"edge\"",
                    [is_solid](const Json& own, const Json& scene) {
                        return is_solid(scene) && !own.contains("edge");
                    })
            .refuse("/edge", "in 2D a wedge's edge is along z: leave it out",
                    [is_solid](const Json& own, const Json& scene) {
                        return !is_solid(scene) && own.contains("edge");
                    });
    }
    explicit Wedge(const Parameters& parameters)
        : tip_(Eigen::Vector3d::Map(parameters.vector("tip").data())),
          axis_(Eigen::Vector3d::Map(parameters.vector("direction").data()).normalized()),
          profile_(parameters.number("half_angle")) {
        Eigen::Vector3d edge = Eigen::Vector3d::UnitZ();
        if (parameters.has("edge")) edge = Eigen::Vector3d::Map(parameters.vector("edge").data());
        across_ = edge.cross(axis_);
        if (std::abs(edge.dot(axis_)) > 1e-9 * edge.norm() || across_.isZero(0))
            throw std::invalid_argument("\"edge\" must be at right angles to \"direction\"");
        across_.normalize();
    }

    Eigen::Vector3d anchor() const override { return tip_; }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        const Eigen::Vector3d from_tip = point - tip_;
        const double across = across_.dot(from_tip);
        const FromSide side = profile_(axis_.dot(from_tip), std::abs(across));
        return {side.distance, side.along * axis_ + std::copysign(side.away, across) * across_};
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            Interval part{-infinity, infinity};
            for (const double side : {-1, 1}) {
                const Interval one = behind_plane(
                    lines[i], tip_, side * profile_.cosine() * across_ - profile_.sine() * axis_);
                part = {std::max(part.begin, one.begin), std::min(part.end, one.end)};
            }
            if (part.begin < part.end) found[i] = {part};
        }
        return found;
    }

    std::vector<double> breaks(int axis) const override { return {tip_[axis]}; }

  private:
    Eigen::Vector3d tip_, axis_, across_;  // m, unit vectors
    TipProfile profile_;
};

MATPOINT_PLUGIN("wedge", "1.0.0") {
    registry.geometry<Wedge>("wedge");
}
