#pragma once

#include "step/engine.hpp"

#include <matpoint/profile.hpp>

#include <string>
#include <vector>

namespace matpoint {

/// What the health guard says; each names the step, the time, the body, the particle, the likely
/// cause and the setting to change.
struct Moment {
    long step;
    double time, dt;
};

template <class S>
std::string describe_stray(const Moment& moment, const Particles<S>& particles, Index particle,
                           const std::optional<Exit>& exit, const std::string& ailments);
template <class S>
std::string describe_fault(const Moment& moment, const Particles<S>& particles, const Fault& fault,
                           double stable_step, const Origin& material);
/// A body in `parts` that no longer share nodes (particles of each), whose particles lie `spacing` cells
/// apart where it is pulled most.
std::string describe_torn(const std::string& body, const std::vector<Index>& parts, double spacing);
/// `places` are the formula's JSON pointers.
std::string describe_formula(const Moment& moment, const std::vector<std::string>& places,
                             const FormulaError& error);
/// What a component threw in a step, or an output after it.
std::string describe_failure(const Moment& moment, const ComponentFailure& failure);
/// A body under stress whose material says that it has no waves.
std::string describe_missing_waves(const Moment& moment, const std::string& body, const Origin& material);
/// A step that leaves the time where it is.
std::string describe_standstill(const Moment& moment);
/// One that is longer than `part` of the time in which waves and particles cross a cell.
std::string describe_unstable_step(const Moment& moment, double stable_step, double part, double wave_speed,
                                   double particle_speed);
/// Energies in J: what came from nowhere, and what the start and all sources gave.
std::string describe_energy_gain(const Moment& moment, double gain, double given, double noise);
std::string describe_energy_drift(double gain, double loss, double largest, double noise);
/// `changing_until` (s) loads or boundaries change after the end; 0 if they don't.
std::string describe_unrest(double unbalanced, double asked, double changing_until);

}  // namespace matpoint
