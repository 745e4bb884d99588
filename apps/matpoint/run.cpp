#include "run_command.hpp"
#include "verbs.hpp"

#include "verify/load_scene.hpp"

namespace matpoint {

int run(const std::vector<std::string>& arguments) {
    VerbOptions verb{
        .usage = "matpoint run SCENE [--output DIR] [--set /ptr=VALUE]... [--threads N] [--quiet]",
        .doc = "Runs a scene. Results go to out/<scene name>, or to DIR.",
        .least_arguments = 1,
        .most_arguments = 1};
    const TimePoint start = std::chrono::steady_clock::now();
    add_run_options(verb.options);
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;
    use_threads(*values);

    const std::filesystem::path file = arguments_of(*values).front();
    PluginCatalogue catalogue;
    const Scene scene = load_scene(file, assignments_of(*values), catalogue);
    return run_to_end(scene, catalogue, *values, "out" / file.stem(), start);
}

}  // namespace matpoint
