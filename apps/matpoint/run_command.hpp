#pragma once

#include "options.hpp"

#include "config/scene.hpp"
#include "registry/catalogue.hpp"
#include "run/run.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

/// --set, and what it was given.
void add_assignments(po::options_description& options);
std::vector<std::string> assignments_of(const po::variables_map& values);

/// What `run` and `restart` share: --output, --set, --threads, --quiet.
void add_run_options(po::options_description& options);

/// On stderr; those with a place in the scene say by themselves what they are.
void print_warning(const std::string& warning);

/// What is known of the accuracy that a scene asks for, on stderr.
void print_recommendation(const Scene& scene, const PluginCatalogue& catalogue);

using TimePoint = std::chrono::steady_clock::time_point;

/// Runs, with progress if stderr is a terminal; says where results are and how long all took since `start`,
/// and on stderr why a run did not complete. Returns the exit status.
int run_to_end(const Scene& scene, PluginCatalogue& catalogue, const po::variables_map& values,
               const std::filesystem::path& default_output, TimePoint start,
               std::optional<CheckpointData> resume = {});

}  // namespace matpoint
