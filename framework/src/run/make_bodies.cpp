#include "run/make_bodies.hpp"

#include "particles/expected_count.hpp"
#include "particles/region_volume.hpp"
#include "particles/seeding.hpp"
#include "run/derived_fields.hpp"
#include "run/first_state.hpp"
#include "run/memory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace matpoint {

namespace {

/// Outputs of fields that no body carries are mistakes, told before anything runs.
template <class S>
void check_observed(Maker& maker, const std::vector<ScheduledOutput>& outputs,
                    const std::vector<Particles<S>>& bodies) {
    std::vector<std::string> known;
    for (const Particles<S>& particles : bodies)
        for (const std::string& name : field_names(particles)) known.push_back(name);
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    for (std::size_t k = 0; k < outputs.size(); ++k)
        for (const std::string& name : outputs[k].output->required_fields()) {
            const auto carried = [&](const Particles<S>& particles) {
                const std::string body = outputs[k].output->body();
                return (body.empty() || body == particles.body()) && field_components(particles, name) > 0;
            };
            if (std::none_of(bodies.begin(), bodies.end(), carried))
                maker.mistake("/outputs/" + std::to_string(k),
                              "particles have no field \"" + name + "\"" + did_you_mean(name, known));
        }
}

template <class S>
std::optional<ArtificialViscosity> viscosity_of(const Json& body, const Patch<S>& patch) {
    if (!body.contains("artificial_viscosity")) return {};
    const Json& own = body.at("artificial_viscosity");
    ArtificialViscosity viscosity{.form = own.at("form") == "landshoff"
                                              ? ArtificialViscosity::Form::landshoff
                                              : ArtificialViscosity::Form::chen_brannon,
                                  .linear = own.at("linear").get<double>(),
                                  .quadratic = own.at("quadratic").get<double>(),
                                  .length = std::pow(patch.cell_size().prod(), 1.0 / S::dimension)};
    if (own.contains("bulk_modulus")) viscosity.bulk_modulus = own.at("bulk_modulus").get<double>();
    return viscosity;
}

/// Gives a body's particles a field for each condition that a part of it carries.
template <class S>
void mark_parts(std::vector<PlacedCondition<S>>& conditions, Particles<S>& particles, std::size_t body) {
    for (std::size_t k = 0; k < conditions.size(); ++k)
        if (auto& part = conditions[k].part; part && part->body == body)
            part->slot = particles.require(fmt::format("boundary_condition_{}", k), 1);
}

/// Tells the particles of the parts, which start with what the conditions prescribe.
template <class S>
void fill_parts(Maker& maker, const std::vector<PlacedCondition<S>>& conditions, Particles<S>& particles,
                std::size_t body) {
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        const auto& part = conditions[k].part;
        if (!part || part->body != body) continue;
        const std::string pointer = fmt::format("/boundary_conditions/{}/on", k);
        const BoundaryCondition<S>& own = *conditions[k].condition;
        maker.attempt(pointer, [&] {
            const auto prescribes = guarded(own, "prescribes", [&] { return own.prescribes(-1); });
            bool found = false;
            for (Index p = 0; p < particles.size(); ++p) {
                Eigen::Vector3d x = Eigen::Vector3d::Zero();
                x.head<S::dimension>() = particles.position(p);
                const Geometry* const within = part->within.get();
                if (within && !guarded(*within, "contains", [&] { return within->contains(x); })) continue;
                found = true;
                particles.column(part->slot, 0)[p] = 1;
                const auto v =
                    guarded(own, "velocity", [&] { return own.velocity(particles.position(p), 0); });
                for (int c = 0; c < S::dimension; ++c)
                    if (prescribes[static_cast<std::size_t>(c)])
                        particles.column(Field::velocity, c)[p] = v[c];
            }
            if (!found)
                maker.mistake(pointer + (part->within ? "/within" : ""),
                              fmt::format("there is no particle of \"{}\" in this part", particles.body()));
        });
    }
}

template <class S>
SeededBody describe(const Particles<S>& particles, const Geometry& geometry) {
    SeededBody seeded{particles.body(), static_cast<std::size_t>(particles.size()), 0, 0,
                      volume_of<S>(geometry)};
    for (Index p = 0; p < particles.size(); ++p) {
        seeded.mass += static_cast<double>(particles.column(Field::mass)[p]);
        seeded.volume += static_cast<double>(particles.column(Field::volume)[p]);
    }
    return seeded;
}

bool is_zero(const Json& velocity) {
    return std::ranges::all_of(velocity, [](const Json& component) { return component == 0; });
}

/// The fields that the outputs and checks of a scene look at.
template <class S>
void require_observed(const Maker& maker, const std::vector<ScheduledOutput>& outputs,
                      Particles<S>& particles) {
    for (const ScheduledOutput& scheduled : outputs) {
        const std::string body = scheduled.output->body();
        if (!body.empty() && body != particles.body()) continue;
        for (const std::string& name : scheduled.output->required_fields())
            if (const auto field = field_behind(name)) particles.require(*field);
    }
    if (const Json& scene = maker.json(""); scene.contains("checks"))
        for (const Json& check : scene.at("checks"))
            if (check.contains("particles")) {
                particles.require(Field::initial_position);
                if (const auto field = field_behind(check.at("particles").value("field", "")))
                    particles.require(*field);
            }
}

/// Before a body is seeded: what it will take is asked of its geometry if the box around it might be too
/// much.
template <class S>
void count_memory(const Particles<S>& particles, const Levels<S>& levels, const Geometry& geometry,
                  const std::array<int, 3>& per_cell, MemoryBudget& memory) {
    // The columns have a spare one.
    const auto bytes = static_cast<double>(particles.bytes_per_particle() + sizeof(typename S::Real));
    const auto count_by = [&](const auto& count_on) {
        double sum = count_on(levels.patch(0));
        // Of finer levels at most what their cells hold.
        double of_cell = 1;
        for (std::size_t a = 0; a < S::dimension; ++a) of_cell *= per_cell[a];
        for (int level = 1; level < levels.count(); ++level)
            sum += std::min(count_on(levels.patch(level)),
                            of_cell * static_cast<double>(levels.cells_with_border(level)));
        return sum;
    };
    double count = count_by([&](const Patch<S>& patch) { return most_particles(patch, geometry, per_cell); });
    if (memory.exceeded_by(count * bytes))
        count =
            count_by([&](const Patch<S>& patch) { return expected_particles(patch, geometry, per_cell); });
    memory.add(particles.body(), count, bytes);
}

template <class S>
void refuse_endless(Maker& maker, const std::vector<std::shared_ptr<Geometry>>& geometries) {
    std::size_t number = 0;
    for (const auto& [name, unused] : maker.json("/bodies").items()) {
        const std::string pointer = join_pointer("/bodies", name) + "/geometry";
        if (const Geometry* const geometry = geometries[number++].get())
            maker.attempt(pointer, *geometry, "bounds", [&] {
                const auto [min, max] = geometry->bounds();
                for (int a = 0; a < S::dimension; ++a)
                    if (!std::isfinite(min[a]) || !std::isfinite(max[a]))
                        throw std::invalid_argument(fmt::format(
                            "a body ends somewhere, but this geometry has no end along {}: cut a part out of "
                            "it, "
                            "{{\"type\": \"intersection\", \"of\": [it, {{\"type\": \"box\", ...}}]}}",
                            "xyz"[a]));
            });
    }
}

/// A body without particles, which have all fields that somebody asks for.
template <class S>
Particles<S> with_fields(Maker& maker, const std::string& name, std::size_t number,
                         const Material<S>& material, Assembly<S>& assembly) {
    Components<S>& components = assembly.components;
    Particles<S> particles(name);
    particles.require(Field::id);  // messages call a particle by it, and outputs are in its order
    if (components.levels->count() > 1)
        for (const char* field : {refinement_field, level_field}) particles.require(field, 1);
    guarded(*components.shape, "declare", [&] { components.shape->declare(particles); });
    guarded(*components.transfer, "declare", [&] { components.transfer->declare(particles); });
    if (guarded(material, "uses_deformation_gradient", [&] { return material.uses_deformation_gradient(); }))
        particles.require(Field::displacement_gradient);
    if (std::ranges::any_of(components.conditions, [](const auto& k) { return friction_of(k).has_value(); }))
        for (const Field field : {Field::initial_half_size, Field::displacement_gradient})
            particles.require(field);  // how near its edges are
    if (guarded(*components.integrator, "lags", [&] { return components.integrator->lags(); }))
        particles.require(Field::grid_velocity_gradient);
    const int first_of_loads = particles.field_count();
    for (const auto& load : components.loads) guarded(*load, "declare", [&] { load->declare(particles); });
    for (int slot = first_of_loads; slot < particles.field_count(); ++slot)
        if (!field_from_name(particles.name(slot))) particles.keep_whole(slot);
    for (const PlacedContact<S>& placed : components.contacts) {
        guarded(*placed.contact, "declare", [&] { placed.contact->declare(particles); });
        if (std::ranges::find(placed.bodies, number) == placed.bodies.end()) continue;
        particles.require(Field::initial_half_size);  // of what it has around a node
        particles.require(Field::displacement_gradient);
    }
    if (components.viscosities.back()) particles.require(Field::total_stress);
    mark_parts(components.conditions, particles, number);
    if (components.exact_solution && components.exact_solution->covers(name))
        particles.require(Field::initial_position);
    require_observed(maker, assembly.outputs, particles);
    assembly.first_states.push_back(particles.field_count());
    for (const StateVariable& variable : guarded(material, "state", [&] { return material.state(); }))
        particles.require(variable.name, 1, variable.initial);
    return particles;
}

/// Fills its geometry with particles.
template <class S>
void seed_body(const Json& body, const Geometry& geometry, const Levels<S>& levels, double density,
               MemoryBudget& memory, Particles<S>& particles) {
    std::array<int, 3> per_cell{1, 1, 1};
    for (std::size_t a = 0; a < S::dimension; ++a) per_cell[a] = body.at("particles_per_cell")[a].get<int>();
    count_memory(particles, levels, geometry, per_cell, memory);
    std::vector<std::optional<Profile>> velocity;
    for (const Json& component : body.at("velocity"))
        velocity.push_back(component.is_null() ? std::nullopt : std::optional<Profile>(component));
    const auto initial_velocity = [&](const Eigen::Vector3d& x) {
        Eigen::Vector3d v = Eigen::Vector3d::Zero();
        for (std::size_t a = 0; a < velocity.size(); ++a)
            if (velocity[a]) v[static_cast<Eigen::Index>(a)] = (*velocity[a])({x[0], x[1], x[2]}, 0);
        return v;
    };
    const Seeding seeding = body.at("seeding") == "centres" ? Seeding::centres : Seeding::filled;
    seed<S>(particles, levels, geometry, per_cell, density, initial_velocity, seeding);
    const bool varies =
        std::ranges::any_of(body.at("velocity"), [](const Json& component) { return component.is_string(); });
    for (const Field field : {Field::velocity_gradient, Field::affine_velocity})
        if (varies && particles.has(field))
            set_initial_gradient<S>(particles, field, initial_velocity, levels.finest().cell_size()[0]);
}

/// Masses that the precision can't hold, and velocities that are not finite.
template <class S>
void check_seeded(Maker& maker, const std::string& pointer, double density, const Particles<S>& particles) {
    maker.attempt(pointer, [&] {
        const auto* mass = particles.column(Field::mass);
        for (Index p = 0; p < particles.size(); ++p)
            if (!(mass[p] > 0 && std::isfinite(mass[p])))
                throw std::invalid_argument(fmt::format(
                    "its particles get masses of {} kg: the scene's precision can't hold them, choose other "
                    "units or \"double\"",
                    density * static_cast<double>(particles.column(Field::volume)[p])));
    });
    maker.attempt(pointer + "/velocity", [&] {
        for (Index p = 0; p < particles.size(); ++p) {
            if (particles.velocity(p).allFinite()) continue;
            const typename S::Position x = particles.position(p);
            throw std::invalid_argument(fmt::format("is not finite at ({:.6g}), where a particle starts",
                                                    fmt::join(x.data(), x.data() + S::dimension, ", ")));
        }
    });
}

}  // namespace

template <class S>
std::vector<std::shared_ptr<Geometry>> make_geometries(Maker& maker) {
    std::vector<std::shared_ptr<Geometry>> geometries;
    for (const auto& [name, unused] : maker.json("/bodies").items())
        geometries.push_back(maker.make<Geometry>("geometry", join_pointer("/bodies", name) + "/geometry"));
    refuse_endless<S>(maker, geometries);
    return geometries;
}

template <class S>
void make_bodies(Maker& maker, const std::vector<std::shared_ptr<Geometry>>& geometries,
                 Assembly<S>& assembly) {
    Components<S>& components = assembly.components;
    const Levels<S>& levels = *components.levels;
    MemoryBudget memory;
    std::size_t number = 0;
    for (const auto& [name, body] : maker.json("/bodies").items()) {
        const std::string pointer = join_pointer("/bodies", name);
        const Material<S>& material = *components.materials[number];
        components.viscosities.push_back(viscosity_of(body, levels.patch(0)));
        Particles<S> particles = with_fields(maker, name, number, material, assembly);
        if (components.exact_solution && components.exact_solution->covers(name) &&
            !is_zero(body.at("velocity")))
            maker.mistake(pointer + "/velocity",
                          "the exact solution gives this body its velocity: leave it out");
        maker.attempt(pointer + "/geometry", *geometries[number], "functions", [&] {
            seed_body(body, *geometries[number], levels, material.density(), memory, particles);
            assembly.seeded.push_back(describe(particles, *geometries[number]));
        });
        check_seeded(maker, pointer, material.density(), particles);
        fill_parts(maker, components.conditions, particles, number);
        assembly.bodies.push_back(std::move(particles));
        ++number;
    }
    check_observed(maker, assembly.outputs, assembly.bodies);
    maker.throw_if_errors();
}

#define MATPOINT_INSTANTIATE(S)                                                 \
    template std::vector<std::shared_ptr<Geometry>> make_geometries<S>(Maker&); \
    template void make_bodies<S>(Maker&, const std::vector<std::shared_ptr<Geometry>>&, Assembly<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
