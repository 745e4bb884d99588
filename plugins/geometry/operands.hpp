#pragma once

#include <matpoint/geometry.hpp>

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

}  // namespace matpoint
