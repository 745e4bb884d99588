#pragma once

#include <matpoint/history.hpp>
#include <matpoint/parameters.hpp>

#include <Eigen/Geometry>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace matpoint {

/// How a rigid body moves: not at all, as is prescribed, or freely. A place X of it at the start is at
/// c + R (X - c_0), with its centre c and the rotation R.
class Motion {
  public:
    using Vector = Eigen::Vector3d;

    /// Of the parameter `motion`.
    static Schema schema();
    /// `own`: that parameter, null if it is absent. `anchor`: the centre, if no other is given.
    Motion(const Json* own, const Parameters& tool, const Vector& anchor);

    /// Sets the velocities of the step from `time` on, of length `dt` (s): those which lead to its end, or,
    /// of what moves freely, those without contact.
    void begin_step(double time, double dt);
    /// Gives an impulse (N s) to what moves freely.
    void push(const Vector& place, const Vector& impulse) {
        velocity_ += ease_ * impulse;
        spin_ += turning_ease_ * (place - centre_).cross(impulse);
    }
    void end_step(double dt);

    /// m/s, of the material at a place.
    Vector velocity_at(const Vector& place) const { return velocity_ + spin_.cross(place - centre_); }
    /// What an impulse along a unit vector, at a place, adds to the velocity there along it, 1/kg.
    double ease(const Vector& place, const Vector& along) const {
        return ease_ + turning_ease_ * (place - centre_).cross(along).squaredNorm();
    }
    const Vector& centre() const { return centre_; }
    bool is_free() const { return ease_ > 0; }
    /// From when on it rests, s; infinity if that isn't prescribed.
    double settled_at() const;

    Vector to_start(const Vector& place) const {
        return moves_ ? Vector(start_ + turn_.conjugate() * (place - centre_)) : place;
    }
    Vector from_start(const Vector& direction) const { return moves_ ? turn_ * direction : direction; }

    std::map<std::string, double> state() const;
    void restore(const std::map<std::string, double>& state);

  private:
    Vector mean(const std::vector<std::optional<Profile>>& rate, double time, double dt) const;
    Vector place_at(double time) const;

    bool moves_ = false;
    Vector start_, centre_;  ///< m
    Eigen::Quaterniond turn_ = Eigen::Quaterniond::Identity();
    Vector velocity_ = Vector::Zero(), spin_ = Vector::Zero();  ///< m/s, rad/s
    double ease_ = 0, turning_ease_ = 0;                        ///< 1/kg, 1/(kg m^2); 0: prescribed
    std::vector<std::optional<Profile>> velocities_, positions_;
    std::optional<Profile> rotation_;
    Vector axis_ = Vector::UnitZ();
    std::vector<std::pair<Vector, History>> gravity_;  ///< m/s^2, and its factor in time
};

}  // namespace matpoint
