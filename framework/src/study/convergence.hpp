#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace matpoint {

/// Observed order of convergence p of errors C h^p at two sizes h; NaN if they can't tell.
double observed_order(double fine_size, double fine_error, double coarse_size, double coarse_error);

/// The limit of a quantity q(h) = q* + C h^p for h -> 0.
struct Extrapolation {
    double limit;                 ///< q*; the finest value if there is no order
    std::optional<double> order;  ///< p
};

/// Richardson's extrapolation with the observed order, from values at three sizes, the finest first
/// [Roache 1994, "Perspective: a method for uniform reporting of grid refinement studies", J. Fluids Eng.
/// 116(3)]. There is no order if the values are not monotone, or don't approach a limit.
Extrapolation extrapolate(const std::array<double, 3>& sizes, const std::array<double, 3>& values);

/// Which points are on the Pareto front: no other point is better in one coordinate and at least as good in
/// the other. Points that are not finite are not on it.
std::vector<bool> pareto_front(const std::vector<std::pair<double, double>>& points);

}  // namespace matpoint
