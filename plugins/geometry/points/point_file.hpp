#pragma once

#include <matpoint/geometry.hpp>

#include <filesystem>
#include <vector>

namespace matpoint {

/// What a file of points says: the numbers that it has, row by row.
struct PointTable {
    std::vector<std::size_t> columns;  ///< of each number of a row: 0 … 2 x, y, z; 3 … 5 vx, vy, vz; 6 volume
    std::vector<double> numbers;

    Index size() const { return std::ssize(numbers) / std::ssize(columns); }
    PointCloud::Point point(Index row) const;
};

/// Reads a CSV file whose first line names its columns: x, y, z (as many as `dimension`), volume, and
/// if wanted vx, vy, vz, in any order. Throws std::invalid_argument with all mistakes of the file,
/// each as "file:line: …".
PointTable read_point_file(const std::filesystem::path& file, int dimension);

}  // namespace matpoint
