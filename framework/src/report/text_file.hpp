#pragma once

#include <filesystem>
#include <string>

namespace matpoint {

/// Whole or not at all.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace matpoint
