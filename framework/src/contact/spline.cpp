#include <matpoint/spline.hpp>

#include <algorithm>
#include <cmath>

namespace matpoint {

/// sum_k (-1)^k C(p + 1, k) (x + r - k)_+^order / order!: N for order p, and its integrals. For x <= 0, where
/// nothing large cancels.
double Spline::power_sum(double x, int order) const {
    double sum = 0, binomial = 1;
    for (int k = 0; k <= degree_ + 1; ++k) {
        const double s = x + reach_ - k;
        if (s <= 0) break;
        double term = binomial;
        for (int i = 1; i <= order; ++i) term *= s / i;
        sum += k % 2 == 0 ? term : -term;
        binomial *= static_cast<double>(degree_ + 1 - k) / (k + 1);
    }
    return sum;
}

double Spline::value(double x) const {
    return power_sum(-std::abs(x), degree_);
}

double Spline::mass(double x) const {
    return x <= 0 ? power_sum(x, degree_ + 1) : 1 - power_sum(-x, degree_ + 1);
}

double Spline::moment(double x) const {
    const double s = -std::abs(x);  // xi N is odd
    return s * power_sum(s, degree_ + 1) - power_sum(s, degree_ + 2);
}

double Spline::surface(double centroid) const {
    if (!(centroid > -reach_)) return -reach_;
    if (!(centroid < 0)) return reach_;
    double low = -reach_, high = reach_;
    // Just touched, N goes with the power p of the distance from its end.
    double d = std::min(low + (centroid - low) * (degree_ + 2) / (degree_ + 1), 0.5 * (low + high));
    for (int k = 0; k < 60; ++k) {
        const double own = mass(d), excess = moment(d) - centroid * own;
        (excess > 0 ? high : low) = d;
        if (std::abs(excess) <= 1e-15 * own * reach_) break;
        const double slope = (d - centroid) * value(d);
        const double next = slope > 0 ? d - excess / slope : low;
        d = next > low && next < high ? next : 0.5 * (low + high);
        if (high - low < 1e-14) break;
    }
    return d;
}

}  // namespace matpoint
