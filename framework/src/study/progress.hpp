#pragma once

#include <chrono>

namespace matpoint {

/// One line on standard error about runs side by side, rewritten a few times a second.
class StudyProgress {
  public:
    StudyProgress(bool shown, std::size_t total) : shown_(shown), total_(total) {}
    ~StudyProgress();
    StudyProgress(const StudyProgress&) = delete;
    StudyProgress& operator=(const StudyProgress&) = delete;

    /// `measured` runs ended since the start, after which `left` are still to end.
    void show(std::size_t measured, std::size_t left, int running);

  private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    std::size_t total_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now(), next_ = start_;
};

}  // namespace matpoint
