#pragma once

#include <Eigen/Core>

#include <cmath>

namespace matpoint {

/// Matter in a place's part of its cell, or near it: its volume and moments about the part's middle, in units
/// of the part's edges. The moments tell where it is and how far it reaches along each axis.
struct Filling {
    double volume = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Vector3d second = Eigen::Vector3d::Zero();

    static Filling whole() { return {1, Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(1.0 / 12)}; }

    /// Adds a share of other matter, whose middle is `shift` away.
    void add(const Filling& other, double share, const Eigen::Vector3d& shift) {
        volume += share * other.volume;
        first += share * (other.first + other.volume * shift);
        second += share * (other.second + (2 * other.first + other.volume * shift).cwiseProduct(shift));
    }

    Eigen::Vector3d centroid() const { return first / volume; }

    /// Edges of a box along the axes of this volume, in proportion as the matter reaches along them: the
    /// second moment of a box of unit volume and edge e is e^2 / 12. Of a box these are its own.
    Eigen::Vector3d edges(int dimension) const {
        const Eigen::Array3d variance = second.array() / volume - centroid().array().square();
        Eigen::Vector3d reach = (12 * variance).max(0).sqrt().matrix();
        const double product = reach.head(dimension).prod();
        reach.head(dimension) *= std::pow(volume / product, 1.0 / dimension);
        return reach;
    }
};

}  // namespace matpoint
