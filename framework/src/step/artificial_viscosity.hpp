#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace matpoint {

/// The pressure q (Pa) that a body under compression has beside its stress, so that shocks are spread over a
/// few cells. With D = tr L (1/s), h the size of a cell (m), c the speed of sound (m/s):
///
///     landshoff       q = rho (c1 c h |D| + c2 h^2 D^2)                  [von Neumann & Richtmyer 1950;
///                                                                         Landshoff 1955]
///     chen_brannon    q = sqrt(c^2 g rho lambda |D|) (c1 + c2 |D| / max |D|)   [Chen & Brannon 2002, eq.
///     2-1]
///
/// where D < 0. In eq. 2-1, whose units are a pressure's if g is a time, g = h / c and lambda = rho c^2, if
/// it isn't given.
struct ArtificialViscosity {
    enum class Form { landshoff, chen_brannon } form = Form::landshoff;
    double linear = 0, quadratic = 0;      ///< c1, c2
    std::optional<double> bulk_modulus{};  ///< lambda, Pa
    double length = 0;                     ///< h, m

    struct State {
        double density, wave_speed;  ///< rho, kg/m^3; c, m/s
        double compression;          ///< |D|, 1/s
        double largest;              ///< max |D| of the step before, 1/s
    };
    double pressure(const State& s) const {
        if (!(s.compression > 0)) return 0;
        if (form == Form::landshoff)
            return s.density * length * s.compression *
                   (linear * s.wave_speed + quadratic * length * s.compression);
        const double lambda = bulk_modulus.value_or(s.density * s.wave_speed * s.wave_speed);
        return std::sqrt(s.wave_speed * length * s.density * lambda * s.compression) *
               (linear + quadratic * s.compression / std::max(s.largest, s.compression));
    }
    /// Speed (m/s) that takes the place of c in the limit of the time step: Q + sqrt(Q^2 + c^2) with Q = q /
    /// (rho h |D|), which is h / dt at the limit of central differences with damping that lags behind by half
    /// a step.
    double speed(const State& s, double pressure) const {
        if (!(pressure > 0)) return s.wave_speed;
        const double q = pressure / (s.density * length * std::max(s.largest, s.compression));
        return q + std::sqrt(q * q + s.wave_speed * s.wave_speed);
    }
};

}  // namespace matpoint
