#include "../unbounded.hpp"

#include <matpoint/plugin.hpp>

#include <Eigen/Geometry>

using namespace matpoint;

/// A circular cone without end; see README.md.
class Cone final : public Unbounded {
  public:
    static Schema schema() {
        Schema schema("Circular cone without end");
        return declare_tip(schema).dimensions({3});
    }
    explicit Cone(const Parameters& parameters)
        : tip_(Eigen::Vector3d::Map(parameters.vector("tip").data())),
          axis_(Eigen::Vector3d::Map(parameters.vector("direction").data()).normalized()),
          profile_(parameters.number("half_angle")) {}

    Eigen::Vector3d anchor() const override { return tip_; }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        const Eigen::Vector3d from_tip = point - tip_;
        const double along = axis_.dot(from_tip);
        const Eigen::Vector3d across = from_tip - along * axis_;
        const double away = across.norm();
        const FromSide side = profile_(along, away);
        const Eigen::Vector3d outward = away > 0 ? Eigen::Vector3d(across / away) : axis_.unitOrthogonal();
        return {side.distance, side.along * axis_ + side.away * outward};
    }

    std::vector<double> breaks(int axis) const override { return {tip_[axis]}; }

  private:
    Eigen::Vector3d tip_, axis_;  // m, unit vector
    TipProfile profile_;
};

MATPOINT_PLUGIN("cone", "1.0.0") {
    registry.geometry<Cone>("cone");
}
