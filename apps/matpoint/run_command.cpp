#include "run_command.hpp"

#include "config/diagnostics.hpp"
#include "run/left_over.hpp"
#include "study/recommendation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace matpoint {

void add_assignments(po::options_description& options) {
    options.add_options()("set", po::value<std::vector<std::string>>()->composing()->value_name("/ptr=VALUE"),
                          "replace a value of the scene, by JSON pointer; may be repeated");
}

void add_run_options(po::options_description& options) {
    options.add_options()("output", po::value<std::string>()->value_name("DIR"), "folder for results");
    add_assignments(options);
    add_threads(options);
    options.add_options()("quiet", "neither progress nor a closing table");
}

std::vector<std::string> assignments_of(const po::variables_map& values) {
    if (values.count("set") == 0) return {};
    return values["set"].as<std::vector<std::string>>();
}

void print_warning(const std::string& warning) {
    const bool placed = warning.find("warning: ") != std::string::npos;
    std::cerr << (placed ? "" : "warning: ") << warning << "\n";
}

void print_recommendation(const Scene& scene, const PluginCatalogue& catalogue) {
    if (const auto advice = recommendation(scene, catalogue.registry(), fronts_folder()))
        std::cerr << *advice << "\n";
}

/// Files in the folder of an earlier run that belong to outputs which the scene hasn't got: next to the new
/// results they would pass for such.
void warn_of_leftovers(const std::filesystem::path& folder, const Scene& scene, PluginCatalogue& catalogue) {
    const std::vector<std::string> files = left_over(folder, scene, catalogue);
    if (files.empty()) return;
    constexpr std::size_t most = 5;
    std::cerr << fmt::format("warning: {} keeps files of an earlier run that this one does not write: {}{}\n",
                             folder.string(),
                             fmt::join(files.begin(), files.begin() + std::min(most, files.size()), ", "),
                             files.size() > most ? fmt::format(" and {} more", files.size() - most) : "");
}

int run_to_end(const Scene& scene, PluginCatalogue& catalogue, const po::variables_map& values,
               const std::filesystem::path& default_output, TimePoint start,
               std::optional<CheckpointData> resume) {
    print_recommendation(scene, catalogue);
    const bool quiet = values.count("quiet") > 0;
    RunOptions options;
    options.output =
        values.count("output") > 0 ? values["output"].as<std::string>() : default_output.string();
    options.progress = !quiet && isatty(STDERR_FILENO) == 1;
    options.quiet = quiet;
    options.warn = print_warning;
    if (!resume) warn_of_leftovers(options.output, scene, catalogue);
    options.resume = std::move(resume);
    const RunResult result = run_scene(scene, catalogue, options);
    if (!quiet) {
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        std::cout << fmt::format("results in {}; {:.3g} s in all\n", options.output.string(), taken.count())
                  << std::flush;
    }
    if (result.status != RunStatus::completed) std::cerr << result.reason << "\n";
    return result.exit_status();
}

}  // namespace matpoint
