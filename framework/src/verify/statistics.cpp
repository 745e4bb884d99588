#include "verify/statistics.hpp"

#include "verify/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {
namespace {

/// The rows of a probe's column that are looked at, and the level for statistics that count times.
struct Samples {
    std::vector<double> times, values;
    double level = 0;
};

using Statistic = std::function<double(const Samples&)>;

/// Time of the first row where `holds(value, level)`.
template <class Compare>
double first_time(const Samples& samples, Compare holds) {
    for (std::size_t i = 0; i < samples.times.size(); ++i) {
        if (holds(samples.values[i], samples.level)) return samples.times[i];
    }
    throw std::runtime_error(fmt::format("the level {:g} is never passed", samples.level));
}

/// Sum of the intervals that begin at a row where `holds(value, level)`.
template <class Compare>
double total_time(const Samples& samples, Compare holds) {
    double total = 0;
    for (std::size_t i = 0; i + 1 < samples.times.size(); ++i) {
        if (holds(samples.values[i], samples.level)) total += samples.times[i + 1] - samples.times[i];
    }
    return total;
}

double mean(const Samples& samples) {
    return std::reduce(samples.values.begin(), samples.values.end()) /
           static_cast<double>(samples.values.size());
}

/// std::min_element and max_element would pass over what is not a number.
template <class Compare>
double extreme(const Samples& samples, Compare beats) {
    double most = samples.values.front();
    for (const double value : samples.values) {
        if (beats(value, most) || std::isnan(value)) most = value;
    }
    return most;
}

const std::map<std::string, Statistic>& level_statistics() {
    static const std::map<std::string, Statistic> statistics{
        {"first_time_above", [](const Samples& s) { return first_time(s, std::greater<>()); }},
        {"first_time_below", [](const Samples& s) { return first_time(s, std::less<>()); }},
        {"total_time_above", [](const Samples& s) { return total_time(s, std::greater<>()); }},
        {"total_time_below", [](const Samples& s) { return total_time(s, std::less<>()); }}};
    return statistics;
}

const std::map<std::string, Statistic>& value_statistics() {
    static const std::map<std::string, Statistic> statistics{
        {"mean", mean},
        {"last", [](const Samples& s) { return s.values.back(); }},
        {"min", [](const Samples& s) { return extreme(s, std::less<>()); }},
        {"max", [](const Samples& s) { return extreme(s, std::greater<>()); }}};
    return statistics;
}

Samples samples_of(const Json& check, const Table& table) {
    const std::vector<double>& times = table.column("time");
    const std::vector<double>& values =
        table.column(check.contains("column") ? check.at("column").get<std::string>() : table.only_column());
    const double from = check.value("from", -std::numeric_limits<double>::infinity());
    const double to = check.value("to", std::numeric_limits<double>::infinity());
    Samples samples{.times = {}, .values = {}, .level = check.value("level", 0.0)};
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] < from || times[i] > to) continue;
        samples.times.push_back(times[i]);
        samples.values.push_back(values[i]);
    }
    if (samples.times.empty())
        throw std::runtime_error(fmt::format("{} has no row in the times asked for", table.file.string()));
    return samples;
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto* statistics : {&value_statistics(), &level_statistics()}) {
        for (const auto& entry : *statistics) all.push_back(entry.first);
    }
    return all;
}

}  // namespace

void describe_statistic(Schema& schema) {
    schema
        .choice("statistic",
                {.doc = "What is taken; a time has the resolution of the rows", .choices = names()})
        .text("probe", {.doc = "Name of a probe among the scene's outputs"})
        .text("column", {.doc = "Column of the file; needed if it has several beside time", .optional = true})
        .number("level", {.doc = "Value that the column is compared with (SI)", .optional = true})
        .number("from", {.unit = "s", .doc = "Earlier rows are left out", .optional = true})
        .number("to", {.unit = "s", .doc = "Later rows are left out", .optional = true})
        .refuse("/level", "a time needs a level, and nothing else has one", [](const Json& own, const Json&) {
            if (!own.contains("statistic") || !own.at("statistic").is_string()) return false;
            return level_statistics().contains(own.at("statistic").get<std::string>()) !=
                   own.contains("level");
        });
}

std::string statistic_text(const Json& own) {
    const std::string name = own.at("statistic"), probe = own.at("probe");
    return own.contains("level") ? fmt::format("{} {:g} of {}", name, own.at("level").get<double>(), probe)
                                 : name + " of " + probe;
}

double statistic_of(const Json& own, const std::filesystem::path& folder) {
    const std::string name = own.at("statistic");
    const auto& statistics = level_statistics().contains(name) ? level_statistics() : value_statistics();
    return statistics.at(name)(
        samples_of(own, read_table(folder / (own.at("probe").get<std::string>() + ".csv"))));
}

}  // namespace matpoint
