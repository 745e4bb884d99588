#include "run/assemble.hpp"

#include <matpoint/damping.hpp>

#include "run/first_state.hpp"
#include "run/make_bodies.hpp"
#include "run/make_placed.hpp"
#include "run/maker.hpp"
#include "run/plane_stress.hpp"
#include "run/scene_checks.hpp"

#include <algorithm>
#include <map>

namespace matpoint {

namespace {

/// What the scene's bodies and places don't matter for.
template <class S>
void make_method(Maker& maker, Components<S>& components) {
    components.grid = maker.make<Grid<S>>("grid", "/grid");
    components.shape = maker.make<ShapeFunction<S>>("shape_function", "/shape_function");
    components.light_nodes = maker.json("/grid").at("light_nodes").get<double>();
    components.transfer = maker.make<Transfer<S>>("transfer", "/transfer");
    components.integrator = maker.make<Integrator<S>>("integrator", "/integrator");
    for (std::size_t k = 0; k < maker.json("/loads").size(); ++k)
        components.loads.push_back(maker.make<Load<S>>("load", "/loads/" + std::to_string(k)));
    if (maker.json("").contains("damping"))
        components.damping = maker.make<Damping<S>>("damping", "/damping");
}

/// The body or tool of a name.
template <class S>
Follow followed(Maker& maker, const Components<S>& components, const std::string& name,
                const std::string& pointer) {
    if (name.empty()) return {};
    std::vector<std::string> known;
    for (const auto& [body, unused] : maker.json("/bodies").items()) {
        if (body == name) return {.body = known.size()};
        known.push_back(body);
    }
    for (std::size_t k = 0; k < components.contacts.size(); ++k) {
        if (!components.contacts[k].contact || !components.contacts[k].contact->tool()) continue;
        if (components.contacts[k].name == name) return {.contact = k};
        known.push_back(components.contacts[k].name);
    }
    maker.mistake(pointer, "there is no body or tool \"" + name + "\"" + did_you_mean(name, known));
    return {};
}

/// Levels of the grid, for this shape function.
template <class S>
void make_levels(Maker& maker, Components<S>& components) {
    const Patch<S>& patch = components.grid->patch();
    for (std::size_t a = 0; a < S::dimension; ++a)
        if (patch.cells()[a] + 1 < components.shape->width())
            maker.mistake("/grid", "needs at least " + std::to_string(components.shape->width() - 1) +
                                       " cells on every axis for this shape function");
    maker.throw_if_errors();
    std::vector<Refined> refined;
    std::vector<double> refinement;
    guarded(*components.grid, "refined", [&] { refined = components.grid->refined(); });
    guarded(*components.shape, "refinement", [&] { refinement = components.shape->refinement(); });
    std::vector<const Geometry*> regions;
    for (std::size_t k = 0; k < refined.size(); ++k) {
        regions.push_back(refined[k].within);
        components.follows.push_back(
            followed(maker, components, refined[k].follow, "/grid/levels/" + std::to_string(k) + "/follow"));
    }
    if (!regions.empty() && refinement.empty())
        maker.mistake("/shape_function",
                      "can't be made of itself on cells of half the size: it has no levels");
    else
        maker.attempt("/grid/levels", [&] {
            components.levels = std::make_shared<Levels<S>>(components.grid->patch(), std::move(regions),
                                                            std::move(refinement));
        });
    maker.throw_if_errors();
}

/// By body.
template <class S>
std::vector<std::shared_ptr<Material<S>>> make_materials(Maker& maker) {
    std::map<std::string, std::shared_ptr<Material<S>>> by_name;
    for (const auto& [name, unused] : maker.json("/materials").items())
        by_name[name] = maker.make<Material<S>>("material", join_pointer("/materials", name));
    std::vector<std::shared_ptr<Material<S>>> materials;
    for (const Json& body : maker.json("/bodies"))
        materials.push_back(by_name.at(body.at("material").get<std::string>()));
    return materials;
}

/// Loads and tools are told of the bodies.
template <class S>
void start(Maker& maker, Assembly<S>& assembly) {
    Components<S>& components = assembly.components;
    const Patch<S>& patch = components.grid->patch();
    for (std::size_t k = 0; k < components.loads.size(); ++k)
        maker.attempt("/loads/" + std::to_string(k), [&] {
            guarded(*components.loads[k], "start",
                    [&] { components.loads[k]->start(patch, assembly.bodies); });
        });
    for (std::size_t k = 0; k < components.contacts.size(); ++k)
        if (Tool<S>* const tool = components.contacts[k].contact->tool()) {
            const std::string pointer = "/contacts/" + std::to_string(k);
            maker.attempt(pointer, *tool, "start", [&] {
                for (const std::string& warning : tool->start(patch, assembly.bodies))
                    maker.add({{false, pointer, warning}});
            });
        }
}

template <class S>
void check(Maker& maker, const SceneParts<S>& parts, const Components<S>& components,
           const Geometry* measured) {
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
    maker.add(check_measured(parts, measured));
    maker.throw_if_errors();
}

/// The state at time 0: that of the exact solution, if there is one.
template <class S>
void set_first_state(Maker& maker, Assembly<S>& assembly) {
    const double reach = 1e-3 * assembly.components.grid->patch().cell_size()[0];
    const ExactSolution* const solution = assembly.components.exact_solution.get();
    for (Particles<S>& particles : assembly.bodies) {
        if (solution && solution->covers(particles.body()))
            maker.attempt("/exact_solution", *solution, "functions", [&] {
                start_exactly(*solution, particles);
                for (const Field field : {Field::velocity_gradient, Field::affine_velocity})
                    if (particles.has(field)) set_exact_gradient(*solution, particles, field, reach);
            });
        if (particles.has(Field::total_stress))
            for (Index p = 0; p < particles.size(); ++p)
                ParticleBatch<S>::store_stress(particles, p, ParticleBatch<S>::load_stress(particles, p),
                                               Field::total_stress);
    }
    maker.throw_if_errors();
}

template <class S>
Assembly<S> assemble_with(const Scene& scene, const Registry& registry) {
    Maker maker(scene, registry);
    Assembly<S> result;
    Components<S>& components = result.components;
    make_method(maker, components);
    make_conditions(maker, components.conditions);
    make_contacts(maker, components);
    std::shared_ptr<Geometry> measured;
    if (scene.resolved.contains("exact_solution")) {
        const Json& own = maker.json("/exact_solution");
        components.exact_solution = maker.make<ExactSolution>("exact_solution", "/exact_solution");
        if (own.contains("within")) measured = maker.make<Geometry>("geometry", "/exact_solution/within");
        result.error.emplace(components.exact_solution, own, measured);
    }
    make_outputs(maker, result.outputs);
    components.measures_balance = components.damping || scene.resolved.at("time").contains("until_at_rest") ||
                                  std::ranges::any_of(result.outputs, [](const ScheduledOutput& scheduled) {
                                      return scheduled.output && scheduled.output->observes_balance();
                                  });
    components.materials = make_materials<S>(maker);
    const auto geometries = make_geometries<S>(maker);
    maker.throw_if_errors();
    make_levels(maker, components);
    const Patch<S>& patch = components.grid->patch();
    make_bodies(maker, geometries, result);
    start(maker, result);
    check(maker,
          SceneParts<S>{scene.resolved, patch, *components.shape, components.conditions, geometries,
                        result.bodies},
          components, measured.get());
    result.warnings = maker.warnings();
    set_first_state(maker, result);
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
