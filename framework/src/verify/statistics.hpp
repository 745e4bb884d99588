#pragma once

#include <matpoint/schema.hpp>

#include <filesystem>
#include <string>

namespace matpoint {

/// A number taken from a column of a probe's file: a value (mean over the rows) or a time.
void describe_statistic(Schema& schema);
/// "max of force"
std::string statistic_text(const Json& own);
/// Of the files in a folder. Throws std::runtime_error if there is nothing to measure.
double statistic_of(const Json& own, const std::filesystem::path& folder);

}  // namespace matpoint
