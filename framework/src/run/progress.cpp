#include "run/progress.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace matpoint {

void Progress::show(const Simulation& simulation, const RunClock& clock) {
    const double now = clock.wall_seconds();
    if (!shown_ || now < next_) return;
    next_ = now + 0.2;
    const double left =
        static_cast<double>(simulation.estimated_steps()) * now / static_cast<double>(clock.steps);
    // A terminal that was closed must not end the run as fmt::print would.
    const std::string line = fmt::format(
        "\r\033[Kstep {}  t = {:.4g} s  dt = {:.3g} s  ETA {:.0f} s  energy drift {:.1e}  {:.3g} M "
        "particle steps/s",
        simulation.step(), simulation.time(), simulation.time_step(), left,
        simulation.conservation().energy_drift, clock.particle_steps / clock.step_wall_seconds / 1e6);
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
    drawn_ = true;
}

void Progress::clear() {
    if (drawn_) std::fputs("\r\033[K", stderr);
    drawn_ = false;
}

}  // namespace matpoint
