#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/plugin.hpp>

/// The smallest geometry there is: the origin.
class Point final : public matpoint::Geometry {
  public:
    static matpoint::Schema schema() { return matpoint::Schema("The origin"); }
    explicit Point(const matpoint::Parameters&) {}
    Bounds bounds() const override { return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}; }
    bool contains(const Eigen::Vector3d& point) const override { return point.isZero(); }
};
