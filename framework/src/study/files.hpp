#pragma once

#include "study/study_file.hpp"

#include <filesystem>
#include <string>

namespace matpoint {

/// Whole or not at all.
void write_text(const std::filesystem::path& file, const std::string& text);

/// The variants of study.json or limits.json as a table: a column for each varied value and each entry.
std::string csv(const Json& report);

/// The varied values of study.json: [{"pointer", "label"}].
Json varied(const StudyFile& study);
/// What study.json says about where it was made.
Json machine();

}  // namespace matpoint
