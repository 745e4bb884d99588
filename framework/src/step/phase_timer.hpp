#pragma once

#include "step/engine.hpp"

#include <chrono>

namespace matpoint {

/// Timers nest: the inner one's time is not the outer one's.
template <class S>
class Engine<S>::Timer {
  public:
    Timer(Engine& engine, StepPhase phase)
        : engine_(engine), phase_(phase), outside_(total(engine)), start_(Clock::now()) {}
    ~Timer() {
        const double inner = total(engine_) - outside_;
        engine_.seconds_[static_cast<std::size_t>(phase_)] +=
            std::chrono::duration<double>(Clock::now() - start_).count() - inner;
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    static double total(const Engine& engine) {
        double sum = 0;
        for (const double seconds : engine.seconds_) sum += seconds;
        return sum;
    }

    Engine& engine_;
    StepPhase phase_;
    double outside_;
    Clock::time_point start_;
};

}  // namespace matpoint
