#pragma once

#include <matpoint/geometry.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace matpoint {

/// What union, intersection and difference share: their parameter `of`.
inline Schema operands_schema(std::string doc, std::string of_doc) {
    return Schema(std::move(doc))
        .add("of", ParameterType::components, {.doc = std::move(of_doc), .kind = "geometry"})
        .refuse("/of", "\"of\" must list at least one geometry",
                [](const Json& own, const Json&) { return own.at("of").empty(); });
}

/// One of the geometries; what it throws is told as its own.
class Operand {
  public:
    explicit Operand(std::shared_ptr<Geometry> geometry) : geometry_(std::move(geometry)) {}

    Geometry::Bounds bounds() const {
        return guarded(*geometry_, "bounds", [&] { return geometry_->bounds(); });
    }
    bool contains(const Eigen::Vector3d& point) const {
        return guarded(*geometry_, "contains", [&] { return geometry_->contains(point); });
    }
    std::vector<char> contains(std::span<const Eigen::Vector3d> points) const {
        return guarded(*geometry_, "contains", [&] { return geometry_->contains(points); });
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval within,
                                   double step) const {
        return guarded(*geometry_, "along_x", [&] { return geometry_->along_x(lines, within, step); });
    }
    std::vector<double> breaks(int axis) const {
        return guarded(*geometry_, "breaks", [&] { return geometry_->breaks(axis); });
    }
    Eigen::Vector3d anchor() const {
        return guarded(*geometry_, "anchor", [&] { return geometry_->anchor(); });
    }
    SignedDistance signed_distance(const Eigen::Vector3d& point) const {
        return guarded(*geometry_, "signed_distance", [&] { return geometry_->signed_distance(point); });
    }

  private:
    std::shared_ptr<Geometry> geometry_;
};

inline std::vector<Operand> make_operands(const Parameters& parameters) {
    std::vector<Operand> operands;
    for (const std::shared_ptr<Geometry>& geometry : parameters.geometries("of")) {
        if (geometry->points())
            throw std::invalid_argument(
                "the geometry \"of\"[" + std::to_string(operands.size()) +
                "] lists single particles and is not a region: give it a body of its own");
        operands.emplace_back(geometry);
    }
    return operands;
}

inline bool by_distance(const SignedDistance& a, const SignedDistance& b) {
    return a.distance < b.distance;
}

/// What is in both of two lists of intervals.
inline Intervals common(const Intervals& a, const Intervals& b) {
    Intervals both;
    for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
        const double begin = std::max(i->begin, j->begin), end = std::min(i->end, j->end);
        if (begin < end) both.push_back({begin, end});
        ++(i->end < j->end ? i : j);
    }
    return both;
}

/// All that is in none of the intervals.
inline Intervals complement(const Intervals& intervals) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Intervals others;
    double end = -infinity;
    for (const Interval& interval : intervals) {
        if (end < interval.begin) others.push_back({end, interval.begin});
        end = interval.end;
    }
    others.push_back({end, infinity});
    return others;
}

/// What `combine` makes of the operands' intervals along each line, the first with the second and so on.
template <class Combine>
std::vector<Intervals> combine_along_x(const std::vector<Operand>& operands,
                                       std::span<const Eigen::Vector2d> lines, Interval within, double step,
                                       const Combine& combine) {
    std::vector<Intervals> combined = operands[0].along_x(lines, within, step);
    for (std::size_t g = 1; g < operands.size(); ++g) {
        const std::vector<Intervals> others = operands[g].along_x(lines, within, step);
        for (std::size_t i = 0; i < lines.size(); ++i) combined[i] = combine(combined[i], others[i]);
    }
    return combined;
}

/// Those of all operands.
inline std::vector<double> breaks_of(const std::vector<Operand>& operands, int axis) {
    std::vector<double> all;
    for (const Operand& operand : operands) {
        const std::vector<double> own = operand.breaks(axis);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

}  // namespace matpoint
