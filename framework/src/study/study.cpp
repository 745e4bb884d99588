#include "study/study.hpp"

#include "report/report.hpp"
#include "report/text_file.hpp"
#include "run/result_folder.hpp"
#include "study/files.hpp"
#include "study/progress.hpp"
#include "study/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace matpoint {
namespace {

/// The outcomes of all variants; fewer if a signal came.
std::vector<std::optional<Outcome>> measure(const std::vector<Variant>& variants, Measurement& measurement,
                                            const StudyFile& study, const StudyOptions& options) {
    std::vector<std::optional<Outcome>> outcomes(variants.size());
    std::deque<std::size_t> waiting;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        outcomes[i] = measurement.known(variants[i]);
        if (!outcomes[i]) waiting.push_back(i);
    }
    StudyProgress progress(options.progress, variants.size());
    std::size_t measured = 0, left = waiting.size();
    const auto tell = [&](std::size_t i, const Outcome& outcome) {
        outcomes[i] = outcome;
        ++measured;
        --left;
    };
    // Variants may come to the same scene, which is run once.
    const auto next = [&]() -> std::optional<Job> {
        for (auto at = waiting.begin(); at != waiting.end();) {
            const std::size_t i = *at;
            if (measurement.is_running(variants[i])) {
                ++at;
                continue;
            }
            at = waiting.erase(at);
            const std::optional<Outcome> known = measurement.known(variants[i]);
            if (!known) return measurement.prepare(variants[i], i);
            tell(i, *known);
        }
        return {};
    };
    run_side_by_side(
        {.most = study.json.at("timing") == "quiet" ? 1 : options.jobs,
         .next = next,
         .ended = [&](std::size_t i, ProcessEnd end) { tell(i, measurement.finish(variants[i], end)); },
         .waiting = [&](int running) { progress.show(measured, left, running); }});
    return outcomes;
}

/// The cheapest variant that meets the target.
const Json* best_row(const Json& rows, double target) {
    const Json* best = nullptr;
    for (const Json& row : rows) {
        if (row.at("error").is_null() || row.at("cost").is_null() || row.at("error").get<double>() > target)
            continue;
        if (!best || row.at("cost").get<double>() < best->at("cost").get<double>()) best = &row;
    }
    return best;
}

Json write_best(const StudyFile& study, const Json& row, const VariantScenes& scenes, const Variant& variant,
                const std::filesystem::path& folder) {
    Json scene = scenes.scene_to_keep(variant);
    scene["comment"] =
        fmt::format("The cheapest variant of the study \"{}\" with an error of at most {:g}: {}", study.title,
                    study.json.at("target").get<double>(), variant.name);
    write_text(folder / "best.json", scene.dump(2) + "\n");
    return {{"number", row.at("number")},
            {"name", row.at("name")},
            {"error", row.at("error")},
            {"cost", row.at("cost")},
            {"scene", "best.json"}};
}

}  // namespace

StudyResult run_study(const StudyFile& study, const StudyOptions& options) {
    const VariantScenes scenes(study);
    std::vector<Variant> variants = make_variants(study);
    scenes.resolve_all(variants);
    check_accuracy(study, variants);
    Measurement measurement(study, options);
    const ResultFolder folder(options.output);
    const auto outcomes = measure(variants, measurement, study, options);

    StudyResult result;
    result.variants = variants.size();
    result.measured = static_cast<std::size_t>(
        std::ranges::count_if(outcomes, [](const auto& outcome) { return outcome.has_value(); }));
    result.interrupted = result.measured < variants.size();
    if (result.interrupted) return result;

    Rows rows(study, measurement);
    for (std::size_t i = 0; i < variants.size(); ++i) rows.add(variants[i], *outcomes[i]);
    rows.compare();
    Json& report = result.report;
    report = {{"title", study.title},
              {"scene", study.document->json.at("scene")},
              {"accuracy", rows.accuracy()},
              {"cost", study.json.at("cost")},
              {"timing", study.json.at("timing")},
              {"varied", varied(study)}};
    if (study.json.contains("target")) report["target"] = study.json.at("target");
    report["variants"] = rows.json();
    folder.expect_in_place();
    std::filesystem::remove(options.output / "best.json");
    if (study.json.contains("target")) {
        if (const Json* best = best_row(report.at("variants"), report.at("target"))) {
            const auto number = best->at("number").get<std::size_t>();
            report["best"] = write_best(study, *best, scenes, variants[number - 1], options.output);
        }
    }
    report["plots"] = study.json.value("plots", Json::array());
    report["machine"] = machine();
    write_text(options.output / "study.json", report.dump(2) + "\n");
    write_text(options.output / "study.csv", csv(report));
    write_report(report, options.output);
    return result;
}

}  // namespace matpoint
