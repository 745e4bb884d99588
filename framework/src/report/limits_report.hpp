#pragma once

#include <matpoint/schema.hpp>

#include <filesystem>

namespace matpoint {

/// Writes what limits.json says as limits.html and limits.svg, a bar to the largest stable value of each
/// variant. Throws std::runtime_error with the file's name if one can't be written.
void write_limits_report(const Json& limits, const std::filesystem::path& folder);

}  // namespace matpoint
