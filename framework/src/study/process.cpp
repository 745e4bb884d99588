#include "study/process.hpp"

#include "run/signals.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

namespace matpoint {
namespace {

constexpr auto pause_between_looks = std::chrono::milliseconds(5);

void check(int error, const std::string& what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

pid_t start(const Job& job) {
    std::vector<char*> arguments;
    for (const std::string& text : job.command) arguments.push_back(const_cast<char*>(text.c_str()));
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t files;
    check(posix_spawn_file_actions_init(&files), "posix_spawn");
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, job.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0644);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
    pid_t process = 0;
    const int error =
        posix_spawn(&process, job.command.front().c_str(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    check(error, "can't start " + job.command.front());
    return process;
}

/// The processes that run; those that still do when it goes are killed.
class Running {
  public:
    Running() = default;
    ~Running() {
        for (const Child& child : children_) kill(child.process, SIGKILL);
        for (const Child& child : children_) waitpid(child.process, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    int count() const { return static_cast<int>(children_.size()); }
    void add(const Job& job) { children_.push_back({job.id, start(job)}); }

    /// One that has ended is told of and forgotten; false if none has.
    bool collect(const std::function<void(std::size_t, ProcessEnd)>& ended) {
        for (auto child = children_.begin(); child != children_.end(); ++child) {
            int status = 0;
            if (waitpid(child->process, &status, WNOHANG) != child->process) continue;
            const std::size_t id = child->id;
            children_.erase(child);
            if (WIFSIGNALED(status)) {
                ended(id, {.status = 0, .signal = WTERMSIG(status)});
            } else {
                ended(id, {.status = WEXITSTATUS(status), .signal = 0});
            }
            return true;
        }
        return false;
    }

  private:
    struct Child {
        std::size_t id;
        pid_t process;
    };
    std::vector<Child> children_;
};

}  // namespace

bool run_side_by_side(const SideBySide& work) {
    const SignalGuard signals;
    Running running;
    for (;;) {
        while (running.count() < work.most) {
            const std::optional<Job> job = work.next();
            if (!job) break;
            running.add(*job);
        }
        if (running.count() == 0) return true;
        // Signals first: Ctrl-C interrupts the children too, and that is no end to tell of.
        bool ended = false;
        while (!ended) {
            std::this_thread::sleep_for(pause_between_looks);
            if (signals_received()) return false;
            ended = running.collect(work.ended);
            work.waiting(running.count());
        }
    }
}

}  // namespace matpoint
