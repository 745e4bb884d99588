#include "study/rows.hpp"

#include "study/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace matpoint {
namespace {

/// What rows take over from summary.json.
constexpr const char* taken[] = {"particle_steps", "steps",        "particles",
                                 "cpu_seconds",    "wall_seconds", "peak_memory_bytes"};

double number_in(const Json& row, const char* key) {
    return row.at(key).is_number() ? row.at(key).get<double>() : std::nan("");
}

bool completed(const Json& row) {
    return row.at("status") == "completed";
}

/// NaN becomes null.
Json json_of(double number) {
    return std::isfinite(number) ? Json(number) : Json();
}

}  // namespace

void Rows::add(const Variant& variant, const Outcome& outcome) {
    Json row{{"number", variant.number}, {"name", variant.name},
             {"variant", variant.set},   {"settings", variant.settings},
             {"status", outcome.status}, {"reason", outcome.reason},
             {"error", nullptr},         {"cost", nullptr},
             {"value", nullptr}};
    for (const char* key : taken)
        row[key] = outcome.summary.is_object() ? outcome.summary.value(key, Json()) : Json();
    row["order"] = nullptr;
    row["front"] = row["front_particle_steps"] = false;
    row["folder"] = Measurement::folder(variant);
    const std::string cost = study_.json.at("cost").at("summary");
    if (outcome.summary.is_object()) row["cost"] = json_of(number_at(outcome.summary, cost));
    if (outcome.status == "completed") {
        measurement_.number(outcome, cost, "/cost/summary");
        std::string why_not;
        const double value = measurement_.measured(variant, outcome, why_not);
        row["value"] = json_of(value);
        if (!std::isfinite(value)) {
            row["status"] = "broke_down";
            row["reason"] = why_not;
        }
    }
    rows_.push_back(std::move(row));
    sizes_.push_back(number_at(variant.scene, study_.json.at("accuracy").at("along")));
}

void Rows::compare() {
    accuracy_ = study_.json.at("accuracy");
    const std::vector<Line> all = lines();
    if (accuracy_.contains("reference")) {
        refer_to_finest(all);
    } else {
        take_errors();
    }
    find_orders(all);
    find_front("cost", "front");
    find_front("particle_steps", "front_particle_steps");
}

/// Rows that completed and differ along the refining axis alone, the finest first.
std::vector<Rows::Line> Rows::lines() const {
    const std::string along = study_.json.at("accuracy").at("along");
    std::map<std::string, Line> by_others;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!completed(rows_[i]) || !rows_[i].at("settings").contains(along) || !std::isfinite(sizes_[i]))
            continue;
        Json others = rows_[i].at("settings");
        others.erase(along);
        by_others[rows_[i].at("variant").dump() + others.dump()].push_back(i);
    }
    std::vector<Line> all;
    for (auto& [others, line] : by_others) {
        std::ranges::sort(line, {}, [&](std::size_t i) { return sizes_[i]; });
        all.push_back(std::move(line));
    }
    std::ranges::sort(all, {}, [](const Line& line) { return line.front(); });
    return all;
}

void Rows::take_errors() {
    const double exact = accuracy_.value("exact", 0.0);
    const double scale = accuracy_.value("scale", exact == 0 ? 1.0 : std::abs(exact));
    for (Json& row : rows_)
        if (completed(row)) row["error"] = json_of(std::abs(number_in(row, "value") - exact) / scale);
}

void Rows::refer_to_finest(const std::vector<Line>& lines) {
    Json references = Json::array();
    for (const Line& line : lines) {
        const auto value = [&](std::size_t k) { return number_in(rows_[line[k]], "value"); };
        Extrapolation reference{.limit = value(0), .order = {}};
        if (line.size() >= 3)
            reference = extrapolate({sizes_[line[0]], sizes_[line[1]], sizes_[line[2]]},
                                    {value(0), value(1), value(2)});
        const double scale = accuracy_.value("scale", std::abs(reference.limit));
        // Without an order the finest is the reference, and its own error is not known.
        for (std::size_t k = reference.order ? 0 : 1; k < line.size(); ++k)
            rows_[line[k]]["error"] = json_of(std::abs(value(k) - reference.limit) / scale);
        Json settings = rows_[line[0]].at("settings");
        settings.erase(accuracy_.at("along").get<std::string>());
        references.push_back({{"variant", rows_[line[0]].at("variant")},
                              {"settings", settings},
                              {"value", reference.limit},
                              {"order", reference.order ? Json(*reference.order) : Json()},
                              {"finest", rows_[line[0]].at("name")},
                              {"extrapolated", reference.order.has_value()}});
    }
    accuracy_["reference"] = {{"along", accuracy_.at("along")}, {"lines", references}};
}

void Rows::find_orders(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const std::size_t fine = line[k], coarse = line[k + 1];
            rows_[fine]["order"] = json_of(observed_order(sizes_[fine], number_in(rows_[fine], "error"),
                                                          sizes_[coarse], number_in(rows_[coarse], "error")));
        }
    }
}

void Rows::find_front(const char* cost, const char* key) {
    std::vector<std::pair<double, double>> points;
    for (const Json& row : rows_) points.emplace_back(number_in(row, cost), number_in(row, "error"));
    const std::vector<bool> front = pareto_front(points);
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i][key] = static_cast<bool>(front[i]);
}

namespace {
void expect_probe(const StudyFile& study, const std::vector<Variant>& variants, const std::string& probe) {
    for (const Variant& variant : variants) {
        if (variant.scene.is_null()) continue;
        const auto has_name = [&](const Json& output) { return output.value("name", Json()) == probe; };
        if (std::ranges::any_of(variant.scene.at("outputs"), has_name)) continue;
        Diagnostics mistakes;
        mistakes.add(study.document->diagnostic(
            "/accuracy/measure/probe", fmt::format("the scene has no probe {}", Json(probe).dump())));
        mistakes.throw_if_errors();
    }
}
}  // namespace

void check_accuracy(const StudyFile& study, const std::vector<Variant>& variants) {
    const Json& accuracy = study.json.at("accuracy");
    if (accuracy.contains("measure"))
        return expect_probe(study, variants, accuracy.at("measure").at("probe"));
    if (!accuracy.at("summary").get<std::string>().starts_with("/error")) return;
    for (const Variant& variant : variants) {
        if (variant.scene.is_null() || variant.scene.contains("exact_solution")) continue;
        Diagnostics mistakes;
        mistakes.add(study.document->diagnostic(
            "/accuracy/summary",
            fmt::format("summary.json has errors only if the scene has an `exact_solution`, which {} lacks "
                        "(\"reference\": \"finest\" needs none)",
                        variant.name)));
        mistakes.throw_if_errors();
    }
}

}  // namespace matpoint
