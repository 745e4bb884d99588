#pragma once

#include "study/study_file.hpp"

#include <string>

namespace matpoint {

/// The variants of study.json or limits.json as a table: a column for each varied value and each entry.
std::string csv(const Json& report);

/// The varied values of study.json: [{"pointer", "label"}].
Json varied(const StudyFile& study);
/// What study.json says about where it was made.
Json machine();

}  // namespace matpoint
