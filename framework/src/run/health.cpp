#include "run/health.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace matpoint {

namespace {

std::string at(const Moment& moment) {
    return fmt::format("step {}, t = {:.6g} s (dt = {:.4g} s): ", moment.step, moment.time, moment.dt);
}

template <class S>
std::string name(const Particles<S>& particles, Index p) {
    const typename S::Position x = particles.position(p);
    return fmt::format("particle {} of body \"{}\" at ({:.6g})", particles.ids()[static_cast<std::size_t>(p)],
                       particles.body(), fmt::join(x.data(), x.data() + S::dimension, ", "));
}

}  // namespace

template <class S>
std::string describe_stray(const Moment& moment, const Particles<S>& particles, Index particle,
                           const std::optional<Exit>& exit, const std::string& ailments) {
    if (!exit)
        return at(moment) + name(particles, particle) +
               " has no finite position. The step before was probably unstable: lower /time/cfl or "
               "/time/step.";
    const std::string who = at(moment) + name(particles, particle) + " left the grid through " + exit->face;
    switch (exit->through) {
        case Exit::Through::closed:
            return who + fmt::format(
                             ", {:.2g} cells in one step, although the face is closed: nodes beside it are "
                             "too fast for this step. Lower /time/cfl or /time/step, or choose another "
                             "integrator or a smoother shape function.",
                             exit->distance);
        case Exit::Through::outflow:
            return who +
                   ", carried by the velocity that is prescribed there. Enlarge /grid, or set "
                   "/health/off_grid to \"delete\" to let particles go.";
        case Exit::Through::open:
            break;
    }
    const std::string advice =
        "Enlarge /grid, close the face (by \"slip\", say), or set /health/off_grid to \"delete\" to let "
        "particles "
        "go.";
    return who + ". " + (ailments.empty() ? advice : ailments + " If it is meant: " + advice);
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

std::string describe_torn(const std::string& body, const std::vector<Index>& parts, double spacing) {
    constexpr std::size_t named = 4;
    const std::span<const Index> largest(parts.data(), std::min(parts.size(), named));
    return fmt::format(
        "Body \"{}\" is torn: it is in {} parts (of {}{} particles) that share no node of the grid and so "
        "don't feel each other. Where it is pulled most, its particles lie {:.2g} cells apart; they hold "
        "together up to about one. Where that is not meant, take more particles_per_cell along the pull, or "
        "larger cells.",
        body, parts.size(), fmt::join(largest, ", "), parts.size() > named ? ", …" : "", spacing);
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

std::string describe_unstable_step(const Moment& moment, double stable_step, double part, double wave_speed,
                                   double particle_speed) {
    const std::string limit =
        part < 1 - 1e-6 ? fmt::format("{:.3g} (of this integrator and shape function) x ", part) : "";
    return at(moment) +
           fmt::format(
               "the step is longer than the stable one, {:.4g} s = {}cell size / (wave speed {:.4g} m/s + "
               "particle speed {:.4g} m/s). Lower /time/step or /time/cfl, or set /health/unstable_step to "
               "\"warn\" or \"ignore\".",
               stable_step, limit, wave_speed, particle_speed);
}

std::string describe_energy_gain(const Moment& moment, double gain, double given, double noise) {
    return at(moment) +
           fmt::format(
               "{:.4g} J of energy came from nowhere; the start, loads and walls have given {:.4g} J. Noise "
               "grows, {:.2g} % of the velocity is none that the grid sees: lower /time/cfl or /time/step, "
               "choose another integrator, a smoother shape function or a transfer that damps, or, if it can "
               "be meant, raise /health/energy_gain.",
               gain, given, 100 * noise);
}

std::string describe_energy_drift(double gain, double loss, double largest, double noise) {
    const bool gained = gain > loss;
    return fmt::format(
        "{:.3g} % of the energy {} ({:.3g} of {:.3g} J): {} At the end {:.2g} % of the velocity was noise. "
        "Shorter steps, a finer grid or another integrator or transfer keep it better; /health/energy_drift "
        "sets what is told.",
        100 * std::max(gain, loss) / largest, gained ? "came from nowhere" : "was lost", std::max(gain, loss),
        largest,
        gained ? "noise grows, or the step is long."
               : "integrator or transfer damp what the grid does not resolve.",
        100 * noise);
}

std::string describe_unrest(double unbalanced, double asked, double changing_until) {
    std::string why = fmt::format(
        "{:.2g} of the forces are not in balance, or it still moves ({:.2g} was asked).", unbalanced, asked);
    if (!std::isfinite(changing_until))
        why = "loads or boundaries may never stop to change.";
    else if (changing_until > 0)
        why = fmt::format("loads or boundaries change until t = {:.6g} s.", changing_until);
    return "/time/until_at_rest: the scene did not come to rest by the end of the run: " + why +
           " Give it more time, `damping`, or loads that come smoothly (history \"ramp\").";
}

#define MATPOINT_INSTANTIATE(S)                                                                   \
    template std::string describe_stray(const Moment&, const Particles<S>&, Index,                \
                                        const std::optional<Exit>&, const std::string&);          \
    template std::string describe_fault(const Moment&, const Particles<S>&, const Fault&, double, \
                                        const Origin&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
