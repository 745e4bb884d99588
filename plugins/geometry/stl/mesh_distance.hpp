#pragma once

#include "triangle_mesh.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace matpoint {

/// Distance from the nearest triangle of a mesh, found in a tree of boxes around them.
///
/// Where the nearest point is within a triangle, its normal tells the side; on an edge or a corner, where the
/// triangles around may disagree, their normals weighted by their angles there do
/// [Baerentzen & Aanaes 2005, Signed distance computation using the angle weighted pseudonormal].
class MeshDistance {
  public:
    explicit MeshDistance(const TriangleMesh& mesh);

    SignedDistance operator()(const Eigen::Vector3d& point) const;

  private:
    struct Face {
        TriangleMesh::Triangle corners;
        Eigen::Vector3d normal;
        /// Pseudonormals: of the edges from corner i to the next, and of the corners.
        std::array<Eigen::Vector3d, 3> at_edge, at_corner;
    };
    /// A box and, in a leaf, its faces; else the branches are the next node and `second`.
    struct Branch {
        Eigen::AlignedBox3d box;
        std::uint32_t begin, end, second;
    };

    void set_pseudonormals(const TriangleMesh& mesh, const std::vector<std::size_t>& sources);
    std::uint32_t grow(std::uint32_t begin, std::uint32_t end);

    std::vector<Face> faces_;
    std::vector<Branch> tree_;
};

}  // namespace matpoint
