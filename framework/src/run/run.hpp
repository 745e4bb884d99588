#pragma once

#include "run/simulation.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace matpoint {

struct RunOptions {
    std::filesystem::path output;  ///< folder for results; made if missing
    bool progress = false;         ///< a progress line on stderr (the CLI sets it on a terminal)
    bool quiet = false;            ///< no closing table on stdout
    bool keep_state = false;       ///< the result holds the state at the end: as much memory again
    std::function<void(const std::string&)> warn{};  ///< told of each warning as soon as it is known
    std::optional<CheckpointData> resume{};          ///< continue from this state
    std::optional<long> stop_after_steps{};  ///< stop as if interrupted after this many steps in all (tests)
};

enum class RunStatus { completed, broke_down, interrupted, unfinished };

struct RunResult {
    RunStatus status = RunStatus::completed;
    std::string reason{};          ///< why it did not complete
    Json summary{};                ///< what summary.json holds
    CheckpointData final_state{};  ///< state at the end, if asked for
    int exit_status() const { return status == RunStatus::completed ? 0 : 1; }
};

/// Runs a scene to its end: outputs, checkpoints, summary.json, resolved.json. A signal that ends programs
/// (while it runs, <run/signals.hpp>) writes a checkpoint and ends it with status interrupted. Errors in
/// input throw InputError; ResourceError: somebody else writes into the folder, or the memory does not
/// suffice.
RunResult run_scene(const Scene& scene, PluginCatalogue& catalogue, const RunOptions& options);

/// The scene a checkpoint was written by, resolved again.
Scene scene_of(const CheckpointData& checkpoint, PluginCatalogue& catalogue);

}  // namespace matpoint
