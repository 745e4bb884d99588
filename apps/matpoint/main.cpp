// matpoint: the command line. One file per verb; SCENE.md's exit statuses are decided here.

#include "new_plugin.hpp"
#include "options.hpp"
#include "verbs.hpp"

#include "config/diagnostics.hpp"
#include "config/nearest.hpp"
#include "registry/instruction_set.hpp"
#include "registry/plugin_library.hpp"
#include "run/resource_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <new>

namespace matpoint {
namespace {

struct NamedVerb {
    std::string name, arguments, doc;
    Verb* function;
};

const std::array<NamedVerb, 10> verbs{{
    {"run", "SCENE", "run a scene", run},
    {"restart", "CHECKPOINT", "go on from a checkpoint", restart},
    {"validate", "SCENE...", "check scenes without solving; predict steps and memory", validate},
    {"list", "[KIND]", "list the components there are", list},
    {"describe", "TYPE", "describe a component: parameters, units, defaults, paper", describe},
    {"schema", "", "print a JSON Schema of scenes, for editors", schema},
    {"test", "PATH...", "run regression cases", test},
    {"study", "STUDY", "measure the trade of speed against accuracy over variants of a scene", study},
    {"limits", "STUDY", "find where variants of a scene stop being stable", limits},
    {"new_plugin", "KIND NAME", "write a plugin project that builds out of tree", new_plugin},
}};

void print_help(std::ostream& stream) {
    stream << "Matpoint, a framework for the Material Point Method\n\nusage: matpoint VERB [ARGUMENT]...\n\n";
    for (const NamedVerb& verb : verbs)
        stream << fmt::format("  {:24}{}\n", verb.name + " " + verb.arguments, verb.doc);
    stream << "\n`matpoint VERB --help` tells more; `matpoint --version` prints the version.\n"
              "Exit status: 0 done; 1 broke down, a check failed or the run could not be finished;\n"
              "2 bad input or usage; 3 a plugin or a resource of the machine is missing.\n"
              "Plugins are looked for in the folders of MATPOINT_PLUGIN_PATH too.\n";
}

int call(const std::vector<std::string>& arguments) {
    if (arguments.empty()) {
        print_help(std::cerr);
        return exit_bad_input;
    }
    const std::string& name = arguments.front();
    if (name == "--help" || name == "-h") {
        print_help(std::cout);
        return exit_done;
    }
    if (name == "--version") {
        std::cout << "matpoint " MATPOINT_VERSION " (" << instruction_set() << ")\n";
        return exit_done;
    }
    const auto verb =
        std::find_if(verbs.begin(), verbs.end(), [&](const NamedVerb& v) { return v.name == name; });
    if (verb == verbs.end()) {
        std::vector<std::string> names{"--help", "--version"};
        for (const NamedVerb& v : verbs) names.push_back(v.name);
        throw UsageError(fmt::format("unknown {} \"{}\"{}", name.starts_with('-') ? "option" : "verb", name,
                                     did_you_mean(name, names)));
    }
    return verb->function({arguments.begin() + 1, arguments.end()});
}

/// Memory that the machine doesn't have is then refused, and told, before the system kills the run.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__  // whose shadow memory is larger than any machine
    const rlim_t all =
        static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    const rlim_t most = all / 8 * 7;  // the system and others take some
    rlimit limit{};
    if (getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur <= most) return;
    limit.rlim_cur = most;
    setrlimit(RLIMIT_DATA, &limit);
#endif
}

/// What is not open is opened, on nothing: a file of results would get the number of what is missing, and
/// what is printed would go into it.
void open_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", O_RDWR);
}

int tell(int status, const std::string& text) {
    std::cout.flush();
    std::cerr << text << (text.ends_with('\n') ? "" : "\n");
    return status;
}

}  // namespace
}  // namespace matpoint

int main(int count, char** given) {
    using namespace matpoint;
    open_standard_streams();
    limit_memory();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that would be too large is told of like a full disk
    const std::vector<std::string> arguments(given + 1, given + count);
    const std::string who = arguments.empty() ? "matpoint: " : "matpoint " + arguments.front() + ": ";
    try {
        const int status = call(arguments);
        std::cout.flush();
        return std::cout ? status : tell(exit_missing, who + "standard output can't be written");
    } catch (const UsageError& error) {
        return tell(exit_bad_input, fmt::format("{}{} (see --help)", who, error.what()));
    } catch (const InputError& error) {
        return tell(exit_bad_input, error.what());
    } catch (const PluginError& error) {
        return tell(exit_missing, who + error.what());
    } catch (const ComponentFailure& failure) {  // without the memory that it needs
        return tell(exit_missing, who + failure.what());
    } catch (const ResourceError& error) {
        return tell(exit_missing, who + error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return tell(exit_missing, who + error.what());
    } catch (const std::bad_alloc& error) {
        const std::string_view text = error.what();
        return tell(exit_missing, who + std::string(text == "std::bad_alloc" ? "not enough memory" : text));
    } catch (...) {
        return tell(exit_failed, who + text_of_exception());
    }
}
