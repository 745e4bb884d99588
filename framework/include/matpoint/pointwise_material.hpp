#pragma once

#include <matpoint/material.hpp>
#include <matpoint/particle_pack.hpp>

#include <cmath>

namespace matpoint {

/// A material given by what happens at one particle; several are treated at once, a Pack of them in the place
/// of a number. `Law` is the class that derives from this one:
///
///     template <class S>
///     class Law final : public PointwiseMaterial<S, Law<S>> {
///         template <class Point>
///         MATPOINT_INLINE auto squared_wave_speed(const Point& p) const;  // m^2/s^2
///         template <class Point>
///         MATPOINT_INLINE auto update(const Point& p, Real dt) const;  // sets the stress; returns the same
///     };
///
/// What `update` shares with `squared_wave_speed` is computed once if that is called before set_stress.
/// Both are plain arithmetic on p.deformation_gradient(), p.stress() … and typename Point::Number; instead of
/// `if`, `select(condition, a, b)`.
template <class S, class Law>
class PointwiseMaterial : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;
    using Material<S>::Material;

    void update_stress(const Batch& batch, Real dt) const final { update(batch, dt); }
    Real wave_speed(const Batch& batch) const final {
        return fastest(batch, [&](const auto& p) { return law().squared_wave_speed(p); });
    }
    MATPOINT_FLATTEN Real update(const Batch& batch, Real dt) const final {
        return fastest(batch, [&](const auto& p) { return law().update(p, dt); });
    }

  private:
    using Number = Pack<Real>;

    const Law& law() const { return static_cast<const Law&>(*this); }
    template <class Square>
    static Real fastest(const Batch& batch, const Square& square) {
        Number largest_square(0);
        visit_packs(batch, [&](const auto& p) {
            largest_square = max(square(p), largest_square);  // not what is no number
        });
        return std::sqrt(largest(largest_square));
    }
};

}  // namespace matpoint
