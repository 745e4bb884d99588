#pragma once

#include <matpoint/geometry.hpp>

#include <memory>
#include <stdexcept>
#include <vector>

namespace matpoint {

/// What union, intersection and difference share: their parameter `of`.
inline Schema operands_schema(std::string doc, std::string of_doc) {
    return Schema(std::move(doc))
        .add("of", ParameterType::components, {.doc = std::move(of_doc), .kind = "geometry"})
        .refuse("/of", "\"of\" must list at least one geometry",
                [](const Json& own, const Json&) { return own.at("of").empty(); });
}

inline std::vector<std::shared_ptr<Geometry>> make_operands(const Parameters& parameters) {
    std::vector<std::shared_ptr<Geometry>> operands = parameters.geometries("of");
    for (std::size_t i = 0; i < operands.size(); ++i)
        if (operands[i]->points())
            throw std::invalid_argument(
                "the geometry \"of\"[" + std::to_string(i) +
                "] lists single particles and is not a region: give it a body of its own");
    return operands;
}

}  // namespace matpoint
