#include <matpoint/spline.hpp>

#include <algorithm>
#include <cmath>

namespace matpoint {

Spline::Spline(int degree)
    : degree_(degree),
      reach_((degree + 1) / 2.0),
      scale_(degree == 3   ? 1.0 / 6
             : degree == 2 ? 0.5
                           : 1) {}

/// N(x) = sum_k (-1)^k C(p + 1, k) (x + r - k)_+^p / p!, of which only the part x <= 0 is taken, where
/// nothing large cancels: N is even, xi N(xi) odd.
Spline::Values Spline::at(double x) const {
    const double s = -std::abs(x);
    double value = 0, once = 0, twice = 0;  // N, its integral, and the integral of that
    double factor = scale_;
    for (int k = 0; k <= degree_; ++k) {
        const double t = s + reach_ - k;
        if (t <= 0) break;
        double power = factor * t;
        for (int i = 1; i < degree_; ++i) power *= t;
        value += power;
        power *= t / (degree_ + 1);
        once += power;
        twice += power * t / (degree_ + 2);
        factor *= -static_cast<double>(degree_ + 1 - k) / (k + 1);
    }
    return {value, x <= 0 ? once : 1 - once, s * once - twice};
}

double Spline::surface(double centroid) const {
    if (!(centroid > -reach_)) return -reach_;
    if (!(centroid < 0)) return reach_;
    double low = -reach_, high = reach_;
    // Just touched, N goes with the power p of the distance from its end.
    double d = std::min(low + (centroid - low) * (degree_ + 2) / (degree_ + 1), 0.5 * (low + high));
    for (int k = 0; k < 60; ++k) {
        const Values own = at(d);
        const double excess = own.moment - centroid * own.mass;
        (excess > 0 ? high : low) = d;
        if (std::abs(excess) <= 1e-15 * own.mass * reach_ || high - low < 1e-14) break;
        const double slope = (d - centroid) * own.value;
        const double next = slope > 0 ? d - excess / slope : low;
        d = next > low && next < high ? next : 0.5 * (low + high);
    }
    return d;
}

}  // namespace matpoint
