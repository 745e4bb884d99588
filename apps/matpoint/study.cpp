#include "study/study.hpp"

#include "study_command.hpp"
#include "verbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace matpoint {
namespace {

/// Rows by number; the front is marked.
void print_study(const Json& study) {
    std::size_t width = 0;
    for (const Json& row : study.at("variants"))
        width = std::max(width, row.at("name").get_ref<const std::string&>().size());
    std::cout << fmt::format("{:>5}   {:{}}  {:>10} {:>6} {:>10} {:>14}\n", "", "", width, "error", "order",
                             "cost", "particle steps");
    for (const Json& row : study.at("variants")) {
        std::cout << fmt::format("{:>5} {} {:{}}  ", row.at("number").get<int>(),
                                 row.at("front") == true ? '*' : ' ', row.at("name").get<std::string>(),
                                 width);
        if (row.at("status") == "completed") {
            std::cout << fmt::format("{:>10} {:>6} {:>10} {:>14}\n", cell(row.at("error")),
                                     cell(row.at("order"), "{:.2f}"), cell(row.at("cost")),
                                     cell(row.at("particle_steps"), "{:.0f}"));
        } else {
            std::cout << fmt::format("{}: {}\n", row.at("status").get<std::string>(),
                                     brief(row.at("reason")));
        }
    }
    std::cout << "* on the Pareto front: none other is both cheaper and more accurate\n";
}

void print_references(const Json& accuracy) {
    if (!accuracy.contains("reference")) return;
    for (const Json& line : accuracy.at("reference").at("lines")) {
        const std::string how =
            line.at("extrapolated") == true
                ? fmt::format("extrapolated with order {}", cell(line.at("order"), "{:.2f}"))
                : "its own value: no order of convergence can be seen";
        std::cout << fmt::format("reference for {}: {:.6g}, {}\n", line.at("finest").get<std::string>(),
                                 line.at("value").get<double>(), how);
    }
}

void print_best(const Json& study, const std::filesystem::path& folder) {
    if (!study.contains("target")) return;
    const double target = study.at("target");
    if (!study.contains("best")) {
        std::cout << fmt::format("no variant meets the target of {:g}\n", target);
        return;
    }
    const Json& best = study.at("best");
    std::cout << fmt::format(
        "cheapest with an error of at most {:g}: {} (error {}, cost {}), written as {}\n", target,
        best.at("name").get<std::string>(), cell(best.at("error")), cell(best.at("cost")),
        (folder / "best.json").string());
}

}  // namespace

int study(const std::vector<std::string>& arguments) {
    VerbOptions verb{
        .usage = "matpoint study STUDY [--output DIR] [--jobs N] [--again] [--quiet]",
        .doc =
            "Runs variants of a scene, each in a process of its own, and compares their errors and costs.\n"
            "Writes study.json, study.csv, study.html with plots, and best.json, the cheapest variant that\n"
            "meets the target, to out/<study name>, or to DIR. Runs that an earlier call measured are not\n"
            "repeated, so that an interrupted study goes on.\n"
            "Exit status: 0 done, also if no variant meets the target; 1 if none completed, or interrupted.",
        .least_arguments = 1,
        .most_arguments = 1};
    add_study_options(verb.options);
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;

    const std::filesystem::path file = arguments_of(*values).front();
    const StudyOptions options = study_options(*values, file);
    const StudyFile study = read_study_file(file);
    const bool quiet = values->count("quiet") > 0;
    if (!quiet && study.json.at("timing") == "quiet")
        std::cout << "one run at a time, so that times are measured without neighbours\n" << std::flush;
    const StudyResult result = run_study(study, options);
    if (result.interrupted) {
        tell_interruption(result, "variants measured");
        return exit_failed;
    }
    if (!quiet) {
        print_study(result.report);
        print_references(result.report.at("accuracy"));
        print_best(result.report, options.output);
        std::cout << "report: " << (options.output / "study.html").string() << "\n";
    }
    const auto completed = [](const Json& row) { return row.at("status") == "completed"; };
    if (std::ranges::any_of(result.report.at("variants"), completed)) return exit_done;
    std::cerr << "no variant completed\n";
    return exit_failed;
}

}  // namespace matpoint
