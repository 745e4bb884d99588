#pragma once

#include <matpoint/material.hpp>
#include <matpoint/particle_pack.hpp>

#include <cmath>
#include <concepts>
#include <limits>

namespace matpoint {

/// A material given by what happens at one particle; several are treated at once, a Pack of them in the place
/// of a number. `Law` is the class that derives from this one:
///
///     template <class S>
///     class Law final : public PointwiseMaterial<S, Law<S>> {
///         template <class Point>
///         MATPOINT_INLINE auto squared_wave_speed(const Point& p) const;  // m^2/s^2, not below 0
///         template <class Point>
///         MATPOINT_INLINE auto update(const Point& p, Real dt) const;  // sets the stress; returns the same
///     };
///
/// What `update` shares with `squared_wave_speed` is computed once if that is called before set_stress.
/// Both are plain arithmetic on p.deformation_gradient(), p.stress() … and typename Point::Number; instead of
/// `if`, `select(condition, a, b)`. In single precision a strain of 1e-7 is lost beside the 1 of F: what is
/// formed from p.displacement_gradient(), F - I, keeps it (volume_change, log1p, squared_strain).
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

    /// Whether Law has what this class calls; what it lacks is told in a sentence.
    static consteval bool is_complete() {
        using Point = ParticlePack<S, true>;
        constexpr bool has_speed = requires(const Law& law, const Point& p) {
            { law.squared_wave_speed(p) } -> std::convertible_to<Number>;
        };
        static_assert(has_speed,
                      "a pointwise material has a function `template <class Point> auto "
                      "squared_wave_speed(const Point& p) const`, which returns a number, in m^2/s^2");
        if constexpr (has_speed) {
            constexpr bool has_update = requires(const Law& law, const Point& p, Real dt) {
                { law.update(p, dt) } -> std::convertible_to<Number>;
            };
            static_assert(has_update,
                          "a pointwise material has a function `template <class Point> auto "
                          "update(const Point& p, Real dt) const`, which sets the stress and returns the "
                          "squared wave speed");
            return has_update;
        }
        return false;
    }

  private:
    using Number = Pack<Real>;

    const Law& law() const { return static_cast<const Law&>(*this); }
    /// Not a number if the square of some particle is negative or not a number itself.
    template <class Square>
    static Real fastest(const Batch& batch, const Square& square) {
        Number largest_square(0);
        auto sound = largest_square >= Number(0);
        visit_packs(batch, [&](const auto& p) {
            const Number own = square(p);
            sound = sound && own >= Number(0);
            largest_square = max(own, largest_square);
        });
        if (__builtin_expect(any(!sound), 0)) return std::numeric_limits<Real>::quiet_NaN();
        return std::sqrt(largest(largest_square));
    }
};

}  // namespace matpoint
