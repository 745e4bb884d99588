#pragma once

#include "study/study.hpp"

namespace matpoint {

/// Looks for the limit of stability of each variant, and writes limits.json, limits.csv and the report. What
/// an earlier call measured is not run again. Throws InputError.
StudyResult run_limits(const StudyFile& study, const StudyOptions& options);

}  // namespace matpoint
