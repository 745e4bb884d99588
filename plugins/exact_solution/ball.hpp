#pragma once

#include <matpoint/exact_solution.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace matpoint {

/// Whether a body is a ball, but not the one of a solution's `radius` and `center`.
inline bool is_another_ball(const Json& own, const Json& geometry) {
    if (geometry.at("type") != "sphere") return false;
    const double radius = own.at("radius").get<double>();
    const auto place = geometry.at("center").get<std::vector<double>>();
    const auto center = own.value("center", std::vector<double>(place.size(), 0.0));
    double off = std::abs(geometry.at("radius").get<double>() - radius);
    for (std::size_t a = 0; a < place.size(); ++a) off += std::abs(place[a] - center.at(a));
    return off > 1e-9 * radius;
}

/// Declares where a solution's ball (a disk in the plane) is.
inline Schema& add_ball(Schema& schema) {
    return schema
        .number("radius", {.unit = "m", .doc = "Its radius R", .default_value = 1.0, .greater_than = 0})
        .vector("center",
                {.unit = "m", .doc = "Its centre at the start; without it the origin", .optional = true})
        .warn("/body", "the ball of the solution has another radius or centre than the body",
              [](const Json& own, const Json& scene) {
                  return std::ranges::any_of(own.at("body"), [&](const Json& name) {
                      return is_another_ball(own,
                                             scene.at("bodies").at(name.get<std::string>()).at("geometry"));
                  });
              });
}

}  // namespace matpoint
