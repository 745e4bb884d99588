#pragma once

#include "options.hpp"

#include "study/study.hpp"

#include <filesystem>

namespace matpoint {

/// What `study` and `limits` share: --output, --jobs, --again, --quiet.
void add_study_options(po::options_description& options);
StudyOptions study_options(const po::variables_map& values, const std::filesystem::path& file);

/// Tells on stderr how many runs were over when a signal came, and how to go on.
void tell_interruption(const StudyResult& result, const char* what);

/// A number in a column of a table; empty for null.
std::string cell(const Json& number, const char* format = "{:.3g}");
/// The beginning of a reason, as much of it as a table has room for.
std::string brief(const std::string& reason);

}  // namespace matpoint
