#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {

namespace po = boost::program_options;

/// The command line can't be understood.
class UsageError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What a verb takes on the command line.
struct VerbOptions {
    std::string usage;  ///< "matpoint run SCENE"
    std::string doc;    ///< what the verb does
    po::options_description options{"Options"};
    int least_arguments = 0;  ///< arguments that are not options,
    int most_arguments = 0;   ///< and the most of them; -1: any number
};

/// The options given; the other arguments are `arguments`. Nothing if --help was asked for, and
/// has been printed. Throws UsageError.
std::optional<po::variables_map> parse(VerbOptions verb, const std::vector<std::string>& given);

/// The arguments that are not options.
std::vector<std::string> arguments_of(const po::variables_map& values);

/// Of the verbs that run scenes: --threads (by default all cores), used at once.
void add_threads(po::options_description& options);
void use_threads(const po::variables_map& values);

}  // namespace matpoint
