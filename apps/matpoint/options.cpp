#include "options.hpp"

#include <matpoint/parallel.hpp>

#include "config/nearest.hpp"

#include <fmt/format.h>

#include <iostream>
#include <thread>

namespace matpoint {
namespace {

constexpr const char* arguments_name = "arguments";

std::string unknown_option(const std::string& option, const po::options_description& options) {
    std::vector<std::string> names;
    for (const auto& known : options.options()) names.push_back("--" + known->long_name());
    return fmt::format("unknown option {}{}", option, did_you_mean(option, names));
}

}  // namespace

std::optional<po::variables_map> parse(VerbOptions verb, const std::vector<std::string>& given) {
    verb.options.add_options()("help", "print this");
    po::options_description all;
    all.add(verb.options).add_options()(arguments_name, po::value<std::vector<std::string>>());
    po::positional_options_description positional;
    positional.add(arguments_name, -1);

    po::variables_map values;
    try {
        using namespace po::command_line_style;
        po::store(po::command_line_parser(given)
                      .options(all)
                      .positional(positional)
                      .style(unix_style & ~allow_guessing)
                      .run(),
                  values);
        po::notify(values);
    } catch (const po::unknown_option& error) {
        throw UsageError(unknown_option(error.get_option_name(), verb.options));
    } catch (const po::error& error) {
        throw UsageError(error.what());
    }
    if (values.count("help") > 0) {
        std::cout << "usage: " << verb.usage << "\n\n" << verb.doc << "\n\n" << verb.options;
        return {};
    }
    const auto count = static_cast<int>(arguments_of(values).size());
    if (count < verb.least_arguments || (verb.most_arguments >= 0 && count > verb.most_arguments)) {
        throw UsageError(fmt::format("{} arguments; usage: {}",
                                     count < verb.least_arguments ? "too few" : "too many", verb.usage));
    }
    return values;
}

std::vector<std::string> arguments_of(const po::variables_map& values) {
    if (values.count(arguments_name) == 0) return {};
    return values[arguments_name].as<std::vector<std::string>>();
}

void add_threads(po::options_description& options) {
    options.add_options()("threads", po::value<int>()->value_name("N"),
                          "threads to use; by default all cores");
}

/// More than machines have; the scheduler itself breaks down from some tens of thousands on.
constexpr int most_threads = 4096;

void use_threads(const po::variables_map& values) {
    int count = static_cast<int>(std::thread::hardware_concurrency());
    if (values.count("threads") > 0) {
        count = values["threads"].as<int>();
        if (count < 1 || count > most_threads)
            throw UsageError(
                fmt::format("--threads: expected a whole number from 1 to {}, got {}", most_threads, count));
    }
    set_threads(count);
}

}  // namespace matpoint
