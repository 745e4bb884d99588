#include "options.hpp"
#include "verbs.hpp"

#include "verify/run_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <regex>

namespace matpoint {
namespace {

namespace fs = std::filesystem;

/// The folder named by --output, or a temporary one that is removed at the end.
class OutputFolder {
  public:
    explicit OutputFolder(const po::variables_map& values) : kept_(values.count("output") > 0) {
        if (kept_) {
            path_ = values["output"].as<std::string>();
            return;
        }
        std::string name = (fs::temp_directory_path() / "matpoint_test_XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw fs::filesystem_error("mkdtemp", name, {errno, std::generic_category()});
        path_ = name;
    }
    ~OutputFolder() {
        std::error_code ignored;
        if (!kept_) fs::remove_all(path_, ignored);
    }
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// "configs/a/disk:analytic" -> <folder>/configs/a/disk/analytic
    fs::path of(std::string id) const {
        std::replace(id.begin(), id.end(), ':', '/');
        fs::path folder = path_;
        for (const fs::path& part : fs::path(id)) {
            if (part != ".." && part != "/") folder /= part;
        }
        return folder;
    }
    /// Temporary results are dropped at once, so that a long suite needs little space.
    void done_with(const fs::path& folder) const {
        std::error_code ignored;
        if (!kept_) fs::remove_all(folder, ignored);
    }

  private:
    bool kept_;
    fs::path path_;
};

std::vector<std::string> texts(const po::variables_map& values, const char* option) {
    if (values.count(option) == 0) return {};
    return values[option].as<std::vector<std::string>>();
}

void select(std::vector<Case>& cases, const po::variables_map& values) {
    const auto has_any = [](const Case& c, const std::vector<std::string>& tags) {
        return std::any_of(c.tags.begin(), c.tags.end(), [&](const std::string& tag) {
            return std::find(tags.begin(), tags.end(), tag) != tags.end();
        });
    };
    const std::vector<std::string> tags = texts(values, "tag"), excluded = texts(values, "exclude-tag");
    std::regex filter;
    try {
        if (values.count("filter") > 0) filter = std::regex(values["filter"].as<std::string>());
    } catch (const std::regex_error& error) {
        throw UsageError(fmt::format("--filter: not a regular expression: {}", error.what()));
    }
    std::erase_if(cases, [&](const Case& c) {
        return (values.count("filter") > 0 && !std::regex_search(c.id, filter)) ||
               (!tags.empty() && !has_any(c, tags)) || has_any(c, excluded);
    });
}

void print(const Case& test, const CaseResult& result, double seconds) {
    const bool passed = result.failures.empty();
    std::cout << fmt::format("{} {} ({:.1f} s): {}\n", passed ? "ok    " : "FAILED", test.id, seconds,
                             fmt::join(result.measured, "; "));
    for (const std::string& failure : result.failures) std::cout << "       " << failure << "\n";
    std::cout << std::flush;
}

}  // namespace

int test(const std::vector<std::string>& arguments) {
    VerbOptions verb{
        .usage = "matpoint test PATH... [--filter REGEX] [--tag TAG]... [--exclude-tag TAG]...",
        .doc =
            "Runs regression cases: *.test.json files and scenes with `checks`, and all of them below\n"
            "folders. A case is called <path without extension>:<name>.",
        .least_arguments = 1,
        .most_arguments = -1};
    const auto several = [] { return po::value<std::vector<std::string>>()->composing()->value_name("TAG"); };
    verb.options.add_options()("filter", po::value<std::string>()->value_name("REGEX"),
                               "only cases with such a name")(
        "tag", several(), "only cases with this tag; may be repeated")("exclude-tag", several(),
                                                                       "no cases with this tag")(
        "list", "print the names and tags of the cases, and run none")(
        "update-gold", "write gold files anew instead of comparing with them")(
        "output", po::value<std::string>()->value_name("DIR"), "keep the results of the runs there");
    add_threads(verb.options);
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;
    use_threads(*values);

    const std::vector<std::string> given = arguments_of(*values);
    Diagnostics mistakes;
    std::vector<Case> cases = find_cases({given.begin(), given.end()}, mistakes);
    if (!mistakes.empty()) std::cerr << mistakes.text() << "\n";
    select(cases, *values);
    if (values->count("list") > 0) {
        for (const Case& c : cases) std::cout << fmt::format("{} ({})\n", c.id, fmt::join(c.tags, ", "));
    }
    if (mistakes.has_errors()) return exit_bad_input;
    if (values->count("list") > 0) return exit_done;
    if (cases.empty()) throw UsageError("there are no such cases");

    const OutputFolder output(*values);
    std::size_t failed = 0, ran = 0;
    for (const Case& c : cases) {
        const auto start = std::chrono::steady_clock::now();
        const fs::path folder = output.of(c.id);
        const CaseResult result =
            run_case(c, {.output = folder, .update_gold = values->count("update-gold") > 0});
        output.done_with(folder);
        print(c, result, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        ++ran;
        if (!result.failures.empty()) ++failed;
        if (result.interrupted) break;
    }
    std::cout << fmt::format("{} of {} cases passed\n", ran - failed, cases.size());
    return failed > 0 ? exit_failed : exit_done;
}

}  // namespace matpoint
