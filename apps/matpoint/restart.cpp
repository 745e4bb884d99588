#include "run_command.hpp"
#include "verbs.hpp"

#include "verify/load_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <set>

namespace matpoint {
namespace {

/// The folder of the run that wrote the checkpoint.
std::filesystem::path run_folder(const std::filesystem::path& checkpoint) {
    const std::filesystem::path folder = std::filesystem::absolute(checkpoint).parent_path();
    return std::filesystem::proximate(folder.filename() == "checkpoints" ? folder.parent_path() : folder);
}

/// What of the object around `pointer` a restart does read.
std::vector<std::string> readable_beside(const Scene& scene, const std::string& pointer) {
    const std::string around = pointer.substr(0, pointer.rfind('/'));
    std::vector<std::string> keys;
    const Json::json_pointer at(around);
    if (!scene.resolved.contains(at)) return keys;
    for (const auto& [key, value] : scene.resolved.at(at).items()) {
        const std::string place = join_pointer(around, key);
        const bool sections = around.empty();
        if (std::ranges::find(scene.start_only, place) == scene.start_only.end() &&
            (!sections || value.is_structured()))
            keys.push_back(place);
    }
    return keys;
}

/// A restart goes on with the particles, and in the space and grid, that the checkpoint has: what only the
/// start of a run reads can't be changed.
void refuse_changes(const Scene& saved, const Scene& changed, const CheckpointData& checkpoint) {
    std::set<std::string> pointers(saved.start_only.begin(), saved.start_only.end());
    pointers.insert(changed.start_only.begin(), changed.start_only.end());
    Diagnostics mistakes;
    for (const std::string& pointer : pointers) {
        const Json::json_pointer at(pointer);
        if (saved.resolved.contains(at) && changed.resolved.contains(at) &&
            saved.resolved.at(at) == changed.resolved.at(at))
            continue;
        mistakes.add(changed.document.diagnostic(
            pointer, fmt::format("only the start of a run reads it, and a restart goes on with what the "
                                 "checkpoint has; it reads {}",
                                 fmt::join(readable_beside(changed, pointer), ", "))));
    }
    const Json &before = saved.resolved.at("time"), &time = changed.resolved.at("time");
    const auto is_over = [&](const char* key, double reached) {
        return time.value(key, reached) < reached && time.value(key, reached) != before.value(key, reached);
    };
    if (is_over("end", checkpoint.time) || is_over("max_steps", static_cast<double>(checkpoint.step)))
        mistakes.add(changed.document.diagnostic(
            "/time", fmt::format("the checkpoint is at step {}, t = {:.6g} s already", checkpoint.step,
                                 checkpoint.time)));
    mistakes.throw_if_errors();
}

}  // namespace

int restart(const std::vector<std::string>& arguments) {
    VerbOptions verb{
        .usage = "matpoint restart CHECKPOINT [--output DIR] [--set /ptr=VALUE]... [--threads N] [--quiet]",
        .doc =
            "Goes on from a checkpoint; the result equals the uninterrupted run's. Results go to the\n"
            "folder of the run that wrote it, or to DIR. A later end: --set /time/end=2.\n"
            "What only the start of a run reads (space, grid, particles, densities) can't be changed.",
        .least_arguments = 1,
        .most_arguments = 1};
    const TimePoint start = std::chrono::steady_clock::now();
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
        if (!assignments.empty()) {
            Scene changed = load_scene(scene.document, assignments, catalogue);
            refuse_changes(scene, changed, checkpoint);
            scene = std::move(changed);
        }
        return run_to_end(scene, catalogue, *values, run_folder(file), start, std::move(checkpoint));
    } catch (const CheckpointError& error) {  // not one, or not one of the changed scene
        std::cerr << error.what() << "\n";
        return exit_bad_input;
    }
}

}  // namespace matpoint
