#include "options.hpp"
#include "run_command.hpp"
#include "verbs.hpp"

#include "grid/level_fields.hpp"
#include "run/memory.hpp"
#include "run/resource_error.hpp"
#include "verify/load_scene.hpp"

#include <matpoint/particles.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace matpoint {
namespace {

/// What a particle field is there for.
std::string reason_for(const std::string& name) {
    const auto field = field_from_name(name);
    if (name == level_field || name == refinement_field) return "levels of the grid";
    if (!field) return "a component's own state";
    switch (*field) {
        case Field::position:
        case Field::velocity:
        case Field::mass:
        case Field::volume:
        case Field::stress:
            return "always";
        case Field::total_stress:
            return "artificial viscosity";
        case Field::displacement_gradient:
            return "a material, a domain or a wall that follows the deformation";
        case Field::velocity_gradient:
            return "an output of it";
        case Field::affine_velocity:
            return "an affine transfer";
        case Field::grid_velocity_gradient:
            return "an integrator whose strain lags";
        case Field::grid_velocity:
            return "a transfer of higher order";
        case Field::half_size:
            return "the shape function's particle domain";
        case Field::initial_half_size:
            return "a particle domain that follows the deformation, loads on faces and walls that let go";
        case Field::initial_position:
            return "displacements: outputs, checks, exact solutions";
        case Field::position_remainder:
        case Field::initial_position_remainder:
        case Field::velocity_remainder:
        case Field::volume_remainder:
            return "what single precision rounds away";
        case Field::id:
            return "messages about a particle, and the order of outputs";
    }
    return "";
}

void print_body(const Simulation& simulation, const SeededBody& seeded) {
    const std::string& body = seeded.name;
    const std::vector<std::string> carried = simulation.particle_fields();
    const int real = simulation.space().single ? 4 : 8;
    std::vector<std::string> lines;
    int total = 0;
    for (const std::string& field : simulation.fields(body)) {
        if (std::find(carried.begin(), carried.end(), field) == carried.end())
            continue;  // computed when asked for
        const int bytes = simulation.components(body, field) * (field == "id" ? 4 : real);
        total += bytes;
        lines.push_back(fmt::format("      {:4} {:24}{}\n", bytes, field, reason_for(field)));
    }
    std::cout << fmt::format("  body {}: {} particles of {} bytes\n", body, seeded.particles, total);
    std::cout << fmt::format("    mass {:.7g}, volume {:.7g}", seeded.mass, seeded.volume);
    if (seeded.geometry_volume) std::cout << fmt::format(" (its geometry's {:.7g})", *seeded.geometry_volume);
    std::cout << fmt::format("\n{}", fmt::join(lines, ""));
}

void print_levels(const Simulation& simulation) {
    const Json levels = simulation.levels();
    if (levels.is_null()) return;
    for (const Json& level : levels.at("levels"))
        std::cout << fmt::format("  level {}: {} cells, {} particles\n", &level - &levels.at("levels")[0],
                                 level.at("cells").get<long>(), level.at("particles").get<long>());
    std::cout << fmt::format("  {:.3g} of the cells of a uniform grid as fine\n",
                             levels.at("cells_over_uniform").get<double>());
}

/// Says what the guard of a run would say of its first step; false if that would end the run.
bool passes_first_step(Simulation& simulation) {
    try {
        simulation.check_step();
    } catch (const Breakdown& breakdown) {
        std::cerr << breakdown.what() << "\n";
        return false;
    }
    for (const std::string& warning : simulation.warnings()) print_warning(warning);
    return true;
}

/// False if the scene is sound but a run of it would not get through its first step.
bool validate_file(const std::filesystem::path& file, const std::vector<std::string>& assignments) {
    PluginCatalogue catalogue;
    const Scene scene = load_scene(file, assignments, catalogue);
    const auto simulation = Simulation::create(scene, catalogue);
    print_recommendation(scene, catalogue);

    const double dt = simulation->next_time_step();
    std::cout << fmt::format("{}: ok\n", file.string());
    const Json& time = scene.resolved.at("time");
    const bool fixed = time.contains("step") || time.contains("wave_speed");
    std::cout << fmt::format("  time step {:.4g} s (stable up to {:.4g} s), {}{} steps\n", dt,
                             simulation->stable_step(), fixed ? "" : "about ", simulation->estimated_steps());
    std::cout << fmt::format("  {} particles; memory {}\n", simulation->particle_count(),
                             memory_text(static_cast<double>(simulation->memory_bytes())));
    print_levels(*simulation);
    for (const SeededBody& body : simulation->seeded_bodies()) print_body(*simulation, body);
    std::cout << fmt::format("  node fields: {}\n", fmt::join(simulation->node_fields(), ", "));
    std::vector<std::string> plugins;
    for (const PluginLibrary& plugin : catalogue.opened()) plugins.push_back(plugin.name());
    std::cout << fmt::format("  plugins: {}\n", fmt::join(plugins, ", "));
    return passes_first_step(*simulation);
}

}  // namespace

int validate(const std::vector<std::string>& arguments) {
    VerbOptions verb{
        .usage = "matpoint validate SCENE... [--set /ptr=VALUE]...",
        .doc =
            "Checks scenes without solving them, and predicts time step, steps, particles and memory.\n"
            "Writes no files.",
        .least_arguments = 1,
        .most_arguments = -1};
    add_assignments(verb.options);
    const auto values = parse(verb, arguments);
    if (!values) return exit_done;

    int status = exit_done;
    for (const std::string& file : arguments_of(*values)) {
        try {
            if (!validate_file(file, assignments_of(*values))) status = std::max(status, exit_failed);
        } catch (const InputError& error) {
            std::cerr << error.what() << "\n";
            status = std::max(status, exit_bad_input);
        } catch (const PluginError& error) {
            std::cerr << file << ": " << error.what() << "\n";
            status = std::max(status, exit_missing);
        } catch (const ResourceError& error) {
            std::cerr << file << ": " << error.what() << "\n";
            status = std::max(status, exit_missing);
        }
    }
    return status;
}

}  // namespace matpoint
