#include "study/limits.hpp"

#include "study_command.hpp"
#include "verbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace matpoint {
namespace {

std::string outcome(const Json& row, const Json& search) {
    const std::string status = row.at("status"), why = brief(row.at("reason"));
    if (status == "refused") return "refused: " + why;
    if (status == "unstable_everywhere")
        return fmt::format("unstable everywhere from {:g} to {:g}: {}", search.at("from").get<double>(),
                           search.at("to").get<double>(), why);
    const double limit = row.at("limit");
    if (status == "stable_everywhere") return fmt::format("{:g} (stable at the end of the range)", limit);
    return fmt::format("{:g} (at {:g}: {})", limit, row.at("unstable").get<double>(), why);
}

void print_limits(const Json& limits) {
    const Json& search = limits.at("search");
    std::size_t width = 0;
    for (const Json& row : limits.at("variants"))
        width = std::max(width, row.at("name").get_ref<const std::string&>().size());
    std::cout << fmt::format("{} stable {}\n", search.at("largest") == true ? "largest" : "smallest",
                             search.at("pointer").get<std::string>());
    for (const Json& row : limits.at("variants"))
        std::cout << fmt::format("{:>5}   {:{}}  {}\n", row.at("number").get<int>(),
                                 row.at("name").get<std::string>(), width, outcome(row, search));
}

}  // namespace

int limits(const std::vector<std::string>& arguments) {
    VerbOptions verb{.usage = "matpoint limits STUDY [--output DIR] [--jobs N] [--again] [--quiet]",
                     .doc =
                         "Finds by bisection where variants of a scene stop being stable. Writes "
                         "limits.json, limits.csv and\n"
                         "limits.html to out/<study name>, or to DIR. Runs that an earlier call measured are "
                         "not repeated.\n"
                         "Exit status: 0 done; 1 if no variant has a stable value, or interrupted.",
                     .least_arguments = 1,
                     .most_arguments = 1};
    add_study_options(verb.options);
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;

    const std::filesystem::path file = arguments_of(*values).front();
    const StudyOptions options = study_options(*values, file);
    const StudyResult result = run_limits(read_limits_file(file), options);
    if (result.interrupted) {
        tell_interruption(result, "limits found");
        return exit_failed;
    }
    if (values->count("quiet") == 0) {
        print_limits(result.report);
        std::cout << "report: " << (options.output / "limits.html").string() << "\n";
    }
    const auto has_limit = [](const Json& row) { return !row.at("limit").is_null(); };
    if (std::ranges::any_of(result.report.at("variants"), has_limit)) return exit_done;
    std::cerr << "no variant is stable anywhere in the range\n";
    return exit_failed;
}

}  // namespace matpoint
