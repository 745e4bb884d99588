#pragma once

#include <matpoint/schema.hpp>

#include <filesystem>

namespace matpoint {

/// Writes what study.json says as study.html, study.svg (error against cost) and <name>.svg for each of
/// its plots. Throws std::runtime_error with the file's name if one can't be written.
void write_report(const Json& study, const std::filesystem::path& folder);

}  // namespace matpoint
