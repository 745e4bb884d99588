#include "verify/check.hpp"
#include "verify/compare_states.hpp"

#include "run/rotation.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace matpoint {
namespace {

CheckResult evaluate_restart(const Json&, const FinishedRun& run) {
    const long steps = run.result.final_state.step;
    if (steps < 2) throw std::runtime_error("the run has less than two steps");
    const std::filesystem::path folder = run.output / "restart";
    const long half = steps / 2;
    run_scene(run.scene, run.catalogue, {.output = folder, .quiet = true, .stop_after_steps = half});

    // As the command line does it: everything from the file.
    PluginCatalogue catalogue;
    CheckpointData checkpoint = read_checkpoint(checkpoint_path(folder / "checkpoints", half));
    const Scene scene = scene_of(checkpoint, catalogue);
    const RunResult resumed =
        run_scene(scene, catalogue,
                  {.output = folder, .quiet = true, .keep_state = true, .resume = std::move(checkpoint)});

    if (resumed.status != RunStatus::completed)
        throw std::runtime_error("the run that goes on: " + resumed.reason);
    const std::string difference = first_difference(run.result.final_state, resumed.final_state);
    return {.holds = difference.empty(),
            .measured = fmt::format("restart after step {} of {}: {}", half, steps,
                                    difference.empty() ? "same bits" : "differs"),
            .where = difference};
}

}  // namespace

CheckKind restart_check() {
    Schema schema("The run, cut in two by a checkpoint on disk, ends with the same bits");
    schema.boolean("restart_equals_run", {.doc = "true"})
        .text("comment", {.doc = "For readers", .optional = true})
        .refuse("/restart_equals_run", "leave the check out instead",
                [](const Json& own, const Json&) { return own.at("restart_equals_run") == false; });
    return {"restart_equals_run", schema, evaluate_restart};
}

}  // namespace matpoint
