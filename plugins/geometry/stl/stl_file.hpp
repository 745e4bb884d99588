#pragma once

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <vector>

namespace matpoint {

using Triangle = std::array<Eigen::Vector3f, 3>;

/// The triangles of an STL file, binary or ASCII; their normals are not read. Throws
/// std::invalid_argument with the file's name and what was expected.
std::vector<Triangle> read_stl_file(const std::filesystem::path& file);

}  // namespace matpoint
