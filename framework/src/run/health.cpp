#include "run/health.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace matpoint {

namespace {

std::string at(const Moment& moment) {
    return fmt::format("step {}, t = {:.6g} s (dt = {:.4g} s): ", moment.step, moment.time, moment.dt);
}

template <class S>
std::string name(const Particles<S>& particles, Index p) {
    const typename S::Vector x = particles.position(p);
    return fmt::format("particle {} of body \"{}\" at ({:.6g})", particles.ids()[static_cast<std::size_t>(p)],
                       particles.body(), fmt::join(x.data(), x.data() + S::dimension, ", "));
}

}  // namespace

template <class S>
std::string describe_stray(const Moment& moment, const Particles<S>& particles, Index particle,
                           const Patch<S>& patch) {
    const auto low = patch.min(), high = patch.node_position(patch.cells());
    if (!particles.position(particle).allFinite())
        return at(moment) + name(particles, particle) +
               " has no finite position. The step before was probably unstable: lower /time/cfl or "
               "/time/step.";
    return at(moment) + name(particles, particle) +
           fmt::format(
               " left the grid, which reaches from ({:.6g}) to ({:.6g}). Enlarge /grid, close the face with "
               "a boundary "
               "condition, or set /health/off_grid to \"delete\" to let particles go.",
               fmt::join(low.data(), low.data() + S::dimension, ", "),
               fmt::join(high.data(), high.data() + S::dimension, ", "));
}

template <class S>
std::string describe_fault(const Moment& moment, const Particles<S>& particles, const Fault& fault,
                           double stable_step, const Origin& material) {
    const std::string who = at(moment) + name(particles, fault.particle);
    if (fault.kind == Fault::Kind::wave_speed)
        return who + fmt::format(
                         " gets the wave speed {:.4g} m/s from its material, {}: {}. Correct "
                         "the material's wave_speed or squared_wave_speed, which must be finite and not "
                         "negative, or its parameters.",
                         fault.value, material.pointer, to_string(material));
    const std::string step = fmt::format(
        " The stable step was estimated as {:.4g} s: lower /time/cfl or /time/step, or choose another "
        "integrator or a smoother "
        "shape function.",
        stable_step);
    if (fault.kind == Fault::Kind::inverted)
        return who +
               fmt::format(
                   " turned inside out: its volume changed by the factor {:.4g} in one step (J <= 0). Either "
                   "the step is too "
                   "long or the load crushes the material.",
                   fault.value) +
               step;
    return who + " has a velocity or stress that is not finite." + step;
}

std::string describe_failure(const Moment& moment, const ComponentFailure& failure) {
    return at(moment) + failure.what();
}

std::string describe_missing_waves(const Moment& moment, const std::string& body, const Origin& material) {
    return at(moment) +
           fmt::format(
               "body \"{}\" is under stress, but its material says that no wave runs in it (speed 0), "
               "so that no limit of the time step is known. {}: correct the wave_speed or "
               "squared_wave_speed of the {}; where it is meant, set /time/step or /time/wave_speed.",
               body, material.pointer, to_string(material));
}

std::string describe_formula(const Moment& moment, const std::vector<std::string>& places,
                             const FormulaError& error) {
    return fmt::format("{}{}: {}", at(moment), fmt::join(places, ", "), error.what());
}

std::string describe_standstill(const Moment& moment) {
    return at(moment) +
           "the step is too short for the time to advance: a particle or wave speed has become huge or is "
           "not a number. Look for extreme material constants or velocities, or set /time/step.";
}

std::string describe_unstable_step(const Moment& moment, double stable_step, double wave_speed,
                                   double particle_speed) {
    return at(moment) + fmt::format(
                            "the step is longer than the stable one, {:.4g} s = cell size / (wave speed "
                            "{:.4g} m/s + particle "
                            "speed {:.4g} m/s). Lower /time/step or /time/cfl, or set /health/unstable_step "
                            "to \"warn\" or "
                            "\"ignore\".",
                            stable_step, wave_speed, particle_speed);
}

#define MATPOINT_INSTANTIATE(S)                                                                      \
    template std::string describe_stray(const Moment&, const Particles<S>&, Index, const Patch<S>&); \
    template std::string describe_fault(const Moment&, const Particles<S>&, const Fault&, double,    \
                                        const Origin&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
