#pragma once

#include <matpoint/geometry.hpp>

#include <algorithm>
#include <limits>

namespace matpoint {

/// Of a point from the box between two corners in its first `dimension` coordinates. Sides may be at
/// infinity.
inline SignedDistance box_distance(const Eigen::Vector3d& point, const Eigen::Vector3d& min,
                                   const Eigen::Vector3d& max, int dimension) {
    Eigen::Vector3d beyond = Eigen::Vector3d::Zero(), face = Eigen::Vector3d::Zero();
    double nearest = -std::numeric_limits<double>::infinity();
    for (int a = 0; a < dimension; ++a) {
        const double below = min[a] - point[a], above = point[a] - max[a];
        const double out = std::max(below, above), side = above < below ? -1 : 1;
        if (out > nearest) {
            nearest = out;
            face = side * Eigen::Vector3d::Unit(a);
        }
        beyond[a] = side * std::max(out, 0.0);
    }
    const double distance = beyond.norm();
    if (distance > 0) return {distance, beyond / distance};
    return {nearest, face};
}

}  // namespace matpoint
