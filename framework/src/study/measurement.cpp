#include "study/measurement.hpp"

#include <matpoint/input_file.hpp>
#include <matpoint/output_file.hpp>

#include "config/utf8.hpp"
#include "run/result_folder.hpp"
#include "verify/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace matpoint {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene_file = "variant.json";
constexpr const char* summary_file = "summary.json";
constexpr const char* log_file = "log.txt";

// What `matpoint run` ends with (SCENE.md).
constexpr int exit_bad_input = 2;

/// CRC-64 of ECMA-182. A folder holds the scene too, so that nothing depends on names being unique.
using Checksum = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0, 0, false, false>;

std::string text_of(const Json& scene) {
    return scene.dump(2) + "\n";
}

/// Empty if it is not there.
std::string read_text(const fs::path& file) {
    return why_unreadable(file).empty() ? read_whole(file) : "";
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

/// Null if it is not there or was cut short.
Json read_summary(const fs::path& folder) {
    Json summary = Json::parse(read_text(folder / summary_file), nullptr, false);
    return summary.is_object() && summary.contains("status") ? summary : Json();
}

Outcome outcome_of(Json summary) {
    const std::string status = summary.at("status");
    std::string reason = first_line(summary.value("reason", ""));
    // A full disk, or somebody who stopped this process alone.
    if (status != "completed" && status != "broke_down") return {"crashed", reason, std::move(summary)};
    return {status, std::move(reason), std::move(summary)};
}

}  // namespace

std::string Measurement::folder(const Variant& variant) {
    if (variant.scene.is_null()) return "";
    const std::string text = text_of(variant.scene);
    Checksum checksum;
    checksum.process_bytes(text.data(), text.size());
    return fmt::format("runs/{:016x}", checksum.checksum());
}

std::optional<Outcome> Measurement::known(const Variant& variant) const {
    if (!variant.refusal.empty()) return Outcome{"refused", variant.refusal, {}};
    const fs::path path = options_.output / folder(variant);
    if (options_.again || read_text(path / scene_file) != text_of(variant.scene)) return {};
    Json summary = read_summary(path);
    if (summary.is_null() || !fs::exists(path / measured_file())) return {};
    Outcome outcome = outcome_of(std::move(summary));
    if (outcome.status == "crashed") return {};  // it may do better next time
    return outcome;
}

Job Measurement::prepare(const Variant& variant, std::size_t id) {
    running_.insert(folder(variant));
    const fs::path path = options_.output / folder(variant);
    // A run that outlives the study that began it may still write there.
    { const ResultFolder unused(path); }
    fs::remove_all(path);
    fs::create_directories(path);
    OutputFile file(path / scene_file);
    file.write(text_of(variant.scene));
    file.commit();

    Job job{.id = id,
            .command = {options_.program.string(), "run", study_.scene.string(), "--output", path.string(),
                        "--threads", "1", "--quiet"},
            .log = path / log_file};
    for (const std::string& assignment : variant.arguments) {
        job.command.push_back("--set");
        job.command.push_back(assignment);
    }
    return job;
}

Outcome Measurement::finish(const Variant& variant, ProcessEnd end) {
    running_.erase(folder(variant));
    const fs::path path = options_.output / folder(variant);
    if (study_.json.at("keep_outputs") != true) {
        std::vector<fs::path> left;
        for (const auto& entry : fs::directory_iterator(path)) left.push_back(entry.path());
        std::erase_if(left, [this](const fs::path& file) {
            return file.filename() == scene_file || file.filename() == summary_file ||
                   file.filename() == log_file || file.filename() == measured_file();
        });
        for (const fs::path& file : left) fs::remove_all(file);
    }
    if (end.signal != 0)
        return {"crashed", fmt::format("killed by signal {} ({})", end.signal, strsignal(end.signal)), {}};
    Json summary = read_summary(path);
    if (!summary.is_null()) return outcome_of(std::move(summary));
    std::string log = as_utf8(read_text(path / log_file));
    while (log.ends_with('\n')) log.pop_back();
    if (end.status == exit_bad_input) return {"refused", log, {}};
    return {"crashed", log.empty() ? fmt::format("ended with status {}", end.status) : log, {}};
}

std::string Measurement::measured_file() const {
    const Json accuracy = study_.json.value("accuracy", Json::object());
    return accuracy.contains("measure") ? accuracy.at("measure").at("probe").get<std::string>() + ".csv" : "";
}

double Measurement::measured(const Variant& variant, const Outcome& outcome, std::string& why_not) const {
    const Json& accuracy = study_.json.at("accuracy");
    if (accuracy.contains("summary")) {
        why_not = accuracy.at("summary").get<std::string>() + " is not a finite number";
        return number(outcome, accuracy.at("summary"), "/accuracy/summary");
    }
    why_not = statistic_text(accuracy.at("measure")) + " is not a finite number";
    try {
        return statistic_of(accuracy.at("measure"), options_.output / folder(variant));
    } catch (const std::runtime_error& error) {
        why_not = error.what();
        return std::nan("");
    }
}

double Measurement::number(const Outcome& outcome, const std::string& pointer,
                           const std::string& asked_at) const {
    const Json::json_pointer at(pointer);
    // nlohmann writes numbers that are not finite as null.
    const bool there = outcome.summary.contains(at);
    if (there && outcome.summary.at(at).is_null()) return std::nan("");
    if (there && outcome.summary.at(at).is_number()) return outcome.summary.at(at).get<double>();
    std::vector<std::string> numbers;
    const Json flat = outcome.summary.flatten();
    for (const auto& [name, value] : flat.items())
        if (value.is_number()) numbers.push_back(name);
    Diagnostics mistakes;
    mistakes.add(study_.document->diagnostic(
        asked_at, fmt::format("summary.json has no number {}{}", pointer, did_you_mean(pointer, numbers))));
    throw InputError(mistakes);
}

}  // namespace matpoint
