#pragma once

#include "config/document.hpp"
#include "config/scene.hpp"
#include "registry/catalogue.hpp"
#include "run/run.hpp"

#include <matpoint/schema.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace matpoint {

/// A run that is over, as the checks of what must hold after it see it.
struct FinishedRun {
    const Scene& scene;
    PluginCatalogue& catalogue;
    std::filesystem::path output;  ///< the run's results
    std::filesystem::path folder;  ///< files that a check names are relative to it
    const RunResult& result;
    bool update_gold = false;  ///< write gold files anew instead of comparing
};

struct CheckResult {
    bool holds = false;
    std::string measured;  ///< against its bound: "disk_x: 0.0123 <= 0.03"
    std::string where{};   ///< where and how it differs most, if that can be said
};

/// A sort of check, known by the key that its objects have.
struct CheckKind {
    std::string key;
    Schema schema;
    /// `check` is the resolved object. Throws std::runtime_error if there is nothing to measure.
    std::function<CheckResult(const Json& check, const FinishedRun& run)> evaluate;
};

CheckKind gold_check();       ///< a probe's file, column by column, against one kept
CheckKind twin_check();       ///< files that another scene must write too
CheckKind statistic_check();  ///< a number taken from a probe's file
CheckKind probe_check();      ///< a column of a probe's file against a formula of t
CheckKind summary_check();    ///< a number in summary.json
CheckKind particles_check();  ///< a field of the particles at the end against a formula
CheckKind restart_check();    ///< a run cut in two by a checkpoint against the whole run
/// In the order in which a check's keys are looked for.
const std::vector<CheckKind>& check_kinds();

/// Checks the structure of a list of checks and resolves it; `at` is its JSON pointer.
Json validate_checks(const Document& document, const Json& checks, const std::string& at,
                     Diagnostics& diagnostics);

/// Evaluates a resolved check; what can't be measured does not hold.
CheckResult evaluate_check(const Json& check, const FinishedRun& run);

}  // namespace matpoint
