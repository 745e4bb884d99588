#pragma once

#include <matpoint/geometry.hpp>

#include <array>
#include <span>
#include <vector>

namespace matpoint {

/// A surface of triangles, and which points it encloses: those from where a straight line out of the
/// mesh crosses it an odd number of times. Which way faces are turned does not matter.
///
/// If the surface is closed, one line a point tells. If it has holes, lines along x, y and z vote; a
/// line that crosses the surface an odd number of times from end to end went through a hole and
/// abstains.
class TriangleMesh {
  public:
    using Triangle = std::array<Eigen::Vector3d, 3>;
    enum class Verdict : signed char { outside, inside, undecided };

    /// Triangles that have two corners in common are ignored: they enclose nothing.
    explicit TriangleMesh(std::vector<Triangle> triangles);

    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Of each triangle, the numbers of its corners: the same where triangles meet.
    std::vector<std::array<std::size_t, 3>> corner_numbers() const;
    std::size_t triangle_count() const { return triangles_.size(); }
    /// Edges used by an odd number of triangles: borders of holes.
    std::size_t open_edges() const { return open_edges_; }
    /// Edges whose triangles are turned differently.
    std::size_t inconsistent_edges() const { return inconsistent_edges_; }
    const Eigen::Vector3d& min() const { return min_; }
    const Eigen::Vector3d& max() const { return max_; }

    /// Fast for many points that lie on few lines along the axes, as those of a lattice do.
    std::vector<Verdict> classify(std::span<const Eigen::Vector3d> points) const;

    /// What each line along x, at its (y, z), has inside.
    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines) const;
    /// Coordinates along an axis where faces across it cover 1 % of the bounds' section, and of the bounds.
    std::vector<double> flat_faces(int axis) const;

  private:
    void count_edges();
    void keep_inside(std::span<const Eigen::Vector2d> lines, std::vector<Intervals>& parts) const;
    /// The verdict of lines along one axis; undecided where a line abstains.
    std::vector<Verdict> along(int axis, std::span<const Eigen::Vector3d> points) const;

    std::vector<Triangle> triangles_;
    std::size_t open_edges_ = 0, inconsistent_edges_ = 0;
    Eigen::Vector3d min_, max_;
};

}  // namespace matpoint
