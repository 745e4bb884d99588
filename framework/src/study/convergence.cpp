#include "study/convergence.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace matpoint {
namespace {

/// Orders outside are none: of noise, or of values that are all but equal.
constexpr double lowest_order = 0.1, highest_order = 12;

}  // namespace

double observed_order(double fine_size, double fine_error, double coarse_size, double coarse_error) {
    const double order = std::log(coarse_error / fine_error) / std::log(coarse_size / fine_size);
    return std::isfinite(order) ? order : std::numeric_limits<double>::quiet_NaN();
}

Extrapolation extrapolate(const std::array<double, 3>& sizes, const std::array<double, 3>& values) {
    const auto [h1, h2, h3] = sizes;
    const auto [q1, q2, q3] = values;
    const Extrapolation none{.limit = q1, .order = {}};
    // (h3^p - h2^p) / (h2^p - h1^p) grows with p; it equals the ratio of the differences of q.
    const double ratio = (q3 - q2) / (q2 - q1);
    const auto excess = [=](double p) {
        return (std::pow(h3 / h2, p) - 1) / (1 - std::pow(h1 / h2, p)) - ratio;
    };
    if (!std::isfinite(ratio) || !(excess(lowest_order) < 0) || !(excess(highest_order) > 0)) return none;
    std::uintmax_t iterations = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        excess, lowest_order, highest_order, boost::math::tools::eps_tolerance<double>(50), iterations);
    const double order = std::midpoint(low, high);
    return {.limit = q1 + (q1 - q2) / (std::pow(h2 / h1, order) - 1), .order = order};
}

std::vector<bool> pareto_front(const std::vector<std::pair<double, double>>& points) {
    const auto finite = [](const std::pair<double, double>& p) {
        return std::isfinite(p.first) && std::isfinite(p.second);
    };
    std::vector<bool> front;
    for (const auto& point : points) {
        const auto beats = [&](const std::pair<double, double>& other) {
            return finite(other) && other.first <= point.first && other.second <= point.second &&
                   other != point;
        };
        front.push_back(finite(point) && std::ranges::none_of(points, beats));
    }
    return front;
}

}  // namespace matpoint
