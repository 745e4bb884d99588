#pragma once

#include <matpoint/geometry.hpp>

#include <filesystem>

namespace matpoint {

/// Reads a CSV file whose first line names its columns: x, y, z (as many as `dimension`), volume, and
/// if wanted vx, vy, vz, in any order. Throws std::invalid_argument with all mistakes of the file,
/// each as "file:line: …".
PointCloud read_point_file(const std::filesystem::path& file, int dimension);

}  // namespace matpoint
