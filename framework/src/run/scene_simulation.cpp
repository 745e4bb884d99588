#include "run/scene_simulation.hpp"

#include "config/formula_places.hpp"
#include "run/derived_fields.hpp"
#include "run/pieces.hpp"
#include "run/shortest_wave.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace matpoint {

namespace {
/// Steps after which energies that lag by a half or a whole step are large beside the lag.
constexpr long settling_steps = 10;

template <class S>
double settled_at(const Components<S>& components) {
    double time = 0;
    for (const auto& load : components.loads)
        guarded(*load, "settled_at", [&] { time = std::max(time, load->settled_at()); });
    for (const auto& placed : components.conditions)
        guarded(*placed.condition, "settled_at",
                [&] { time = std::max(time, placed.condition->settled_at()); });
    for (const auto& placed : components.contacts)
        if (const Tool<S>* tool = placed.contact->tool())
            guarded(*tool, "settled_at", [&] { time = std::max(time, tool->settled_at()); });
    return time;
}
}  // namespace

template <class S>
SceneSimulation<S>::SceneSimulation(const Scene& scene, PluginCatalogue& catalogue)
    : title_(scene.resolved.at("title").get<std::string>()),
      scene_text_(scene.resolved.dump()),
      folder_(scene.folder.string()),
      end_(scene.resolved.at("/time/end"_json_pointer).get<double>()),
      rest_(scene.resolved.at("time").value("until_at_rest", 0.0)),
      max_steps_(scene.resolved.at("time").value("max_steps", std::numeric_limits<long>::max())),
      guarded_(scene.resolved.at("/health/enabled"_json_pointer).get<bool>()),
      deletes_strays_(scene.resolved.at("/health/off_grid"_json_pointer) == "delete"),
      on_unstable_step_(scene.resolved.at("/health/unstable_step"_json_pointer).get<std::string>()),
      most_drift_(scene.resolved.at("/health/energy_drift"_json_pointer).get<double>()),
      most_gain_(scene.resolved.at("/health/energy_gain"_json_pointer).get<double>()),
      assembly_(assemble<S>(scene, catalogue.registry())),
      engine_(assembly_.components, assembly_.bodies, assembly_.first_states),
      settled_at_(settled_at(assembly_.components)),
      smallest_cell_(engine_.levels().finest().cell_size().minCoeff()) {
    const Json& time = scene.resolved.at("time");
    if (time.contains("step"))
        step_length_ = time.at("step").get<double>();
    else
        cfl_ = time.at("cfl").get<double>();
    if (time.contains("wave_speed"))
        step_length_ = std::exchange(cfl_, 0) * smallest_cell_ / time.at("wave_speed").get<double>();
    numbers_.fixed_step = step_length_;
    for (const PluginLibrary& plugin : catalogue.opened()) plugins_[plugin.name()] = plugin.version();

    engine_.prepare();
    engine_.measure();
    for (const Particles<S>& particles : assembly_.bodies)
        first_pieces_.push_back(pieces(engine_.levels(), engine_.patch(first_pieces_.size()), particles,
                                       *assembly_.components.shape)
                                    .size());
    warnings_ = assembly_.warnings;
    if (guarded_) refuse_faults(scene);
    const double phase = shortest_wave_phase(engine_.levels(), assembly_.bodies, *assembly_.components.shape);
    // Beyond 1 a particle could cross a cell in a step.
    const Components<S>& components = assembly_.components;
    // Vibrations that the particles hardly carry are accelerated by as many times the force.
    const double largest_phase =
        components.integrator->largest_phase() / std::sqrt(components.transfer->order());
    stable_part_ = phase > 0 ? std::min(largest_phase / phase, 1.0) : 1.0;
    numbers_.first_mass = mass();
    numbers_.given_momentum = engine_.tally().momentum;
    numbers_.first_energy = energies().total();
    account();
    check_outputs(scene);
}

/// A material that can't be right, before the first step.
template <class S>
void SceneSimulation<S>::refuse_faults(const Scene& scene) const {
    Diagnostics diagnostics;
    for (const Fault& fault : engine_.faults()) {
        const Origin& material = engine_.material(fault.body).origin();
        diagnostics.add(scene.document.diagnostic(
            material.pointer, describe_fault({0, 0, 0}, assembly_.bodies[fault.body], fault, 0, material)));
    }
    diagnostics.throw_if_errors();
}

template <class S>
void SceneSimulation<S>::check_outputs(const Scene& scene) {
    Diagnostics diagnostics;
    for (std::size_t k = 0; k < assembly_.outputs.size(); ++k) {
        try {
            assembly_.outputs[k].output->check(*this);
        } catch (const std::exception& mistake) {
            diagnostics.add(scene.document.diagnostic("/outputs/" + std::to_string(k), mistake.what()));
        } catch (...) {
            throw_failure(assembly_.outputs[k].output->origin(), "check");
        }
    }
    diagnostics.throw_if_errors();
}

template <class S>
bool SceneSimulation<S>::finished() const {
    // An end that is a whole number of steps is met despite rounding of the time.
    return time_ >= end_ * (1 - 1e-12) || step_ >= max_steps_ || at_rest() == true;
}

template <class S>
std::optional<bool> SceneSimulation<S>::at_rest() const {
    if (rest_ == 0) return {};
    // The forces of a step are those of its start; loads take times that differ by rounding as the same.
    const bool settled = time_ - last_time_step_ >= settled_at_ * (1 - 1e-9);
    const bool enough = static_cast<double>(step_) >= numbers_.scene_from_step + settling_steps;
    // Forces are in balance for a moment whenever a body swings through its state of rest.
    return settled && enough && unbalanced_force() <= rest_ &&
           engine_.tally().kinetic <= rest_ * rest_ * numbers_.largest_energy;
}

template <class S>
double SceneSimulation<S>::unbalanced_force() const {
    // Where nothing holds anything in the end, balance is told beside what there was.
    constexpr double least = 0.01;
    const double carried = std::max(engine_.tally().carried_force, least * numbers_.largest_carried);
    if (carried == 0)
        return std::numeric_limits<double>::quiet_NaN();  // no step yet, or nothing holds anything
    return engine_.tally().unbalanced_force / carried;
}

template <class S>
double SceneSimulation<S>::noise() const {
    const Tally& tally = engine_.tally();
    return tally.kinetic > 0 ? std::sqrt(tally.noise_energy / tally.kinetic) : 0;
}

template <class S>
double SceneSimulation<S>::crossing_time() const {
    const double speed = engine_.tally().largest_wave_speed + engine_.tally().largest_speed;
    return speed > 0 ? smallest_cell_ / speed : std::numeric_limits<double>::infinity();
}

template <class S>
double SceneSimulation<S>::next_time_step() const {
    if (step_length_ > 0) return step_length_;
    double time = crossing_time();
    // What is at rest, and hardly stiff, crosses a cell as the loads set it in motion.
    const double acceleration = engine_.tally().load_acceleration;
    if (acceleration > 0 && std::isfinite(acceleration))
        time = std::min(time, std::sqrt(2 * smallest_cell_ / acceleration));
    // Where nothing moves, nothing is stiff and nothing pulls there is no time but the run's.
    return std::isfinite(time) ? cfl_ * time : end_ / 100;
}

template <class S>
long SceneSimulation<S>::estimated_steps() const {
    const double steps = std::ceil((end_ - time_) / next_time_step() * (1 - 1e-12));
    constexpr double uncountable = 9e18;  // beyond what a long holds
    return std::min(max_steps_ - step_, static_cast<long>(std::clamp(steps, 0.0, uncountable)));
}

template <class S>
void SceneSimulation<S>::advance() {
    const double dt = next_time_step(), stable = stable_step();
    remove_strays();
    check_step();
    if (!(time_ + dt > time_)) throw Breakdown(describe_standstill({step_, time_, dt}));

    try {
        engine_.step(step_, time_, dt, last_time_step_);
    } catch (const FormulaError& error) {
        const auto places = formula_places(Json::parse(scene_text_), error.formula());
        throw Breakdown(describe_formula({step_, time_, dt}, places, error));
    } catch (const ComponentFailure& failure) {
        throw Breakdown(describe_failure({step_, time_, dt}, failure));
    }
    const Tally& tally = engine_.tally();
    if (guarded_ && !engine_.faults().empty()) {
        const Fault& fault = engine_.faults().front();
        const std::string ails = ailments(fault.body);
        throw Breakdown(describe_fault({step_, time_, dt}, assembly_.bodies[fault.body], fault, stable,
                                       engine_.material(fault.body).origin()) +
                        (ails.empty() ? "" : " " + ails));
    }
    if (guarded_ && tally.stiff_without_waves) guard_waves();
    numbers_.strain += tally.strain_work;
    numbers_.external += tally.external_work;
    numbers_.damped += tally.damped;
    numbers_.contact += tally.contact;
    for (std::size_t c = 0; c < 3; ++c) numbers_.given_momentum[c] += tally.impulse[c];
    if (guarded_) guard_energy(dt);
    last_time_step_ = dt;
    ++step_;
    time_ = step_length_ > 0 ? numbers_.fixed_from_time +
                                   (static_cast<double>(step_) - numbers_.fixed_from_step) * step_length_
                             : time_ + dt;
    account();
    if (finished()) warn_at_end();
}

template <class S>
void SceneSimulation<S>::warn_at_end() {
    const auto& conditions = assembly_.components.conditions;
    for (std::size_t k = 0; k < conditions.size(); ++k)
        if (conditions[k].region && !engine_.held()[k])
            warnings_.push_back(
                fmt::format("/boundary_conditions/{}: no body ever was in its region: it held nothing", k));
    if (assembly_.error && numbers_.error.count == 0)
        warnings_.push_back("/exact_solution: nothing was there to be compared with it: no error is given");
    if (guarded_ && conservation().energy_drift > most_drift_)
        warnings_.push_back(describe_energy_drift(numbers_.energy_gain, numbers_.energy_loss,
                                                  numbers_.largest_energy, noise()));
    if (at_rest() == false)
        warnings_.push_back(
            describe_unrest(unbalanced_force(), rest_, time_ < settled_at_ ? settled_at_ : 0));
    // What was deleted leaves holes.
    for (std::size_t b = 0; guarded_ && numbers_.lost_mass == 0 && b < assembly_.bodies.size(); ++b)
        if (const std::string ails = ailments(b); !ails.empty()) warnings_.push_back(ails);
}

template <class S>
std::string SceneSimulation<S>::ailments(std::size_t body) const {
    const Particles<S>& particles = assembly_.bodies[body];
    const ShapeFunction<S>& shape = *assembly_.components.shape;
    std::string all;
    guarded(shape, "trouble", [&] { all = shape.trouble(particles); });
    const std::vector<Index> parts = pieces(engine_.levels(), engine_.patch(body), particles, shape);
    if (parts.size() <= first_pieces_[body]) return all;
    return all + (all.empty() ? "" : " ") +
           describe_torn(particles.body(), parts, widest_spacing(engine_.patch(), particles));
}

template <class S>
double SceneSimulation<S>::given_energy() const {
    const Energies e = energies();
    return numbers_.first_energy + std::max(e.external, 0.0) + std::max(-e.strain, 0.0);
}

template <class S>
void SceneSimulation<S>::account() {
    const Tally& tally = engine_.tally();
    const Energies e = energies();
    numbers_.largest_energy =
        std::max({numbers_.largest_energy, e.kinetic, std::abs(e.strain), std::abs(e.external)});
    numbers_.given_energy = std::max(numbers_.given_energy, given_energy());
    numbers_.largest_carried = std::max(numbers_.largest_carried, tally.carried_force);
    const double gain = e.total() - numbers_.first_energy;
    numbers_.energy_gain = std::max(numbers_.energy_gain, gain);
    numbers_.energy_loss = std::max(numbers_.energy_loss, -gain);
    numbers_.largest_momentum = std::max(numbers_.largest_momentum, tally.momentum_scale);
    // Radial momentum of rings is no conserved quantity: the hoop stress changes it.
    for (std::size_t c = S::axisymmetric ? 1 : 0; c < 3; ++c)
        numbers_.momentum_drift =
            std::max(numbers_.momentum_drift, std::abs(tally.momentum[c] - numbers_.given_momentum[c]));
}

template <class S>
Conservation SceneSimulation<S>::conservation() const {
    const auto relative = [](double drift, double scale) { return scale > 0 ? drift / scale : 0; };
    return {relative(std::abs(mass() + numbers_.lost_mass - numbers_.first_mass), numbers_.first_mass),
            relative(numbers_.momentum_drift, numbers_.largest_momentum),
            relative(std::max(numbers_.energy_gain, numbers_.energy_loss), numbers_.largest_energy),
            numbers_.lost_mass};
}

template <class S>
void SceneSimulation<S>::measure_error() {
    if (!assembly_.error) return;
    const ExactError<S>& error = *assembly_.error;
    const bool half_a_step_behind = assembly_.components.integrator->staggered() && step_ > 0;
    const double velocity_time = half_a_step_behind ? time_ - last_time_step_ / 2 : time_;
    try {
        if (error.of_nodes()) {
            engine_.project_velocity(velocity_time);
            error.add_nodes(engine_.patch(), engine_.inside(), time_, velocity_time, numbers_.error);
        } else if (step_ > 0) {
            for (const Particles<S>& particles : assembly_.bodies)
                error.add_particles(particles, time_, velocity_time, numbers_.error);
        }
    } catch (const ComponentFailure& failure) {
        throw Breakdown(describe_failure({step_, time_, last_time_step_}, failure));
    }
}

template <class S>
std::optional<Json> SceneSimulation<S>::error() const {
    const ErrorSums& sums = numbers_.error;
    if (!assembly_.error || sums.count == 0) return {};
    return Json{{"quantity", assembly_.error->quantity()},
                {"l1", sums.l1()},
                {"l2", sums.l2()},
                {"linf", sums.largest}};
}

template <class S>
void SceneSimulation<S>::remove_strays() {
    const std::vector<Stray> strays = engine_.strays();
    if (strays.empty()) return;
    const Stray& first = strays.front();
    if (!deletes_strays_ || !assembly_.bodies[first.body].position(first.particle).allFinite())
        throw Breakdown(
            describe_stray({step_, time_, next_time_step()}, assembly_.bodies[first.body], first.particle,
                           engine_.exit(assembly_.bodies[first.body].position(first.particle), time_),
                           ailments(first.body)));

    Tally left = engine_.tally();
    for (std::size_t b = 0, s = 0; b < assembly_.bodies.size(); ++b) {
        Particles<S>& particles = assembly_.bodies[b];
        std::vector<std::uint32_t> kept;
        for (Index p = 0; p < particles.size(); ++p) {
            if (s >= strays.size() || strays[s].body != b || strays[s].particle != p) {
                kept.push_back(static_cast<std::uint32_t>(p));
                continue;
            }
            ++s;
            const auto m = static_cast<double>(particles.column(Field::mass)[p]);
            const typename S::Vector v = particles.velocity(p);
            numbers_.lost_mass += m;
            for (int a = 0; a < S::dimension; ++a)
                numbers_.given_momentum[static_cast<std::size_t>(a)] -= m * static_cast<double>(v[a]);
            numbers_.external -= m * static_cast<double>(v.squaredNorm()) / 2;
            left.kinetic -= m * static_cast<double>(v.squaredNorm()) / 2;
        }
        if (static_cast<Index>(kept.size()) == particles.size()) continue;
        particles.permute(kept);
        engine_.forget(b);
    }
    engine_.restore(left);  // or damping would take what left for a peak that has passed
    warn_once("deleted", "particles that left the grid are deleted, first in step " + std::to_string(step_) +
                             "; summary.json has the lost mass");
}

template <class S>
void SceneSimulation<S>::check_step() {
    const double dt = next_time_step();
    if (!guarded_ || on_unstable_step_ == "ignore" || dt <= stable_step() * (1 + 1e-9)) return;
    const Tally& tally = engine_.tally();
    const std::string text = describe_unstable_step({step_, time_, dt}, stable_step(), stable_part_,
                                                    tally.largest_wave_speed, tally.largest_speed);
    if (on_unstable_step_ == "error") throw Breakdown(text);
    warn_once("stable", text);
}

template <class S>
void SceneSimulation<S>::warn_once(const std::string& word, const std::string& text) {
    const auto said = [&](const std::string& warning) { return warning.find(word) != std::string::npos; };
    if (std::ranges::none_of(warnings_, said)) warnings_.push_back(text);
}

/// Where the time step follows from the waves, a body without them would be without a limit.
template <class S>
void SceneSimulation<S>::guard_waves() {
    const std::size_t body = *engine_.tally().stiff_without_waves;
    const std::string text = describe_missing_waves(
        {step_, time_, next_time_step()}, assembly_.bodies[body].body(), engine_.material(body).origin());
    if (step_length_ == 0) throw Breakdown(text);
    if (warned_of_waves_) return;
    warned_of_waves_ = true;
    warnings_.push_back(text);
}

template <class S>
void SceneSimulation<S>::guard_energy(double dt) const {
    const double gain = energies().total() - numbers_.first_energy;
    const double given = std::max(numbers_.given_energy, given_energy());
    // Where nothing was given there may be stress from before, whose energy nobody knows.
    if (step_ >= settling_steps && given > 0 && gain > most_gain_ * given)
        throw Breakdown(describe_energy_gain({step_, time_, dt}, gain, given, noise()));
}

#define MATPOINT_INSTANTIATE(S)                                                   \
    template SceneSimulation<S>::SceneSimulation(const Scene&, PluginCatalogue&); \
    template bool SceneSimulation<S>::finished() const;                           \
    template void SceneSimulation<S>::advance();                                  \
    template void SceneSimulation<S>::check_step();                               \
    template void SceneSimulation<S>::measure_error();                            \
    template std::optional<Json> SceneSimulation<S>::error() const;               \
    template double SceneSimulation<S>::crossing_time() const;                    \
    template double SceneSimulation<S>::next_time_step() const;                   \
    template long SceneSimulation<S>::estimated_steps() const;                    \
    template std::optional<bool> SceneSimulation<S>::at_rest() const;             \
    template double SceneSimulation<S>::unbalanced_force() const;                 \
    template std::string SceneSimulation<S>::ailments(std::size_t) const;         \
    template double SceneSimulation<S>::noise() const;                            \
    template Conservation SceneSimulation<S>::conservation() const;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

std::unique_ptr<Simulation> Simulation::create(const Scene& scene, PluginCatalogue& catalogue) {
    try {
        return with_space(scene.space, [&]<class S>() -> std::unique_ptr<Simulation> {
            return std::make_unique<SceneSimulation<S>>(scene, catalogue);
        });
    } catch (const FormulaError& error) {
        Diagnostics diagnostics;
        for (const std::string& place : formula_places(scene.resolved, error.formula()))
            diagnostics.add(scene.document.diagnostic(place, error.what()));
        throw InputError(std::move(diagnostics));
    } catch (const ComponentFailure& failure) {
        if (failure.out_of_memory()) throw;
        Diagnostics diagnostics;
        diagnostics.add(scene.document.diagnostic(failure.origin().pointer, failure.reason()));
        throw InputError(std::move(diagnostics));
    }
}

}  // namespace matpoint
