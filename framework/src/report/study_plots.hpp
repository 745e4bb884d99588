#pragma once

#include <matpoint/schema.hpp>

#include "report/svg_plot.hpp"

#include <string>

namespace matpoint {

/// What study.json calls the measure "error" or "cost", or the key in words.
std::string measure_label(const Json& study, const std::string& key);

/// Error against cost of all variants, with the Pareto front, the target and the best.
Plot trade_plot(const Json& study);

/// An entry of study.json's "plots".
Plot study_plot(const Json& study, const Json& entry);

}  // namespace matpoint
