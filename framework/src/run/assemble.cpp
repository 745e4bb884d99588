#include "run/assemble.hpp"

#include <matpoint/damping.hpp>
#include <matpoint/exact_solution.hpp>
#include <matpoint/geometry.hpp>

#include "config/formula_places.hpp"
#include "particles/expected_count.hpp"
#include "particles/region_volume.hpp"
#include "particles/seeding.hpp"
#include "run/derived_fields.hpp"
#include "run/memory.hpp"
#include "run/plane_stress.hpp"
#include "run/resource_error.hpp"
#include "run/scene_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace matpoint {

namespace {

/// Makes components and turns what their constructors complain of into diagnostics.
class Maker {
  public:
    Maker(const Scene& scene, const Registry& registry)
        : scene_(scene),
          registry_(registry),
          context_{.space = scene.space,
                   .folder = scene.folder,
                   .registry = &registry,
                   .scene = &scene.resolved,
                   .warn = [this](const std::string& text) {
                       diagnostics_.add(scene_.document.diagnostic(pointer_, text, false));
                   }} {
        for (const Diagnostic& warning : scene.warnings) diagnostics_.add(warning);
    }

    template <class C>
    std::shared_ptr<C> make(const std::string& kind, const std::string& pointer) {
        std::shared_ptr<C> made;
        pointer_ = pointer;
        attempt(pointer, [&] { made = registry_.make<C>(kind, json(pointer), context_, pointer); });
        return made;
    }
    template <class Action>
    void attempt(const std::string& pointer, const Action& action) {
        try {
            action();
        } catch (const std::invalid_argument& wrong) {
            mistake(pointer, wrong.what());
        } catch (const FormulaError& wrong) {
            for (const std::string& place : formula_places(scene_.resolved, wrong.formula()))
                mistake(place, wrong.what());
        } catch (const ComponentFailure& failure) {
            if (failure.out_of_memory()) throw;
            mistake(failure.origin().pointer, failure.reason());
        }
    }
    /// The same for what is up to a component: it may complain, or fail.
    template <class Action>
    void attempt(const std::string& pointer, const Component& component, const char* function,
                 const Action& action) {
        attempt(pointer, [&] {
            try {
                action();
            } catch (const std::invalid_argument&) {
                throw;
            } catch (const std::bad_alloc&) {
                throw;  // hardly the component's
            } catch (const ResourceError&) {
                throw;
            } catch (...) {
                throw_failure(component.origin(), function);
            }
        });
    }
    void mistake(const std::string& pointer, const std::string& text) {
        diagnostics_.add(scene_.document.diagnostic(pointer, text));
    }
    const Json& json(const std::string& pointer) const {
        return scene_.resolved.at(Json::json_pointer(pointer));
    }
    const Parameters::Context& context() const { return context_; }
    void add(const Findings& findings) {
        for (const Finding& finding : findings)
            diagnostics_.add(scene_.document.diagnostic(finding.pointer, finding.text, finding.error));
    }
    void throw_if_errors() const { diagnostics_.throw_if_errors(); }
    /// In the order of the scene's text.
    std::vector<std::string> warnings() const {
        std::vector<std::string> texts;
        for (const Diagnostic& diagnostic : diagnostics_.all()) texts.push_back(to_string(diagnostic));
        return texts;
    }

  private:
    const Scene& scene_;
    const Registry& registry_;
    Parameters::Context context_;
    std::string pointer_;  ///< of what is being made
    Diagnostics diagnostics_;
};

template <class S>
void make_conditions(Maker& maker, std::vector<PlacedCondition<S>>& conditions) {
    const Json& all = maker.json("/boundary_conditions");
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string pointer = "/boundary_conditions/" + std::to_string(k);
        PlacedCondition<S> placed;
        placed.name = all[k].value("name", "");
        placed.condition = maker.make<BoundaryCondition<S>>("boundary_condition", pointer);
        if (const Json& on = all[k].at("on"); on.contains("body")) {
            const Json& bodies = maker.json("/bodies");
            placed.part.emplace();
            placed.part->body = static_cast<std::size_t>(
                std::distance(bodies.begin(), bodies.find(on.at("body").get<std::string>())));
            if (on.contains("within"))
                placed.part->within = maker.make<Geometry>("geometry", pointer + "/on/within");
        } else if (on.is_object()) {
            placed.region = maker.make<Geometry>("geometry", pointer + "/on");
        } else {
            placed.faces = all[k].at("on").get<std::vector<std::string>>();
        }
        conditions.push_back(std::move(placed));
    }
}

/// Bodies that a law between them names, in the scene's order; "all" is every one.
std::vector<std::size_t> bodies_between(const Json& contact, const std::vector<std::string>& names) {
    std::vector<std::size_t> bodies;
    for (const Json& body : contact.at("between")) {
        const auto place = std::ranges::find(names, body.get<std::string>());
        if (place != names.end()) {
            bodies.push_back(static_cast<std::size_t>(place - names.begin()));
            continue;
        }
        bodies.resize(names.size());
        std::iota(bodies.begin(), bodies.end(), std::size_t{0});
        break;
    }
    return bodies;
}

template <class S>
void make_contacts(Maker& maker, Components<S>& components) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : maker.json("/bodies").items()) names.push_back(name);
    std::vector<std::vector<std::size_t>> between;
    const Json& all = maker.json("/contacts");
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string pointer = "/contacts/" + std::to_string(k);
        PlacedContact<S> placed;
        placed.name = all[k].at("name").get<std::string>();
        placed.contact = maker.make<Contact<S>>("contact", pointer);
        if (all[k].contains("between")) {
            placed.rule = PairRule::of(all[k]);
            placed.bodies = bodies_between(all[k], names);
            if (placed.bodies.size() < 2)
                maker.mistake(pointer + "/between", "a contact is between two or more bodies");
        } else if (placed.contact && placed.contact->law()) {
            maker.mistake(pointer, "a law between bodies declares their parameters: declare_pair(schema)");
        }
        between.push_back(placed.bodies);
        components.contacts.push_back(std::move(placed));
    }
    std::vector<ContactMistake> mistakes;
    components.layers = contact_layers(names, between, mistakes);
    for (const ContactMistake& mistake : mistakes)
        maker.mistake("/contacts/" + std::to_string(mistake.contact) + "/between", mistake.text);
}

void make_outputs(Maker& maker, std::vector<ScheduledOutput>& outputs) {
    const Json& all = maker.json("/outputs");
    for (std::size_t k = 0; k < all.size(); ++k) {
        ScheduledOutput scheduled;
        scheduled.output = maker.make<Output>("output", "/outputs/" + std::to_string(k));
        scheduled.type = all[k].at("type").get<std::string>();
        scheduled.every = all[k].value("every", 0.0);
        scheduled.every_steps = all[k].value("every_steps", 0L);
        outputs.push_back(std::move(scheduled));
    }
}

/// A field of velocity gradients, from differences of the velocity at the start: exact for linear fields.
template <class S, class Velocity>
void set_initial_gradient(Particles<S>& particles, Field field, const Velocity& velocity, double cell_size) {
    const double reach = 1e-3 * cell_size;
    for (Index p = 0; p < particles.size(); ++p) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        x.head<S::dimension>() = particles.position(p);
        for (int a = 0; a < S::dimension; ++a) {
            const Eigen::Vector3d step = reach * Eigen::Vector3d::Unit(a);
            const Eigen::Vector3d slope = (velocity(x + step) - velocity(x - step)) / (2 * reach);
            for (int c = 0; c < S::dimension; ++c)
                particles.column(field, c + S::dimension * a)[p] = static_cast<typename S::Real>(slope[c]);
        }
    }
}

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

/// What the scene's exact solution says of the bodies at time 0. Their geometries are the reference
/// configuration.
template <class S>
void start_exactly(const ExactSolution& solution, Particles<S>& particles) {
    using Real = typename S::Real;
    const auto tensor = [](const Eigen::Matrix3d& full) {
        Tensor<S> t;
        t.plane = full.topLeftCorner<S::dimension, S::dimension>().template cast<Real>();
        if constexpr (S::has_normal) t.normal = static_cast<Real>(full(2, 2));
        return t;
    };
    for (Index p = 0; p < particles.size(); ++p) {
        Eigen::Vector3d reference = Eigen::Vector3d::Zero();
        reference.head<S::dimension>() = particles.position(p);
        const Eigen::Vector3d u = solution.displacement(reference, 0), v = solution.velocity(reference, 0);
        const Eigen::Matrix3d f = solution.deformation_gradient(reference, 0);
        for (int a = 0; a < S::dimension; ++a) {
            particles.set_value(Field::position, a, p, reference[a] + u[a]);
            particles.column(Field::velocity, a)[p] = static_cast<Real>(v[a]);
        }
        particles.set_value(Field::volume, 0, p, particles.value(Field::volume, 0, p) * f.determinant());
        ParticleBatch<S>::store_stress(particles, p, tensor(solution.stress(reference, 0)));
        if (particles.has(Field::displacement_gradient))
            ParticleBatch<S>::store_displacement_gradient(particles, p,
                                                          tensor(f - Eigen::Matrix3d::Identity()));
    }
}

/// L = dv/dX F^-1 at time 0, from differences of v.
template <class S>
void set_exact_gradient(const ExactSolution& solution, Particles<S>& particles, Field field, double reach) {
    for (Index p = 0; p < particles.size(); ++p) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        x.head<S::dimension>() = particles.position(p, Field::initial_position);
        Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
        for (int a = 0; a < S::dimension; ++a) {
            const Eigen::Vector3d step = reach * Eigen::Vector3d::Unit(a);
            slope.col(a) = (solution.velocity(x + step, 0) - solution.velocity(x - step, 0)) / (2 * reach);
        }
        const Eigen::Matrix3d gradient = slope * solution.deformation_gradient(x, 0).inverse();
        for (int a = 0; a < S::dimension; ++a)
            for (int c = 0; c < S::dimension; ++c)
                particles.column(field, c + S::dimension * a)[p] =
                    static_cast<typename S::Real>(gradient(c, a));
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
void count_memory(const Particles<S>& particles, const Patch<S>& patch, const Geometry& geometry,
                  const std::array<int, 3>& per_cell, MemoryBudget& memory) {
    // The columns have a spare one.
    const auto bytes = static_cast<double>(particles.bytes_per_particle() + sizeof(typename S::Real));
    double count = most_particles(patch, geometry, per_cell);
    if (memory.exceeded_by(count * bytes)) count = expected_particles(patch, geometry, per_cell);
    memory.add(particles.body(), count, bytes);
}

/// Bodies of geometries that go on for ever.
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

template <class S>
Assembly<S> assemble_with(const Scene& scene, const Registry& registry) {
    Maker maker(scene, registry);
    Assembly<S> result;
    Components<S>& components = result.components;
    components.grid = maker.make<Grid<S>>("grid", "/grid");
    components.shape = maker.make<ShapeFunction<S>>("shape_function", "/shape_function");
    components.light_nodes = maker.json("/grid").at("light_nodes").get<double>();
    components.transfer = maker.make<Transfer<S>>("transfer", "/transfer");
    components.integrator = maker.make<Integrator<S>>("integrator", "/integrator");
    for (std::size_t k = 0; k < scene.resolved.at("loads").size(); ++k)
        components.loads.push_back(maker.make<Load<S>>("load", "/loads/" + std::to_string(k)));
    if (scene.resolved.contains("damping"))
        components.damping = maker.make<Damping<S>>("damping", "/damping");
    make_conditions(maker, components.conditions);
    make_contacts(maker, components);
    std::shared_ptr<Geometry> within;
    if (scene.resolved.contains("exact_solution")) {
        const Json& own = maker.json("/exact_solution");
        components.exact_solution = maker.make<ExactSolution>("exact_solution", "/exact_solution");
        if (own.contains("within")) within = maker.make<Geometry>("geometry", "/exact_solution/within");
        result.error.emplace(components.exact_solution, own, within);
    }
    make_outputs(maker, result.outputs);
    components.measures_balance = components.damping || scene.resolved.at("time").contains("until_at_rest") ||
                                  std::ranges::any_of(result.outputs, [](const ScheduledOutput& scheduled) {
                                      return scheduled.output && scheduled.output->observes_balance();
                                  });
    std::map<std::string, std::shared_ptr<Material<S>>> materials;
    for (const auto& [name, unused] : scene.resolved.at("materials").items())
        materials[name] = maker.make<Material<S>>("material", join_pointer("/materials", name));
    std::vector<std::shared_ptr<Geometry>> geometries;
    for (const auto& [name, unused] : scene.resolved.at("bodies").items())
        geometries.push_back(maker.make<Geometry>("geometry", join_pointer("/bodies", name) + "/geometry"));
    refuse_endless<S>(maker, geometries);
    maker.throw_if_errors();

    Patch<S>& patch = components.grid->patch();
    for (std::size_t a = 0; a < S::dimension; ++a)
        if (patch.cells()[a] + 1 < components.shape->width())
            maker.mistake("/grid", "needs at least " + std::to_string(components.shape->width() - 1) +
                                       " cells on every axis for this shape function");

    MemoryBudget memory;
    std::size_t number = 0;
    for (const auto& [name, body] : scene.resolved.at("bodies").items()) {
        Particles<S> particles(name);
        particles.require(Field::id);  // messages call a particle by it, and outputs are in its order
        const auto material = materials.at(body.at("material").template get<std::string>());
        components.materials.push_back(material);
        guarded(*components.shape, "declare", [&] { components.shape->declare(particles); });
        guarded(*components.transfer, "declare", [&] { components.transfer->declare(particles); });
        if (guarded(*material, "uses_deformation_gradient",
                    [&] { return material->uses_deformation_gradient(); }))
            particles.require(Field::displacement_gradient);
        if (std::ranges::any_of(components.conditions,
                                [](const auto& k) { return friction_of(k).has_value(); }))
            for (const Field field : {Field::initial_half_size, Field::displacement_gradient})
                particles.require(field);  // how near its edges are
        if (guarded(*components.integrator, "lags", [&] { return components.integrator->lags(); }))
            particles.require(Field::grid_velocity_gradient);
        for (const auto& load : components.loads)
            guarded(*load, "declare", [&] { load->declare(particles); });
        for (const PlacedContact<S>& placed : components.contacts) {
            guarded(*placed.contact, "declare", [&] { placed.contact->declare(particles); });
            if (std::ranges::find(placed.bodies, number) == placed.bodies.end()) continue;
            particles.require(Field::initial_half_size);  // of what it has around a node
            particles.require(Field::displacement_gradient);
        }
        components.viscosities.push_back(viscosity_of(body, patch));
        if (components.viscosities.back()) particles.require(Field::total_stress);
        mark_parts(components.conditions, particles, number);
        const bool exact = components.exact_solution && components.exact_solution->covers(name);
        if (exact) particles.require(Field::initial_position);
        if (exact && !is_zero(body.at("velocity")))
            maker.mistake(join_pointer("/bodies", name) + "/velocity",
                          "the exact solution gives this body its velocity: leave it out");
        require_observed(maker, result.outputs, particles);
        result.first_states.push_back(particles.field_count());
        for (const StateVariable& variable : guarded(*material, "state", [&] { return material->state(); }))
            particles.require(variable.name, 1, variable.initial);

        maker.attempt(join_pointer("/bodies", name) + "/geometry", *geometries[number], "functions", [&] {
            std::array<int, 3> per_cell{1, 1, 1};
            for (std::size_t a = 0; a < S::dimension; ++a)
                per_cell[a] = body.at("particles_per_cell")[a].template get<int>();
            count_memory(particles, patch, *geometries[number], per_cell, memory);
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
            seed<S>(particles, patch, *geometries[number], per_cell, material->density(), initial_velocity,
                    seeding);
            result.seeded.push_back(describe(particles, *geometries[number]));
            const bool varies = std::ranges::any_of(
                body.at("velocity"), [](const Json& component) { return component.is_string(); });
            for (const Field field : {Field::velocity_gradient, Field::affine_velocity})
                if (varies && particles.has(field))
                    set_initial_gradient(particles, field, initial_velocity, patch.cell_size()[0]);
        });
        maker.attempt(join_pointer("/bodies", name), [&] {
            const auto* mass = particles.column(Field::mass);
            for (Index p = 0; p < particles.size(); ++p)
                if (!(mass[p] > 0 && std::isfinite(mass[p])))
                    throw std::invalid_argument(fmt::format(
                        "its particles get masses of {} kg: the scene's precision can't hold them, "
                        "choose other units or \"double\"",
                        material->density() * static_cast<double>(particles.column(Field::volume)[p])));
        });
        maker.attempt(join_pointer("/bodies", name) + "/velocity", [&] {
            for (Index p = 0; p < particles.size(); ++p) {
                if (particles.velocity(p).allFinite()) continue;
                const typename S::Position x = particles.position(p);
                throw std::invalid_argument(fmt::format("is not finite at ({:.6g}), where a particle starts",
                                                        fmt::join(x.data(), x.data() + S::dimension, ", ")));
            }
        });
        fill_parts(maker, components.conditions, particles, number);
        result.bodies.push_back(std::move(particles));
        ++number;
    }
    check_observed(maker, result.outputs, result.bodies);
    maker.throw_if_errors();
    for (std::size_t k = 0; k < components.loads.size(); ++k)
        maker.attempt("/loads/" + std::to_string(k), [&] {
            guarded(*components.loads[k], "start", [&] { components.loads[k]->start(patch, result.bodies); });
        });
    for (std::size_t k = 0; k < components.contacts.size(); ++k)
        if (Tool<S>* const tool = components.contacts[k].contact->tool()) {
            const std::string pointer = "/contacts/" + std::to_string(k);
            maker.attempt(pointer, *tool, "start", [&] {
                for (const std::string& warning : tool->start(patch, result.bodies))
                    maker.add({{false, pointer, warning}});
            });
        }
    const SceneParts<S> parts{scene.resolved,        patch,      *components.shape,
                              components.conditions, geometries, result.bodies};
    maker.attempt("/boundary_conditions", [&] {
        maker.add(check_conditions(parts));
        maker.add(check_parts(parts));
    });
    maker.attempt("/bodies", [&] {
        maker.add(check_extents(parts));
        maker.add(check_overlaps(parts));
    });
    maker.add(check_contacts<S>(parts, components.contacts));
    maker.attempt("", [&] { maker.add(check_axis(parts)); });
    maker.add(check_measured(parts, within.get()));
    maker.throw_if_errors();
    result.warnings = maker.warnings();
    if (const ExactSolution* solution = components.exact_solution.get())
        for (Particles<S>& particles : result.bodies) {
            if (!solution->covers(particles.body())) continue;
            maker.attempt("/exact_solution", *solution, "functions", [&] {
                start_exactly(*solution, particles);
                for (const Field field : {Field::velocity_gradient, Field::affine_velocity})
                    if (particles.has(field))
                        set_exact_gradient(*solution, particles, field, 1e-3 * patch.cell_size()[0]);
            });
        }
    maker.throw_if_errors();
    for (Particles<S>& particles : result.bodies)
        if (particles.has(Field::total_stress))
            for (Index p = 0; p < particles.size(); ++p)
                ParticleBatch<S>::store_stress(particles, p, ParticleBatch<S>::load_stress(particles, p),
                                               Field::total_stress);
    return result;
}

}  // namespace

template <class S>
Assembly<S> assemble(const Scene& scene, const Registry& registry) {
    if (scene.resolved.at("space").at("mode") == "plane_stress")
        return assemble_with<S>(scene, with_plane_stress(registry));
    return assemble_with<S>(scene, registry);
}

#define MATPOINT_INSTANTIATE(S) template Assembly<S> assemble<S>(const Scene&, const Registry&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
