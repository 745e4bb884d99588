#include "study_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <thread>

namespace matpoint {
namespace {

/// More processes at a time than any machine has cores.
constexpr int most_jobs = 4096;
constexpr std::size_t longest_reason = 100;

}  // namespace

void add_study_options(po::options_description& options) {
    options.add_options()("output", po::value<std::string>()->value_name("DIR"), "folder for results")(
        "jobs", po::value<int>()->value_name("N"), "runs at a time; by default as many as there are cores")(
        "again", "measure anew what an earlier call measured")("quiet", "neither progress nor a table");
}

StudyOptions study_options(const po::variables_map& values, const std::filesystem::path& file) {
    StudyOptions options;
    options.program = std::filesystem::read_symlink("/proc/self/exe");
    options.output = values.count("output") > 0 ? std::filesystem::path(values["output"].as<std::string>())
                                                : "out" / file.stem();
    options.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    if (values.count("jobs") > 0) {
        options.jobs = values["jobs"].as<int>();
        if (options.jobs < 1 || options.jobs > most_jobs)
            throw UsageError(
                fmt::format("--jobs: expected a whole number from 1 to {}, got {}", most_jobs, options.jobs));
    }
    options.again = values.count("again") > 0;
    options.progress = values.count("quiet") == 0 && isatty(STDERR_FILENO) == 1;
    return options;
}

void tell_interruption(const StudyResult& result, const char* what) {
    std::cerr << fmt::format("interrupted with {} of {} {}; the same call goes on from here\n",
                             result.measured, result.variants, what);
}

std::string cell(const Json& number, const char* format) {
    return number.is_number() ? fmt::format(fmt::runtime(format), number.get<double>()) : "";
}

std::string brief(const std::string& reason) {
    const std::string line = reason.substr(0, reason.find('\n'));
    return line.size() <= longest_reason ? line : line.substr(0, line.rfind(' ', longest_reason)) + " ...";
}

}  // namespace matpoint
