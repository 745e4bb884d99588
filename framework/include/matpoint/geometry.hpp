#pragma once

#include <matpoint/columns.hpp>
#include <matpoint/registry.hpp>

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace matpoint {

/// Particles given one by one, and handed out a part at a time, so that a geometry need not keep them all.
class PointCloud {
  public:
    struct Point {
        Eigen::Vector3d position;
        double volume;             ///< m^3 (m^2 in plane strain, m in 1D)
        Eigen::Vector3d velocity;  ///< m/s, added to the body's
        /// Half-lengths of its domain, m; by default those of a square or cube of its volume.
        std::optional<Eigen::Vector3d> half_size{};
    };

    virtual ~PointCloud() = default;
    virtual Index size() const = 0;
    /// Sets `points` to point `first` and those that follow it. Called from several threads.
    virtual void read(Index first, std::span<Point> points) const = 0;
};

/// What lies between two coordinates on a line, m.
struct Interval {
    double begin, end;
};
using Intervals = std::vector<Interval>;

/// Where a point is from a surface.
struct SignedDistance {
    double distance;         ///< m, negative inside
    Eigen::Vector3d normal;  ///< its gradient: a unit vector that points outwards
};

/// A region of space; coordinates that the scene's space lacks are zero.
class Geometry : public Component {
  public:
    struct Bounds {
        Eigen::Vector3d min, max;
    };
    virtual Bounds bounds() const = 0;
    virtual bool contains(const Eigen::Vector3d& point) const = 0;
    /// The same for many points; geometries that can do better than one by one override it.
    virtual std::vector<char> contains(std::span<const Eigen::Vector3d> points) const {
        std::vector<char> inside(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) inside[i] = contains(points[i]) ? 1 : 0;
        return inside;
    }
    /// Of lines along x, each at its (y, z): what of `within` lies in the region, in ascending order without
    /// overlaps. It may tell of more than `within`. From this a body has its volume. By default it is
    /// searched for by contains(), so that what is thinner than `step` may be missed; override it where
    /// the places at which a line meets the surface are known.
    virtual std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval within,
                                           double step) const;
    /// Coordinates along an axis at which the section across it may change at once: flat faces, poles.
    virtual std::vector<double> breaks(int axis) const { return {bounds().min[axis], bounds().max[axis]}; }
    /// Set if the geometry is a list of particles rather than a region to fill.
    virtual const PointCloud* points() const { return nullptr; }
    /// Distance from the surface, by which a rigid tool has its contact. It may fall short where surfaces of
    /// operands were combined, but changes by no more than a point moves. By default it throws
    /// std::invalid_argument: single points have no surface. Called from several threads.
    virtual SignedDistance signed_distance(const Eigen::Vector3d& point) const;
    /// What stands for where it is, m.
    virtual Eigen::Vector3d anchor() const { return (bounds().min + bounds().max) / 2; }
};

}  // namespace matpoint
