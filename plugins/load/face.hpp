#pragma once

#include <matpoint/particles.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace matpoint {

/// One side of a body ("x_max"), seen from its particles.
template <class S>
class Face {
  public:
    using Real = typename S::Real;
    using Position = typename S::Position;

    explicit Face(const std::string& name) : axis_(name[0] - 'x'), sign_(name.ends_with("max") ? 1 : -1) {}

    int axis() const { return axis_; }
    /// Outward along the axis, 1 or -1.
    double sign() const { return sign_; }

    /// Coordinate of the outermost side of any particle's domain, m.
    double plane(const Particles<S>& particles) const {
        double outermost = -std::numeric_limits<double>::max();
        for (Index p = 0; p < particles.size(); ++p)
            outermost = std::max(outermost, sign_ * side(particles, p));
        return sign_ * outermost;
    }

    /// From this side of the body to the opposite one, m.
    double depth(const Particles<S>& particles) const {
        Face opposite(*this);
        opposite.sign_ = -sign_;
        return std::abs(plane(particles) - opposite.plane(particles));
    }

    /// A particle's share of the face's area, m^2: the product of its sizes along the other axes (times
    /// the plane's part of a ring, when axisymmetric), times the part of a layer of `thickness` below
    /// the plane that the particle fills. Thickness 0: all of it, for particles that touch the plane.
    double initial_area(const Particles<S>& particles, Index p, double plane, double thickness) const {
        const double size = 2 * half_size(particles, p, axis_);
        const double gap = sign_ * (plane - side(particles, p));
        double area = 1;
        if (thickness > 0)
            area = std::clamp(thickness - gap, 0.0, size) / thickness;
        else if (gap > size / 2)
            area = 0;
        for (int a = 0; a < S::dimension; ++a)
            if (a != axis_) area *= 2 * half_size(particles, p, a);
        if constexpr (S::axisymmetric) {
            const double radius = axis_ == 0 ? plane : particles.value(Field::position, 0, p);
            area *= 2 * std::numbers::pi * radius;
        }
        return area;
    }

    /// Present over initial area, |J F^-T N|, from the columns of F that span the face; in 1D, where the
    /// bar's area stays, 1.
    Real area_stretch(const Particles<S>& particles, Index p) const {
        if constexpr (S::dimension == 1) return 1;
        const Tensor<S> f = ParticleBatch<S>::load_deformation_gradient(particles, p);
        if constexpr (S::dimension == 2) return f.plane.col(1 - axis_).norm() * f.normal;
        if constexpr (S::dimension == 3)
            return f.plane.col((axis_ + 1) % 3).cross(f.plane.col((axis_ + 2) % 3)).norm();
        return 1;
    }

    /// x_p + d: the vector d from the particle to the boundary is half its size at the start, F d after.
    Position surface_point(const Particles<S>& particles, Index p) const {
        Position direction = Position::Unit(axis_);
        if (particles.has(Field::displacement_gradient))
            direction += ParticleBatch<S>::load_displacement_gradient(particles, p)
                             .plane.col(axis_)
                             .template cast<double>();
        return particles.position(p) + sign_ * half_size(particles, p, axis_) * direction;
    }

  private:
    static double half_size(const Particles<S>& particles, Index p, int axis) {
        return static_cast<double>(particles.column(Field::initial_half_size, axis)[p]);
    }
    double side(const Particles<S>& particles, Index p) const {
        return particles.value(Field::position, axis_, p) + sign_ * half_size(particles, p, axis_);
    }

    int axis_;
    double sign_;
};

}  // namespace matpoint
