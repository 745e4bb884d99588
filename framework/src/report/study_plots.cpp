#include "report/study_plots.hpp"

#include "report/report_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matpoint {
namespace {

bool has_status(const Json& variant, const std::string& status) {
    return value_of(variant, "status") == status;
}

std::string description(const Json& study, const Json& variant, const std::string& x, const std::string& y) {
    std::string text = text_of(variant, "name");
    for (const std::string& key : {x, y}) {
        const Json value = value_of(variant, key);
        if (!value.is_null()) text += fmt::format("\n{}: {}", measure_label(study, key), value_label(value));
    }
    if (!has_status(variant, "completed")) {
        text += fmt::format("\n{} {}", text_of(variant, "status"), text_of(variant, "reason"));
    }
    return text;
}

/// A series for each group. A refused variant has not run, so it has no place in a plot.
std::vector<PlotSeries> series_of(const Json& study, const std::vector<VariantGroup>& groups,
                                  const std::string& x, const std::string& y, double x_divisor) {
    std::vector<PlotSeries> all;
    for (const VariantGroup& group : groups) {
        PlotSeries series{.name = group.name, .style = group.style};
        for (const Json* variant : group.variants) {
            const auto x_value = number_of(*variant, x), y_value = number_of(*variant, y);
            if (!x_value || has_status(*variant, "refused")) continue;
            const PlotPoint point{*x_value / x_divisor, y_value.value_or(0),
                                  description(study, *variant, x, y)};
            if (!has_status(*variant, "completed")) {
                series.broken.push_back(point);
            } else if (y_value) {
                series.points.push_back(point);
            }
        }
        if (!series.points.empty() || !series.broken.empty()) all.push_back(std::move(series));
    }
    return all;
}

std::optional<double> target_of(const Json& study) {
    return number_of(study, "target");
}

}  // namespace

std::string measure_label(const Json& study, const std::string& key) {
    const char* measure = key == "error" ? "accuracy" : key == "cost" ? "cost" : "";
    if (!study.contains(measure)) return key_label(key);
    const Json& described = study.at(measure);
    if (described.contains("label")) return described.at("label").get<std::string>();
    std::string words = described.value("summary", key);
    if (described.contains("measure"))
        words = text_of(described.at("measure"), "statistic") + " of " +
                text_of(described.at("measure"), "probe");
    for (char& c : words) c = c == '/' || c == '_' ? ' ' : c;
    return words.substr(std::min(words.find_first_not_of(' '), words.size()));
}

Plot trade_plot(const Json& study) {
    const std::vector<const Json*> variants = variants_of(study);
    Plot plot{.title = text_of(study, "title"),
              .x = {measure_label(study, "cost")},
              .y = {measure_label(study, "error")}};
    plot.series = series_of(study, grouped(variants, kind_keys(variants)), "cost", "error", 1);
    for (const Json* variant : variants) {
        const auto cost = number_of(*variant, "cost"), error = number_of(*variant, "error");
        if (value_of(*variant, "front") == true && cost && error) plot.front.push_back({*cost, *error});
    }
    std::sort(plot.front.begin(), plot.front.end(),
              [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
    plot.target = target_of(study);
    if (study.contains("best")) {
        const Json& best = study.at("best");
        const auto cost = number_of(best, "cost"), error = number_of(best, "error");
        if (cost && error) plot.best = {*cost, *error, "best: " + text_of(best, "name")};
    }
    return plot;
}

Plot study_plot(const Json& study, const Json& entry) {
    const std::string x = entry.value("x", "cost"), y = entry.value("y", "error");
    std::vector<const Json*> variants = variants_of(study);
    const Json where = entry.value("where", Json::object());
    for (const auto& [key, wanted] : where.items()) {
        std::erase_if(variants, [&](const Json* variant) { return value_of(*variant, key) != wanted; });
    }
    const auto lines =
        entry.contains("lines") ? entry.at("lines").get<std::vector<std::string>>() : kind_keys(variants);
    const double divisor = entry.value("x_divisor", 1.0);
    const std::string divided = divisor == 1 ? "" : fmt::format(" / {:g}", divisor);
    Plot plot{.title = entry.value("title", text_of(entry, "name")),
              .x = {entry.value("x_label", measure_label(study, x) + divided),
                    entry.value("x_scale", "log") == "log"},
              .y = {entry.value("y_label", measure_label(study, y)), entry.value("y_scale", "log") == "log"}};
    plot.series = series_of(study, grouped(variants, lines), x, y, divisor);
    plot.lines = true;
    plot.slopes = entry.value("slopes", std::vector<double>{});
    if (y == "error") plot.target = target_of(study);
    return plot;
}

}  // namespace matpoint
