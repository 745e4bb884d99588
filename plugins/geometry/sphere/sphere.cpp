#include <matpoint/geometry.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

using namespace matpoint;

/// A ball; see README.md.
class Sphere final : public Geometry {
  public:
    static Schema schema() {
        return Schema("Ball: a disk in 2D, an interval in 1D")
            .vector("center", {.unit = "m", .doc = "Its centre"})
            .number("radius", {.unit = "m", .doc = "Its radius", .greater_than = 0});
    }
    explicit Sphere(const Parameters& parameters)
        : center_(Eigen::Vector3d::Map(parameters.vector("center").data())),
          radius_(parameters.number("radius")) {}

    Bounds bounds() const override { return {center_.array() - radius_, center_.array() + radius_}; }

    bool contains(const Eigen::Vector3d& point) const override {
        return (point - center_).squaredNorm() <= radius_ * radius_;
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double square = radius_ * radius_ - (lines[i] - center_.tail<2>()).squaredNorm();
            if (square > 0) found[i] = {{center_[0] - std::sqrt(square), center_[0] + std::sqrt(square)}};
        }
        return found;
    }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        const Eigen::Vector3d from_center = point - center_;
        const double away = from_center.norm();
        return {away - radius_, away > 0 ? Eigen::Vector3d(from_center / away) : Eigen::Vector3d(1, 0, 0)};
    }

  private:
    Eigen::Vector3d center_;  // m
    double radius_;           // m
};

MATPOINT_PLUGIN("sphere", "1.0.0") {
    registry.geometry<Sphere>("sphere");
}
