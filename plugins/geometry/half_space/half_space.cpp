#include "../unbounded.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// All that is on one side of a plane; see README.md.
class HalfSpace final : public Unbounded {
  public:
    static Schema schema() {
        Schema schema("All that is on one side of a plane: a half plane in 2D, a half line in 1D");
        schema.vector("point", {.unit = "m", .doc = "A point of the plane"});
        return declare_direction(schema, "normal", "Across the plane, out of the half space; of any length");
    }
    explicit HalfSpace(const Parameters& parameters)
        : point_(Eigen::Vector3d::Map(parameters.vector("point").data())),
          normal_(Eigen::Vector3d::Map(parameters.vector("normal").data()).normalized()) {}

    Eigen::Vector3d anchor() const override { return point_; }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        return {normal_.dot(point - point_), normal_};
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Interval part = behind_plane(lines[i], point_, normal_);
            if (part.begin < part.end) found[i] = {part};
        }
        return found;
    }

  private:
    Eigen::Vector3d point_, normal_;  // m, unit vector
};

MATPOINT_PLUGIN("half_space", "1.0.0") {
    registry.geometry<HalfSpace>("half_space");
}
