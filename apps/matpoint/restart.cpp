#include "run_command.hpp"
#include "verbs.hpp"

#include "verify/load_scene.hpp"

#include <iostream>

namespace matpoint {
namespace {

/// The folder of the run that wrote the checkpoint.
std::filesystem::path run_folder(const std::filesystem::path& checkpoint) {
    const std::filesystem::path folder = std::filesystem::absolute(checkpoint).parent_path();
    return std::filesystem::proximate(folder.filename() == "checkpoints" ? folder.parent_path() : folder);
}

}  // namespace

int restart(const std::vector<std::string>& arguments) {
    VerbOptions verb{
        .usage = "matpoint restart CHECKPOINT [--output DIR] [--set /ptr=VALUE]... [--threads N] [--quiet]",
        .doc =
            "Goes on from a checkpoint; the result equals the uninterrupted run's. Results go to the\n"
            "folder of the run that wrote it, or to DIR. A later end: --set /time/end=2.",
        .least_arguments = 1,
        .most_arguments = 1};
    add_run_options(verb.options);
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;
    use_threads(*values);

    const std::filesystem::path file = arguments_of(*values).front();
    try {
        CheckpointData checkpoint = read_checkpoint(file);
        PluginCatalogue catalogue;
        Scene scene = scene_of(checkpoint, catalogue);
        const std::vector<std::string> assignments = assignments_of(*values);
        if (!assignments.empty()) scene = load_scene(std::move(scene.document), assignments, catalogue);
        return run_to_end(scene, catalogue, *values, run_folder(file), std::move(checkpoint));
    } catch (const CheckpointError& error) {  // not one, or not one of the changed scene
        std::cerr << error.what() << "\n";
        return exit_bad_input;
    }
}

}  // namespace matpoint
