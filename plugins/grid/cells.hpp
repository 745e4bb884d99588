#pragma once

#include <matpoint/grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace matpoint {

/// Whether max - min is a whole number of cells on every axis, to the rounding of decimal input.
inline bool fits_whole_cells(const Json& own) {
    for (std::size_t a = 0; a < own.at("min").size(); ++a) {
        const double cells = (own.at("max")[a].get<double>() - own.at("min")[a].get<double>()) /
                             own.at("cell_size")[a].get<double>();
        if (!(std::abs(cells - std::round(cells)) < 1e-6 && cells > 0.5)) return false;
    }
    return true;
}

/// Blocks of nodes are numbered by int, and each takes an entry of a table even where nothing is.
inline bool has_countable_blocks(const Json& own) {
    const std::size_t dimension = own.at("min").size();
    const double edge = dimension == 1   ? Patch<Bar>::block_edge
                        : dimension == 2 ? Patch<PlaneStrain>::block_edge
                                         : Patch<Solid>::block_edge;
    double blocks = 1;
    for (std::size_t a = 0; a < dimension; ++a) {
        const double cells = (own.at("max")[a].get<double>() - own.at("min")[a].get<double>()) /
                             own.at("cell_size")[a].get<double>();
        if (!(cells < 1e9)) return false;
        blocks *= cells / edge + 2;
    }
    return blocks < std::numeric_limits<int>::max();
}

inline bool is_axisymmetric(const Json& scene) {
    return scene.at("/space/mode"_json_pointer) == "axisymmetric";
}

inline bool starts_at_axis(const Json& own, const Json& scene) {
    return is_axisymmetric(scene) && own.at("min")[0].get<double>() == 0;
}

inline bool has_wall(const Json& scene, const std::string& face) {
    for (const Json& condition : scene.at("boundary_conditions"))
        if (const Json& on = condition.at("on");
            on.is_array() && std::find(on.begin(), on.end(), face) != on.end())
            return true;
    return false;
}

/// What a lattice of equal cells is described by.
inline Schema& add_cells(Schema& schema) {
    return schema.vector("min", {.unit = "m", .doc = "Lower corner"})
        .vector("max", {.unit = "m", .doc = "Upper corner"})
        .add("cell_size", ParameterType::per_axis,
             {.unit = "m", .doc = "Edge of a cell, for all axes or one per axis", .greater_than = 0})
        .refuse("/cell_size", "max - min must be a positive whole number of cells on every axis",
                [](const Json& own, const Json&) { return !fits_whole_cells(own); })
        .refuse(
            "/cell_size",
            "the grid has too many cells: at most 1e9 per axis and 1e11 in all; take larger ones or a "
            "smaller grid",
            [](const Json& own, const Json&) { return fits_whole_cells(own) && !has_countable_blocks(own); })
        .warn("/min",
              "the axis of an axisymmetric space is at x_min, but nothing keeps particles there: add a "
              "slip "
              "boundary condition on \"x_min\"",
              [](const Json& own, const Json& scene) {
                  return starts_at_axis(own, scene) && !has_wall(scene, "x_min");
              })
        .refuse("/min", "the first axis is the radius in an axisymmetric space: it can't start below 0",
                [](const Json& own, const Json& scene) {
                    return is_axisymmetric(scene) && own.at("min")[0].get<double>() < 0;
                });
}

/// The patch that such a description is of.
template <class S>
Patch<S> patch_of(const Parameters& parameters) {
    const auto min = parameters.vector("min"), max = parameters.vector("max"),
               h = parameters.vector("cell_size");
    typename Patch<S>::Coordinates cells;
    for (std::size_t a = 0; a < S::dimension; ++a)
        cells[a] = static_cast<int>(std::lround((max[a] - min[a]) / h[a]));
    return {min, h, cells};
}

}  // namespace matpoint
