#pragma once

#include "run/clock.hpp"
#include "run/run.hpp"

namespace matpoint {

/// What summary.json holds.
Json summarise(const Simulation& simulation, const PluginCatalogue& catalogue, const RunClock& clock,
               const RunResult& result);

/// A resolved scene with the plugins, and their versions, that it was run with.
Json with_plugins(Json resolved, const PluginCatalogue& catalogue);

/// Mass, momentum and energy at the end, on standard output.
void print_closing_table(const Simulation& simulation, const RunResult& result);

}  // namespace matpoint
