#pragma once

#include "run/clock.hpp"
#include "run/simulation.hpp"

namespace matpoint {

/// One line on standard error that is rewritten a few times a second.
class Progress {
  public:
    explicit Progress(bool shown) : shown_(shown) {}
    void show(const Simulation& simulation, const RunClock& clock);
    void clear();

  private:
    bool shown_;
    bool drawn_ = false;
    double next_ = 0.2;  // s of wall time
};

}  // namespace matpoint
