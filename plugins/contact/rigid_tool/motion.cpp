#include "motion.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace matpoint {

namespace {

bool given(const Json& own, const char* key) {
    return own.contains(key) && !own.at(key).is_null();
}

std::vector<std::optional<Profile>> profiles(const Json& own, const char* key) {
    std::vector<std::optional<Profile>> all;
    if (given(own, key))
        for (const Json& component : own.at(key))
            all.push_back(component.is_null() ? std::nullopt : std::optional<Profile>(component));
    return all;
}

Eigen::Vector3d vector(const Json& own, const char* key) {
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (std::size_t a = 0; a < own.at(key).size(); ++a)
        v[static_cast<Eigen::Index>(a)] = own.at(key)[a].get<double>();
    return v;
}

Eigen::Vector3d values(const std::vector<std::optional<Profile>>& of, double time) {
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (std::size_t a = 0; a < of.size(); ++a)
        if (of[a]) v[static_cast<Eigen::Index>(a)] = (*of[a])({0, 0, 0}, time);
    return v;
}

/// Mean of a profile over a step, by Simpson's rule: exact for cubic ones.
double mean_of(const Profile& rate, double time, double dt) {
    const std::array<double, 3> here{};
    return (rate(here, time) + 4 * rate(here, time + dt / 2) + rate(here, time + dt)) / 6;
}

}  // namespace

Schema Motion::schema() {
    Schema schema(
        "How a tool moves: as `velocity` or `position` and `rotation` prescribe or, if it has a `mass`, "
        "freely");
    schema
        .add("velocity", ParameterType::profiles,
             {.unit = "m/s",
              .doc = "Its velocity; if it moves freely, that at the start",
              .optional = true,
              .variables = "t"})
        .add("position", ParameterType::profiles,
             {.unit = "m",
              .doc = "Where its centre is, in place of `velocity`",
              .optional = true,
              .variables = "t"})
        .profile("rotation", {.unit = "1/s",
                              .doc = "Angular velocity (rad/s); if it moves freely, that at the start",
                              .optional = true,
                              .variables = "t"})
        .vector("axis",
                {.doc = "In 3D: direction of the axis of `rotation`; in 2D it is z", .optional = true})
        .vector("pivot", {.unit = "m",
                          .doc = "Its centre at the start, about which it turns and which moves with it; the "
                                 "middle of its geometry, or its tip, by default",
                          .optional = true})
        .number("mass", {.unit = "kg",
                         .doc = "Mass of a tool that moves freely, by gravity and contact (per metre in 2D)",
                         .optional = true,
                         .greater_than = 0})
        .number("inertia",
                {.unit = "kg m^2",
                 .doc = "Its moment of inertia about its centre, in 3D that about every axis; without "
                        "one it does not turn",
                 .optional = true,
                 .greater_than = 0});
    const auto mode = [](const Json& scene) { return scene.at("space").at("mode").get<std::string>(); };
    schema
        .refuse("/position", "give `velocity` or `position`, not both",
                [](const Json& own, const Json&) { return given(own, "position") && given(own, "velocity"); })
        .refuse("/position", "what has a `mass` moves freely: give its `velocity` at the start",
                [](const Json& own, const Json&) { return given(own, "position") && given(own, "mass"); })
        .refuse("/inertia", "belongs to a tool with a `mass`",
                [](const Json& own, const Json&) { return given(own, "inertia") && !given(own, "mass"); })
        .refuse("/inertia", "in 1D and axisymmetric spaces nothing turns: leave it out",
                [mode](const Json& own, const Json& scene) {
                    return given(own, "inertia") && (mode(scene) == "bar" || mode(scene) == "axisymmetric");
                })
        .refuse("/rotation", "in 1D and axisymmetric spaces nothing turns: leave it out",
                [mode](const Json& own, const Json& scene) {
                    return given(own, "rotation") && (mode(scene) == "bar" || mode(scene) == "axisymmetric");
                })
        .refuse("/rotation", "a tool with a `mass` turns if it has an `inertia`",
                [](const Json& own, const Json&) {
                    return given(own, "rotation") && given(own, "mass") && !given(own, "inertia");
                })
        .refuse("/axis", "in 3D a `rotation` needs the direction of its `axis`",
                [mode](const Json& own, const Json& scene) {
                    return mode(scene) == "solid" && given(own, "rotation") &&
                           (!given(own, "axis") || vector(own, "axis").isZero(0));
                })
        .refuse("/axis", "in 2D a `rotation` is about z: leave it out",
                [mode](const Json& own, const Json& scene) {
                    return mode(scene) != "solid" && given(own, "axis");
                })
        .refuse("/velocity", "x is the radius, along which a ring can't move: 0 for that component",
                [mode](const Json& own, const Json& scene) {
                    return mode(scene) == "axisymmetric" && given(own, "velocity") &&
                           own.at("velocity")[0] != 0 && !own.at("velocity")[0].is_null();
                });
    return schema;
}

Motion::Motion(const Json* own, const Parameters& tool, const Vector& anchor)
    : start_(anchor), centre_(anchor) {
    if (!own) return;
    moves_ = true;
    if (given(*own, "pivot")) start_ = centre_ = vector(*own, "pivot");
    velocities_ = profiles(*own, "velocity");
    positions_ = profiles(*own, "position");
    if (given(*own, "rotation")) rotation_ = Profile(own->at("rotation"));
    if (given(*own, "axis")) axis_ = vector(*own, "axis").normalized();
    if (!positions_.empty()) centre_ = place_at(0);
    if (!given(*own, "mass")) return;
    ease_ = 1 / own->at("mass").get<double>();
    if (given(*own, "inertia")) turning_ease_ = 1 / own->at("inertia").get<double>();
    velocity_ = values(velocities_, 0);
    if (rotation_) spin_ = (*rotation_)({0, 0, 0}, 0) * axis_;
    for (const Json& load : tool.context().scene->at("loads"))
        if (load.at("type") == "gravity")
            gravity_.emplace_back(vector(load, "acceleration"), History(load.at("history")));
}

Motion::Vector Motion::mean(const std::vector<std::optional<Profile>>& rate, double time, double dt) const {
    Vector v = Vector::Zero();
    for (std::size_t a = 0; a < rate.size(); ++a)
        if (rate[a]) v[static_cast<Eigen::Index>(a)] = mean_of(*rate[a], time, dt);
    return v;
}

Motion::Vector Motion::place_at(double time) const {
    Vector place = start_;
    for (std::size_t a = 0; a < positions_.size(); ++a)
        if (positions_[a]) place[static_cast<Eigen::Index>(a)] = (*positions_[a])({0, 0, 0}, time);
    return place;
}

double Motion::settled_at() const {
    if (is_free()) return std::numeric_limits<double>::infinity();
    double time = rotation_ ? rotation_->zero_from() : 0;
    for (const auto& velocity : velocities_)
        if (velocity) time = std::max(time, velocity->zero_from());
    for (const auto& position : positions_)
        if (position) time = std::max(time, position->settled_at());
    return time;
}

void Motion::begin_step(double time, double dt) {
    if (is_free()) {
        for (const auto& [acceleration, factor] : gravity_) velocity_ += factor(time) * dt * acceleration;
        return;
    }
    velocity_ =
        positions_.empty() ? mean(velocities_, time, dt) : Vector((place_at(time + dt) - centre_) / dt);
    if (rotation_) spin_ = mean_of(*rotation_, time, dt) * axis_;
}

void Motion::end_step(double dt) {
    if (!moves_) return;
    centre_ += dt * velocity_;
    const double angle = dt * spin_.norm();
    if (angle > 0)
        turn_ = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, spin_.normalized())) * turn_).normalized();
}

std::map<std::string, double> Motion::state() const {
    std::map<std::string, double> state;
    for (int a = 0; a < 3; ++a) {
        const std::string axis(1, "xyz"[a]);
        state["centre_" + axis] = centre_[a];
        state["velocity_" + axis] = velocity_[a];
        state["spin_" + axis] = spin_[a];
    }
    for (int k = 0; k < 4; ++k) state["turn_" + std::to_string(k)] = turn_.coeffs()[k];
    return state;
}

void Motion::restore(const std::map<std::string, double>& state) {
    for (int a = 0; a < 3; ++a) {
        const std::string axis(1, "xyz"[a]);
        centre_[a] = state.at("centre_" + axis);
        velocity_[a] = state.at("velocity_" + axis);
        spin_[a] = state.at("spin_" + axis);
    }
    for (int k = 0; k < 4; ++k) turn_.coeffs()[k] = state.at("turn_" + std::to_string(k));
}

}  // namespace matpoint
