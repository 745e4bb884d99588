#include "run/holding.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace matpoint {

std::string pointer_to(std::size_t condition) {
    return fmt::format("/boundary_conditions/{}", condition);
}

template <class S>
std::vector<Holding> holdings(const std::vector<PlacedCondition<S>>& conditions) {
    std::vector<Holding> all;
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        if (conditions[k].region) all.push_back({k});
        for (int axis = 0; axis < S::dimension; ++axis)
            for (int side = 0; side < 2; ++side)
                if (holds_on(conditions[k], axis, side)) all.push_back({k, axis, side});
    }
    return all;
}

template <class S>
std::optional<std::string> difference(const SceneParts<S>& parts, const Holding& one, const Holding& other,
                                      const typename S::Position& place) {
    using Real = typename S::Real;
    constexpr int moments = 8;
    const double end = parts.scene.at("/time/end"_json_pointer).template get<double>();
    const BoundaryCondition<S>& a = *parts.conditions[one.condition].condition;
    const BoundaryCondition<S>& b = *parts.conditions[other.condition].condition;
    const auto by_a = a.prescribes(one.axis), by_b = b.prescribes(other.axis);
    for (int c = 0; c < S::dimension; ++c) {
        const auto i = static_cast<std::size_t>(c);
        if (!by_a[i] || !by_b[i]) continue;
        for (int k = 0; k < moments; ++k) {
            const double time = end * k / (moments - 1);
            const Real va = a.velocity(place, time)[c], vb = b.velocity(place, time)[c];
            const Real rounding =
                16 * std::numeric_limits<Real>::epsilon() * std::max(std::abs(va), std::abs(vb));
            if (!(std::abs(va - vb) > rounding)) continue;
            return fmt::format(
                "prescribes {:.6g} m/s as the {} component of velocity at the node ({:.6g}) at t = {:.6g} s, "
                "where {}{} prescribes {:.6g} m/s: let one of them end before the other",
                va, "xyz"[i], fmt::join(place.data(), place.data() + S::dimension, ", "), time,
                pointer_to(other.condition),
                other.axis < 0 ? "" : fmt::format(" on \"{}\"", face_name(other.axis, other.side)), vb);
        }
    }
    return {};
}

#define MATPOINT_INSTANTIATE(S)                                                                             \
    template std::vector<Holding> holdings<S>(const std::vector<PlacedCondition<S>>&);                      \
    template std::optional<std::string> difference<S>(const SceneParts<S>&, const Holding&, const Holding&, \
                                                      const S::Position&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
