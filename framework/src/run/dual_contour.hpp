#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/surface_mesh.hpp>

#include <Eigen/Core>

#include <array>
#include <functional>

namespace matpoint {

/// A lattice of cells along the first `dimension` axes.
struct Lattice {
    int dimension;
    Eigen::Vector3d min;       ///< m
    double spacing;            ///< m
    std::array<int, 3> nodes;  ///< along each axis, 1 along those that are not there
};

/// Where `distance` is 0 on a lattice: one point in each cell that the surface goes through, so that edges
/// and corners stay sharp, and a face across each of the lattice's edges that it cuts. [Ju, Losasso, Schaefer
/// & Warren 2002, Dual contouring of Hermite data, ACM Transactions on Graphics 21]
SurfaceMesh dual_contour(const Lattice& lattice,
                         const std::function<SignedDistance(const Eigen::Vector3d&)>& distance);

}  // namespace matpoint
