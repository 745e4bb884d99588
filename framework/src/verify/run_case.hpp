#pragma once

#include "verify/cases.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

struct CaseResult {
    bool interrupted = false;
    std::vector<std::string> measured;  ///< one a check: "disk_x: 0.0123 <= 0.03"
    std::vector<std::string> failures;  ///< each with the place in the case file; empty: passed
};

struct CaseOptions {
    std::filesystem::path output;  ///< folder for the run's results
    bool update_gold = false;      ///< write gold files anew instead of comparing
};

/// Runs the scene of a case and evaluates its checks, or sees to it that it fails as expected.
CaseResult run_case(const Case& test, const CaseOptions& options);

}  // namespace matpoint
