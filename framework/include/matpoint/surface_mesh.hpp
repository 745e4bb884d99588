#pragma once

#include <cstdint>
#include <vector>

namespace matpoint {

/// A surface for pictures: quadrangles in 3D, lines in 2D, points in 1D.
struct SurfaceMesh {
    std::vector<double> points;         ///< m, three coordinates a point
    int corners = 1;                    ///< of a cell
    std::vector<std::int64_t> cells{};  ///< numbers of points, `corners` a cell
};

}  // namespace matpoint
