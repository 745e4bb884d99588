#pragma once

#include <matpoint/background_writer.hpp>

#include <chrono>
#include <ctime>

namespace matpoint {

/// Time spent in the step loop, output excluded, and since the start.
class RunClock {
  public:
    RunClock() : start_(std::chrono::steady_clock::now()) {}

    double wall_seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    double step_wall_seconds = 0;
    double step_cpu_seconds = 0;  ///< of all threads that compute
    long steps = 0;
    double particle_steps = 0;

  private:
    std::chrono::steady_clock::time_point start_;
};

/// Adds the time of its life to a clock's step loop.
class StepTimer {
  public:
    explicit StepTimer(RunClock& clock) : clock_(clock), wall_(clock.wall_seconds()), cpu_(cpu_seconds()) {}
    ~StepTimer() {
        clock_.step_wall_seconds += clock_.wall_seconds() - wall_;
        clock_.step_cpu_seconds += cpu_seconds() - cpu_;
    }
    StepTimer(const StepTimer&) = delete;
    StepTimer& operator=(const StepTimer&) = delete;

  private:
    static double cpu_seconds() {
        return static_cast<double>(std::clock()) / CLOCKS_PER_SEC - background_cpu_seconds();
    }

    RunClock& clock_;
    double wall_, cpu_;
};

}  // namespace matpoint
