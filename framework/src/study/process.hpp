#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace matpoint {

/// How a process ended.
struct ProcessEnd {
    int status = 0;  ///< exit status, if no signal ended it
    int signal = 0;  ///< the signal that ended it, or 0
};

/// A process to run: the program and its arguments. What it prints goes to the file `log`.
struct Job {
    std::size_t id = 0;
    std::vector<std::string> command;
    std::filesystem::path log;
};

struct SideBySide {
    int most = 1;  ///< processes at a time
    /// The next process to run, if there is one now. Asked again whenever one has ended.
    std::function<std::optional<Job>()> next;
    std::function<void(std::size_t id, ProcessEnd end)> ended;
    std::function<void(int running)> waiting;  ///< called many times a second
};

/// Runs processes until there is no next one and none is left. A signal that ends programs (while it
/// runs) kills those that are left; returns false then.
bool run_side_by_side(const SideBySide& work);

}  // namespace matpoint
