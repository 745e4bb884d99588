#pragma once

#include <matpoint/geometry.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace matpoint {

/// A region that goes on for ever.
class Unbounded : public Geometry {
  public:
    Bounds bounds() const override {
        return {Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity)};
    }
    std::vector<double> breaks(int) const override { return {}; }
    bool contains(const Eigen::Vector3d& point) const override {
        return signed_distance(point).distance <= 0;
    }

    using Geometry::contains;

  protected:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Of each line along x, what is on the inner side of the plane through a point, with a normal that
    /// points outwards.
    static Interval behind_plane(const Eigen::Vector2d& line, const Eigen::Vector3d& point,
                                 const Eigen::Vector3d& normal) {
        const double beside = normal.tail<2>().dot(line - point.tail<2>());
        if (normal[0] == 0) return beside <= 0 ? Interval{-infinity, infinity} : Interval{0, 0};
        const double at = point[0] - beside / normal[0];
        return normal[0] > 0 ? Interval{-infinity, at} : Interval{at, infinity};
    }
};

/// Declares a vector that says a direction alone.
inline Schema& declare_direction(Schema& schema, const std::string& name, std::string doc) {
    return schema.vector(name, {.doc = std::move(doc)})
        .refuse("/" + name, "\"" + name + "\" must have a length", [name](const Json& own, const Json&) {
            for (const Json& component : own.at(name))
                if (component != 0) return false;
            return true;
        });
}

/// What wedge and cone share: their tip, opening and direction.
inline Schema& declare_tip(Schema& schema) {
    schema.vector("tip", {.unit = "m", .doc = "Where it begins"})
        .number("half_angle",
                {.doc = "Between its axis and its side, in degrees", .greater_than = 0, .less_than = 90});
    return declare_direction(schema, "direction", "Along its axis, from the tip into it; of any length");
}

/// In the half plane through the axis of a wedge or cone, at a place along the axis and away from it:
/// distance from its side and the gradient's components along and away.
struct FromSide {
    double distance, along, away;
};
class TipProfile {
  public:
    /// Half the opening, degrees.
    explicit TipProfile(double half_angle)
        : cosine_(std::cos(half_angle * degree)), sine_(std::sin(half_angle * degree)) {}

    FromSide operator()(double along, double away) const {
        const double on_side = cosine_ * along + sine_ * away;
        if (on_side >= 0) return {cosine_ * away - sine_ * along, -sine_, cosine_};
        const double distance = std::hypot(along, away);
        return {distance, along / distance, away / distance};
    }
    double cosine() const { return cosine_; }
    double sine() const { return sine_; }

  private:
    static constexpr double degree = 0.017453292519943295;  // rad
    double cosine_, sine_;
};

}  // namespace matpoint
