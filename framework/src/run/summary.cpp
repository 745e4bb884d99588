#include "run/summary.hpp"

#include "config/utf8.hpp"
#include "registry/instruction_set.hpp"

#include <matpoint/parallel.hpp>

#include <fmt/format.h>

#include <fstream>
#include <string>

namespace matpoint {

namespace {

/// Largest resident size of this program so far. Not getrusage's, which begins with what the process had
/// before it became this program.
std::size_t peak_memory_bytes() {
    std::ifstream status("/proc/self/status");
    std::size_t kibibytes = 0;
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) kibibytes = std::stoul(line.substr(6));
    return kibibytes * 1024;
}

const char* name(RunStatus status) {
    switch (status) {
        case RunStatus::completed:
            return "completed";
        case RunStatus::broke_down:
            return "broke_down";
        case RunStatus::interrupted:
        case RunStatus::unfinished:
            break;
    }
    return "interrupted";
}

}  // namespace

Json summarise(const Simulation& simulation, const PluginCatalogue& catalogue, const RunClock& clock,
               const RunResult& result) {
    const Conservation conservation = simulation.conservation();
    const Energies energies = simulation.energies();
    const auto momentum = simulation.momentum();
    Json summary = {
        {"title", simulation.title()},
        {"status", name(result.status)},
        {"particles", simulation.particle_count()},
        {"steps", simulation.step()},
        {"time", simulation.time()},
        {"wall_seconds", clock.step_wall_seconds},
        {"cpu_seconds", clock.step_cpu_seconds},
        {"nanoseconds_per_particle_step",
         clock.particle_steps > 0 ? Json(1e9 * clock.step_wall_seconds / clock.particle_steps) : Json()},
        {"phases", simulation.phase_seconds()},
        {"particle_steps", clock.particle_steps},
        {"threads", threads()},
        {"instruction_set", instruction_set()},
        {"bytes_per_particle", simulation.bytes_per_particle()},
        {"peak_memory_bytes", peak_memory_bytes()},
        {"loaded_plugins", Json::array()},
        {"particle_fields", simulation.particle_fields()},
        {"node_fields", simulation.node_fields()},
        {"conservation",
         {{"mass_drift", conservation.mass_drift},
          {"momentum_drift", conservation.momentum_drift},
          {"energy_drift", conservation.energy_drift},
          {"lost_mass", conservation.lost_mass}}},
        {"noise", simulation.noise()},
        {"final",
         {{"mass", simulation.mass()},
          {"momentum",
           std::vector<double>(momentum.begin(), momentum.begin() + simulation.space().dimension())},
          {"kinetic_energy", energies.kinetic},
          {"strain_energy", energies.strain},
          {"external_work", energies.external},
          {"damped_energy", energies.damped},
          {"contact_energy", energies.contact}}},
    };
    if (const auto rest = simulation.at_rest())
        summary["rest"] = {{"reached", *rest}, {"unbalanced_force", simulation.unbalanced_force()}};
    for (const SeededBody& body : simulation.seeded_bodies()) {
        Json& own = summary["bodies"][body.name];
        own = {{"particles", body.particles}, {"mass", body.mass}, {"volume", body.volume}};
        if (body.geometry_volume) own["geometry_volume"] = *body.geometry_volume;
    }
    if (const Json levels = simulation.levels(); !levels.is_null()) summary.update(levels);
    for (const std::string& contact : simulation.contacts()) {
        const ContactReport report = simulation.contact(contact);
        const auto dimension = simulation.space().dimension();
        summary["contacts"][contact] = {
            {"largest_penetration_over_h", report.penetration},
            {"gap_at_first_contact_over_h", report.touched != 0 ? Json(report.first_gap) : Json()},
            {"friction_work", report.friction_work},
            {"impulse", std::vector<double>(report.impulse.begin(), report.impulse.begin() + dimension)}};
    }
    if (const auto error = simulation.error()) summary["error"] = *error;
    for (const PluginLibrary& plugin : catalogue.opened()) summary["loaded_plugins"].push_back(plugin.name());
    if (!result.reason.empty()) summary["reason"] = as_utf8(result.reason);
    if (!simulation.warnings().empty()) summary["warnings"] = simulation.warnings();
    return summary;
}

Json with_plugins(Json resolved, const PluginCatalogue& catalogue) {
    Json& plugins = resolved["resolved_with"] = Json::object();
    for (const PluginLibrary& plugin : catalogue.opened()) plugins[plugin.name()] = plugin.version();
    return resolved;
}

void print_closing_table(const Simulation& simulation, const RunResult& result) {
    const Json& s = result.summary;
    const auto& final_values = s.at("final");
    const auto& conservation = s.at("conservation");
    const Json& cost = s.at("nanoseconds_per_particle_step");
    fmt::print(
        "{}: {} steps to t = {:.6g} s, {} particles, {:.3g} s ({}, {} B per particle)\n",
        s.at("status").get<std::string>(), simulation.step(), simulation.time(), simulation.particle_count(),
        s.at("wall_seconds").get<double>(),
        cost.is_null() ? "no step taken" : fmt::format("{:.1f} ns per particle and step", cost.get<double>()),
        simulation.bytes_per_particle());
    fmt::print("  {:<14} {:>14} {:>12}\n", "", "at the end", "drift");
    fmt::print("  {:<14} {:>14.6g} {:>12.2e}\n", "mass", final_values.at("mass").get<double>(),
               conservation.at("mass_drift").get<double>());
    const auto momentum = simulation.momentum();
    for (int a = 0; a < simulation.space().dimension(); ++a)
        fmt::print("  {:<14} {:>14.6g} {:>12}\n", fmt::format("momentum {}", "xyz"[a]),
                   momentum[static_cast<std::size_t>(a)],
                   a == 0 ? fmt::format("{:.2e}", conservation.at("momentum_drift").get<double>()) : "");
    const Energies e = simulation.energies();
    fmt::print("  {:<14} {:>14.6g}\n  {:<14} {:>14.6g}\n  {:<14} {:>14.6g}\n", "kinetic", e.kinetic, "strain",
               e.strain, "external", e.external);
    if (e.damped != 0) fmt::print("  {:<14} {:>14.6g}\n", "damped", e.damped);
    if (e.contact != 0) fmt::print("  {:<14} {:>14.6g}\n", "contact", e.contact);
    fmt::print("  {:<14} {:>14.6g} {:>12.2e}\n", "energy balance", e.total(),
               conservation.at("energy_drift").get<double>());
    if (s.contains("rest"))
        fmt::print("  {:<14} {:>14.2e} of the forces in balance\n",
                   s.at("rest").at("reached").get<bool>() ? "at rest" : "not at rest",
                   s.at("rest").at("unbalanced_force").get<double>());
    if (s.contains("error")) {
        const auto& error = s.at("error");
        fmt::print("  {:<14} {:>14} of {}: l1 {:.3g}, l2 {:.3g}\n", "error, largest",
                   fmt::format("{:.3g}", error.at("linf").get<double>()),
                   error.at("quantity").get<std::string>(), error.at("l1").get<double>(),
                   error.at("l2").get<double>());
    }
}

}  // namespace matpoint
