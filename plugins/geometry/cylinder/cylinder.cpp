#include "../box_distance.hpp"

#include <matpoint/plugin.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

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

    Bounds bounds() const override {
        const Eigen::Vector3d reach = reach_of(radius_);
        return {start_.cwiseMin(end_) - reach, start_.cwiseMax(end_) + reach};
    }

    bool contains(const Eigen::Vector3d& point) const override {
        const Eigen::Vector3d from_start = point - start_;
        const double along = axis_.dot(from_start);
        if (along < 0 || along >= length_) return false;
        const double distance = (from_start - along * axis_).norm();
        return distance <= radius_ && distance >= inner_radius_;
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Interval outer = along_x(lines[i], radius_),
                           bore = inner_radius_ > 0 ? along_x(lines[i], inner_radius_) : nowhere;
            if (!(bore.begin < bore.end)) {
                if (outer.begin < outer.end) found[i] = {outer};
                continue;
            }
            if (outer.begin < bore.begin) found[i].push_back({outer.begin, bore.begin});
            if (bore.end < outer.end) found[i].push_back({bore.end, outer.end});
        }
        return found;
    }

    std::vector<double> breaks(int axis) const override {
        std::vector<double> all;
        for (const double radius : {radius_, inner_radius_})
            for (const Eigen::Vector3d& end : {start_, end_})
                for (const double side : {-1, 1}) all.push_back(end[axis] + side * reach_of(radius)[axis]);
        return all;
    }

    /// In the half plane through the axis its section is a rectangle.
    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        const Eigen::Vector3d from_start = point - start_;
        const double along = axis_.dot(from_start);
        const Eigen::Vector3d across = from_start - along * axis_;
        const double away = across.norm();
        const auto [distance, normal] =
            box_distance({away, along, 0}, {inner_radius_ > 0 ? inner_radius_ : -infinity, 0, 0},
                         {radius_, length_, 0}, 2);
        const Eigen::Vector3d outward = away > 0 ? Eigen::Vector3d(across / away) : axis_.unitOrthogonal();
        return {distance, normal[0] * outward + normal[1] * axis_};
    }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr Interval nowhere{infinity, -infinity};

    /// A disk with normal n and radius R reaches R sqrt(1 - n_a^2) along axis a.
    Eigen::Vector3d reach_of(double radius) const {
        return radius * (1 - axis_.array().square()).max(0).sqrt();
    }

    /// Where a line is in the solid cylinder of a radius; nowhere if it ends before it begins. With u = x -
    /// x_0 and the distance c + a_x u from the start along the axis a, the squared distance from the axis is
    /// u^2 + y^2 + z^2 - (c + a_x u)^2.
    Interval along_x(const Eigen::Vector2d& line, double radius) const {
        const Eigen::Vector2d beside = line - start_.tail<2>();
        const double c = axis_.tail<2>().dot(beside), slope = axis_[0];
        Interval between{-infinity, infinity};
        if (slope != 0) {
            std::tie(between.begin, between.end) = std::minmax({-c / slope, (length_ - c) / slope});
        } else if (c < 0 || c >= length_) {
            return nowhere;
        }
        const double square = 1 - slope * slope, half = slope * c,
                     rest = beside.squaredNorm() - c * c - radius * radius;
        if (square > 0) {
            const double discriminant = half * half - square * rest;
            if (!(discriminant > 0)) return nowhere;
            between.begin = std::max(between.begin, (half - std::sqrt(discriminant)) / square);
            between.end = std::min(between.end, (half + std::sqrt(discriminant)) / square);
        } else if (rest >= 0) {
            return nowhere;
        }
        return {start_[0] + between.begin, start_[0] + between.end};
    }

    Eigen::Vector3d start_, end_, axis_;     // m, m, unit vector
    double length_, radius_, inner_radius_;  // m
};

MATPOINT_PLUGIN("cylinder", "1.0.0") {
    registry.geometry<Cylinder>("cylinder");
}
