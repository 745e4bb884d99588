#include "study/limits.hpp"

#include "report/limits_report.hpp"
#include "report/text_file.hpp"
#include "run/result_folder.hpp"
#include "study/files.hpp"
#include "study/limit_search.hpp"
#include "study/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matpoint {
namespace {

/// The search for one variant's limit.
class VariantSearch {
  public:
    VariantSearch(const StudyFile& study, Variant variant)
        : study_(study),
          variant_(std::move(variant)),
          search_(parameter("from"), parameter("to"), study.json.at("search").at("digits").get<int>(),
                  study.json.at("search").at("largest").get<bool>()) {}

    bool busy = false;  ///< its trial is being run

    /// The variant at the value to try next; nothing when the search is over.
    std::optional<Variant> next() const {
        const std::optional<double> value = refusal_.empty() ? search_.next() : std::nullopt;
        return value ? std::optional(at(*value)) : std::nullopt;
    }
    bool over() const { return !refusal_.empty() || !search_.next(); }

    void answer(const Variant& trial, const Outcome& outcome, const Measurement& measurement) {
        if (outcome.status == "refused") {
            refusal_ = outcome.reason;
            return;
        }
        const Json& stable = study_.json.at("stable");
        const std::string pointer = stable.at("summary");
        const double bound = stable.at("below");
        Json row{{"value", *search_.next()}, {"status", outcome.status},
                 {"stable", false},          {"reason", outcome.reason},
                 {"measured", nullptr},      {"folder", Measurement::folder(trial)}};
        if (outcome.status == "completed") {
            const double measured = std::abs(measurement.number(outcome, pointer, "/stable/summary"));
            row["stable"] = measured < bound;
            if (std::isfinite(measured)) row["measured"] = measured;
            if (!(measured < bound))
                row["reason"] = fmt::format("{} is {:.3g}, not below {:g}", pointer, measured, bound);
        }
        search_.answer(row.at("stable").get<bool>());
        trials_.push_back(std::move(row));
    }

    Json row() const {
        const auto value = [](const std::optional<double>& number) {
            return number ? Json(*number) : Json();
        };
        const char* status = !refusal_.empty()     ? "refused"
                             : !search_.stable()   ? "unstable_everywhere"
                             : !search_.unstable() ? "stable_everywhere"
                                                   : "found";
        Json row{{"number", variant_.number},
                 {"name", variant_.name},
                 {"variant", variant_.set},
                 {"settings", variant_.settings},
                 {"status", status},
                 {"limit", value(search_.stable())},
                 {"unstable", value(search_.unstable())},
                 {"unstable_status", ""},
                 {"reason", refusal_},
                 {"trials", trials_}};
        for (const Json& trial : trials_) {
            if (trial.at("value") != row.at("unstable")) continue;
            row["unstable_status"] = trial.at("status");
            row["reason"] = trial.at("reason");
        }
        return row;
    }

    Variant at(double value) const { return at(value, "/search/pointer"); }
    /// At the ends of the range and in its middle, where a value may be none that the parameter takes.
    std::vector<Variant> probes() const {
        std::vector<Variant> all{at(parameter("from"), "/search/from"), at(parameter("to"), "/search/to")};
        LimitSearch ended = search_;
        ended.answer(true);
        ended.answer(false);
        if (const auto middle = ended.next()) all.push_back(at(*middle, "/search"));
        return all;
    }
    void refuse(const std::string& why) { refusal_ = why; }

  private:
    Variant at(double value, const char* said_at) const {
        const std::string pointer = study_.json.at("search").at("pointer");
        Variant trial = variant_;
        trial.name += fmt::format(", {}={:g}", pointer.substr(pointer.rfind('/') + 1), value);
        trial.assignments.push_back({pointer, value, said_at});
        return trial;
    }
    double parameter(const char* name) const { return study_.json.at("search").at(name).get<double>(); }

    const StudyFile& study_;
    Variant variant_;
    LimitSearch search_;
    std::string refusal_;
    Json trials_ = Json::array();
};

/// Takes the searches as far as is known without running; the next trial to run, of a search that waits.
class Trials {
  public:
    Trials(std::vector<VariantSearch>& searches, const VariantScenes& scenes, Measurement& measurement)
        : searches_(searches), scenes_(scenes), measurement_(measurement), running_(searches.size()) {}

    std::optional<Job> next() {
        for (std::size_t i = 0; i < searches_.size(); ++i) {
            VariantSearch& search = searches_[i];
            while (!search.busy) {
                std::optional<Variant> trial = search.next();
                if (!trial) break;
                Diagnostics mistakes;
                scenes_.resolve(*trial, mistakes);
                mistakes.throw_if_errors();
                if (measurement_.is_running(*trial))
                    break;  // for another search, which leads to the same scene
                if (const auto outcome = measurement_.known(*trial)) {
                    search.answer(*trial, *outcome, measurement_);
                } else {
                    search.busy = true;
                    running_[i] = std::move(*trial);
                    return measurement_.prepare(running_[i], i);
                }
            }
        }
        return {};
    }

    void ended(std::size_t i, ProcessEnd end) {
        searches_[i].busy = false;
        searches_[i].answer(running_[i], measurement_.finish(running_[i], end), measurement_);
    }

    std::size_t over() const {
        return static_cast<std::size_t>(
            std::ranges::count_if(searches_, [](const VariantSearch& search) { return search.over(); }));
    }

  private:
    std::vector<VariantSearch>& searches_;
    const VariantScenes& scenes_;
    Measurement& measurement_;
    std::vector<Variant> running_;
};

}  // namespace

StudyResult run_limits(const StudyFile& study, const StudyOptions& options) {
    const VariantScenes scenes(study);
    std::vector<VariantSearch> searches;
    std::vector<Variant> probes;  // what is refused there is told before anything runs
    std::vector<std::size_t> probed;
    for (Variant& variant : make_variants(study)) {
        searches.emplace_back(study, std::move(variant));
        for (Variant& probe : searches.back().probes()) {
            probes.push_back(std::move(probe));
            probed.push_back(searches.size() - 1);
        }
    }
    scenes.resolve_all(probes);
    for (std::size_t i = 0; i < probes.size(); ++i)
        if (!probes[i].refusal.empty()) searches[probed[i]].refuse(probes[i].refusal);
    Measurement measurement(study, options);
    const ResultFolder folder(options.output);

    Trials trials(searches, scenes, measurement);
    StudyProgress progress(options.progress, searches.size());
    run_side_by_side(
        {.most = options.jobs,
         .next = [&] { return trials.next(); },
         .ended = [&](std::size_t i, ProcessEnd end) { trials.ended(i, end); },
         .waiting =
             [&](int running) { progress.show(trials.over(), searches.size() - trials.over(), running); }});

    StudyResult result;
    result.variants = searches.size();
    result.measured = trials.over();
    result.interrupted = result.measured < result.variants;
    if (result.interrupted) return result;
    Json& report = result.report;
    report = {{"title", study.title},
              {"scene", study.document->json.at("scene")},
              {"search", study.json.at("search")},
              {"stable", study.json.at("stable")},
              {"varied", varied(study)},
              {"variants", Json::array()},
              {"machine", machine()}};
    for (const VariantSearch& search : searches) report["variants"].push_back(search.row());
    folder.expect_in_place();
    write_text(options.output / "limits.json", report.dump(2) + "\n");
    write_text(options.output / "limits.csv", csv(report));
    write_limits_report(report, options.output);
    return result;
}

}  // namespace matpoint
