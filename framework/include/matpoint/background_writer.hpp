#pragma once

#include <functional>
#include <future>

namespace matpoint {

/// Writes files on a thread of its own while the run goes on: one job at a time, in the order given. A job
/// that comes while the one before is at work waits for it, so that memory is bounded by what one job
/// carries.
///
/// The run changes while a job works, and nothing is locked. So a job owns copies of what it writes, and what
/// it shares with its output (a list of files, say) is the job's from submit() until wait() has returned. An
/// output calls wait(), copies, and calls submit(); its flush() is wait().
///
/// Declare it after the members that jobs use: its destructor waits for the job at work. A failure that
/// nobody waited for is lost then.
class BackgroundWriter {
  public:
    /// Waits for the job before; throws what that one threw, or begins with `job`.
    void submit(std::function<void()> job);
    /// Returns when no job is left; throws what the last one threw, once.
    void wait();

  private:
    std::future<void> job_;
};

/// Processor time that the jobs of this process have taken so far, s: it is none of the step loop's.
double background_cpu_seconds();

}  // namespace matpoint
