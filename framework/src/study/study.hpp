#pragma once

#include "study/measurement.hpp"

#include <filesystem>

namespace matpoint {

struct StudyResult {
    bool interrupted = false;  ///< nothing but the runs that are over was kept then
    std::size_t measured = 0;  ///< runs that are over, of this call and earlier ones
    std::size_t variants = 0;
    Json report{};  ///< what study.json or limits.json holds
};

/// Runs the variants of a study that have not been measured yet, and writes study.json, study.csv, the report
/// and, if the target is met, best.json. Throws InputError, ResourceError.
StudyResult run_study(const StudyFile& study, const StudyOptions& options);

}  // namespace matpoint
