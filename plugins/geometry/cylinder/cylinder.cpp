#include <matpoint/geometry.hpp>
#include <matpoint/plugin.hpp>

#include <Eigen/Geometry>

#include <cmath>

using namespace matpoint;

/// A circular cylinder or tube along any direction; see README.md.
class Cylinder final : public Geometry {
  public:
    static Schema schema() {
        return Schema("Circular cylinder, or tube, between the centres of its two ends")
            .vector("start", {.unit = "m", .doc = "Centre of one end"})
            .vector("end", {.unit = "m", .doc = "Centre of the other end"})
            .number("radius", {.unit = "m", .doc = "Outer radius", .greater_than = 0})
            .number("inner_radius",
                    {.unit = "m", .doc = "Radius of the bore", .default_value = 0, .at_least = 0})
            .dimensions({3})
            .refuse("/end", "\"end\" must differ from \"start\"",
                    [](const Json& own, const Json&) { return own.at("start") == own.at("end"); })
            .refuse("/inner_radius", "\"inner_radius\" must be less than \"radius\"",
                    [](const Json& own, const Json&) {
                        return own.at("inner_radius").get<double>() >= own.at("radius").get<double>();
                    });
    }
    explicit Cylinder(const Parameters& parameters)
        : start_(Eigen::Vector3d::Map(parameters.vector("start").data())),
          end_(Eigen::Vector3d::Map(parameters.vector("end").data())),
          axis_((end_ - start_).normalized()),
          length_((end_ - start_).norm()),
          radius_(parameters.number("radius")),
          inner_radius_(parameters.number("inner_radius")) {}

    /// A disk with normal n and radius R reaches R sqrt(1 - n_a^2) along axis a.
    Bounds bounds() const override {
        const Eigen::Vector3d reach = radius_ * (1 - axis_.array().square()).max(0).sqrt();
        return {start_.cwiseMin(end_) - reach, start_.cwiseMax(end_) + reach};
    }

    bool contains(const Eigen::Vector3d& point) const override {
        const Eigen::Vector3d from_start = point - start_;
        const double along = axis_.dot(from_start);
        if (along < 0 || along >= length_) return false;
        const double distance = (from_start - along * axis_).norm();
        return distance <= radius_ && distance >= inner_radius_;
    }

  private:
    Eigen::Vector3d start_, end_, axis_;     // m, m, unit vector
    double length_, radius_, inner_radius_;  // m
};

MATPOINT_PLUGIN("cylinder", "1.0.0") {
    registry.geometry<Cylinder>("cylinder");
}
