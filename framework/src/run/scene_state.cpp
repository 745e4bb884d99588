// What a SceneSimulation shows to outputs, and its state as a checkpoint holds it.
#include "run/derived_fields.hpp"
#include "run/dual_contour.hpp"
#include "run/scene_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matpoint {

template <class S>
const Particles<S>& SceneSimulation<S>::body(const std::string& name) const {
    for (const Particles<S>& particles : assembly_.bodies)
        if (particles.body() == name) return particles;
    throw std::invalid_argument("there is no body \"" + name + "\"");
}

template <class S>
std::vector<std::string> SceneSimulation<S>::bodies() const {
    std::vector<std::string> names;
    for (const Particles<S>& particles : assembly_.bodies) names.push_back(particles.body());
    return names;
}

template <class S>
std::size_t SceneSimulation<S>::particle_count(const std::string& name) const {
    return static_cast<std::size_t>(body(name).size());
}

template <class S>
std::size_t SceneSimulation<S>::particle_count() const {
    std::size_t count = 0;
    for (const Particles<S>& particles : assembly_.bodies)
        count += static_cast<std::size_t>(particles.size());
    return count;
}

template <class S>
std::vector<std::string> SceneSimulation<S>::fields(const std::string& name) const {
    return field_names(body(name));
}

template <class S>
int SceneSimulation<S>::components(const std::string& name, const std::string& field) const {
    return field_components(body(name), field);
}

template <class S>
std::vector<double> SceneSimulation<S>::column(const std::string& name, const std::string& field,
                                               int component) const {
    const Particles<S>& particles = body(name);
    const int components = field_components(particles, field);
    if (component < 0 || component >= components)
        throw std::invalid_argument(
            fmt::format("particles of body \"{}\" have no component {} of \"{}\"", name, component, field));
    return field_column(particles, field, component);
}

template <class S>
double SceneSimulation<S>::mass() const {
    double sum = 0;
    for (const Particles<S>& particles : assembly_.bodies) {
        double own = 0;
        // By id, so that sorting does not change the rounding.
        for (const double m : field_column(particles, "mass", 0)) own += m;
        sum += own;
    }
    return sum;
}

template <class S>
std::array<double, 3> SceneSimulation<S>::reaction(const std::string& boundary_condition) const {
    std::array<double, 3> sum{};
    const auto& conditions = assembly_.components.conditions;
    for (std::size_t k = 0; k < conditions.size(); ++k)
        if (conditions[k].name == boundary_condition)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += engine_.tally().reactions[k][c];
    return sum;
}

template <class S>
std::vector<std::string> SceneSimulation<S>::contacts() const {
    std::vector<std::string> names;
    for (const PlacedContact<S>& placed : engine_.contacts()) names.push_back(placed.name);
    return names;
}

template <class S>
std::size_t SceneSimulation<S>::number_of_contact(const std::string& name) const {
    for (std::size_t k = 0; k < engine_.contacts().size(); ++k)
        if (engine_.contacts()[k].name == name) return k;
    throw std::invalid_argument("there is no contact \"" + name + "\"");
}

template <class S>
ContactReport SceneSimulation<S>::contact(const std::string& name) const {
    return engine_.contact_report(number_of_contact(name));
}

/// On a lattice as fine as the grid, or as pictures need, that reaches a cell beyond it.
template <class S>
SurfaceMesh SceneSimulation<S>::tool_surface(const std::string& contact) const {
    constexpr double most_nodes = 4e5;
    const Tool<S>* const tool = engine_.contacts()[number_of_contact(contact)].contact->tool();
    if (!tool) return {};
    const typename S::Position size =
        engine_.patch().node_position(engine_.patch().cells()) - engine_.patch().min();
    Lattice lattice{S::dimension, Eigen::Vector3d::Zero(), smallest_cell_, {1, 1, 1}};
    while ((size.array() / lattice.spacing + 3).prod() > most_nodes) lattice.spacing *= 2;
    for (int a = 0; a < S::dimension; ++a) {
        lattice.min[a] = engine_.patch().min()[a] - lattice.spacing;
        lattice.nodes[static_cast<std::size_t>(a)] =
            static_cast<int>(std::ceil(size[a] / lattice.spacing)) + 3;
    }
    return guarded(*tool, "signed_distance", [&] {
        return dual_contour(lattice, [&](const Eigen::Vector3d& x) { return tool->signed_distance(x); });
    });
}

template <class S>
std::size_t SceneSimulation<S>::bytes_per_particle() const {
    std::size_t bytes = 0;
    for (const Particles<S>& particles : assembly_.bodies)
        bytes += particles.bytes_per_particle() * static_cast<std::size_t>(particles.size());
    return particle_count() == 0 ? 0 : (bytes + particle_count() - 1) / particle_count();
}

template <class S>
Json SceneSimulation<S>::phase_seconds() const {
    Json seconds = Json::object();
    for (std::size_t k = 0; k < step_phases.size(); ++k) seconds[step_phases[k]] = engine_.seconds()[k];
    return seconds;
}

template <class S>
Json SceneSimulation<S>::levels() const {
    const Levels<S>& levels = engine_.levels();
    if (levels.count() == 1) return {};
    Json all = Json::array();
    double cells = 0, finest = 1;
    for (int level = 0; level < levels.count(); ++level) {
        Index particles = 0;
        for (std::size_t b = 0; b < assembly_.bodies.size(); ++b)
            for (const BlockRange& range : engine_.ordering().ranges(b))
                if (range.level == level) particles += range.end - range.begin;
        all.push_back({{"cells", levels.cells(level)}, {"particles", particles}, {"steps", step_}});
        cells += static_cast<double>(levels.cells(level));
    }
    for (const int along : levels.cells_along(levels.count() - 1)) finest *= along;
    return {{"levels", std::move(all)}, {"cells_over_uniform", cells / finest}};
}

template <class S>
std::size_t SceneSimulation<S>::memory_bytes() const {
    return bytes_per_particle() * particle_count() + engine_.node_bytes();
}

template <class S>
std::vector<std::string> SceneSimulation<S>::particle_fields() const {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const Particles<S>& particles : assembly_.bodies) {
        for (int slot = 0; slot < particles.field_count(); ++slot) add(particles.name(slot));
        if (particles.has(Field::id)) add("id");
    }
    return names;
}

template <class S>
std::vector<std::string> SceneSimulation<S>::node_fields() const {
    std::vector<std::string> names;
    for (int f = 0; f < matpoint::node_fields; ++f)
        if (const auto field = static_cast<NodeField>(f); engine_.patch().has(field))
            names.emplace_back(node_field_name(field));
    return names;
}

template <class S>
template <class Numbers_, class Visitor>
void SceneSimulation<S>::Numbers::visit(Numbers_& n, const Visitor& visitor) {
    visitor("strain", n.strain);
    visitor("external", n.external);
    visitor("damped", n.damped);
    visitor("contact", n.contact);
    visitor("first_energy", n.first_energy);
    visitor("largest_energy", n.largest_energy);
    visitor("given_energy", n.given_energy);
    visitor("energy_gain", n.energy_gain);
    visitor("energy_loss", n.energy_loss);
    visitor("largest_carried", n.largest_carried);
    visitor("scene_from_step", n.scene_from_step);
    visitor("first_mass", n.first_mass);
    visitor("lost_mass", n.lost_mass);
    visitor("largest_momentum", n.largest_momentum);
    visitor("momentum_drift", n.momentum_drift);
    visitor("fixed_step", n.fixed_step);
    visitor("fixed_from_step", n.fixed_from_step);
    visitor("fixed_from_time", n.fixed_from_time);
    visitor("error_count", n.error.count);
    visitor("error_sum", n.error.sum);
    visitor("error_squares", n.error.squares);
    visitor("error_largest", n.error.largest);
    for (std::size_t c = 0; c < 3; ++c) visitor(fmt::format("given_momentum_{}", c), n.given_momentum[c]);
}

/// What checkpoints call the note that a boundary condition has held something.
std::string held_name(std::size_t condition) {
    return fmt::format("boundary_condition_{}_held", condition);
}

/// What checkpoints call a number of a contact.
std::string contact_name(std::size_t contact, const std::string& name) {
    return fmt::format("contact_{}_{}", contact, name);
}

/// What checkpoints call a coordinate of what a level follows, or of how far it went.
std::string level_name(std::size_t level, const char* what, int axis) {
    return fmt::format("level_{}_{}_{}", level + 1, what, axis);
}

/// Every number of a step's tally by name, for checkpoints: sums over particles in another order would differ
/// in their last bits.
template <class Tally_, class Visitor>
void visit_tally(Tally_& t, const Visitor& visitor) {
    visitor("kinetic", t.kinetic);
    visitor("noise_energy", t.noise_energy);
    visitor("unbalanced_force", t.unbalanced_force);
    visitor("carried_force", t.carried_force);
    visitor("momentum_scale", t.momentum_scale);
    visitor("particle_speed", t.largest_speed);
    visitor("wave_speed", t.largest_wave_speed);
    visitor("compression", t.largest_compression);
    visitor("load_acceleration", t.load_acceleration);
    for (std::size_t c = 0; c < 3; ++c) {
        visitor(fmt::format("momentum_{}", c), t.momentum[c]);
        for (std::size_t k = 0; k < t.reactions.size(); ++k)
            visitor(fmt::format("reaction_{}_{}", k, c), t.reactions[k][c]);
    }
}

template <class S>
CheckpointData SceneSimulation<S>::state() const {
    CheckpointData data;
    data.scene = scene_text_;
    data.folder = folder_;
    data.step = step_;
    data.time = time_;
    data.plugins = plugins_;
    data.numbers["last_time_step"] = last_time_step_;
    const auto save = [&](const std::string& name, const double& value) { data.numbers[name] = value; };
    Numbers::visit(numbers_, save);
    visit_tally(engine_.tally(), save);
    for (std::size_t k = 0; k < engine_.held().size(); ++k) data.numbers[held_name(k)] = engine_.held()[k];
    for (std::size_t k = 0; k < engine_.contacts().size(); ++k)
        for (const auto& [name, value] : engine_.contact_state(k))
            data.numbers[contact_name(k, name)] = value;
    for (std::size_t k = 0; k < engine_.level_starts().size(); ++k)
        for (int a = 0; a < S::dimension; ++a) {
            data.numbers[level_name(k, "start", a)] = engine_.level_starts()[k][a];
            data.numbers[level_name(k, "shift", a)] = engine_.level_shifts()[k][a];
        }
    for (std::size_t b = 0; b < assembly_.bodies.size(); ++b) {
        const Particles<S>& particles = assembly_.bodies[b];
        CheckpointData::Body body;
        body.name = particles.body();
        body.size = particles.size();
        for (int slot = 0; slot < particles.field_count(); ++slot)
            for (int c = 0; c < particles.components(slot); ++c) {
                const auto* column = particles.column(slot, c);
                body.columns.push_back(
                    {particles.name(slot), c, std::vector(column, column + particles.size())});
            }
        body.ids = particles.ids();
        for (const BlockRange& range : engine_.ordering().ranges(b)) {
            body.block_numbers.push_back(engine_.levels().number_of(range.level, range.block));
            body.block_begins.push_back(range.begin);
        }
        data.bodies.push_back(std::move(body));
    }
    return data;
}

/// What particles have lived through can't be made up: a change of the scene must not ask for fields
/// that the checkpoint hasn't got.
template <class S>
void expect_fields(const Particles<S>& particles, const CheckpointData::Body& saved) {
    const auto refuse = [&](std::string_view field) {
        throw CheckpointError(fmt::format(
            "the checkpoint has no field \"{}\" of body \"{}\", which the changed scene needs: run it from "
            "the start",
            field, particles.body()));
    };
    for (int slot = 0; slot < particles.field_count(); ++slot) {
        const auto holds = [&](const CheckpointData::Column& column) {
            return column.field == particles.name(slot);
        };
        if (std::none_of(saved.columns.begin(), saved.columns.end(), holds)) refuse(particles.name(slot));
    }
    if (particles.has(Field::id) && saved.ids.size() != static_cast<std::size_t>(saved.size))
        refuse(field_name(Field::id));
}

template <class S>
void SceneSimulation<S>::restore(const CheckpointData& data) {
    using Real = typename S::Real;
    step_ = data.step;
    time_ = data.time;
    const auto load = [&](const std::string& name, double& value) {
        const auto saved = data.numbers.find(name);
        if (saved == data.numbers.end())
            throw CheckpointError(fmt::format(
                "the checkpoint lacks \"{}\": the Matpoint that wrote it, or its scene, was another one",
                name));
        value = saved->second;
    };
    load("last_time_step", last_time_step_);
    Numbers::visit(numbers_, load);
    Tally tally = engine_.tally();
    visit_tally(tally, [&](const std::string& name, double& value) {
        // A restart may have another condition, which has not held anything yet.
        if (name.starts_with("reaction_") && !data.numbers.contains(name))
            value = 0;
        else
            load(name, value);
    });
    engine_.restore(tally);
    for (std::size_t k = 0; k < engine_.held().size(); ++k)
        if (const auto held = data.numbers.find(held_name(k)); held != data.numbers.end())
            engine_.held()[k] = held->second != 0;
    for (std::size_t k = 0; k < engine_.contacts().size(); ++k) {
        std::map<std::string, double> state = engine_.contact_state(k);
        for (auto& [name, value] : state)  // a restart may have another contact, which has done nothing yet
            if (const auto saved = data.numbers.find(contact_name(k, name)); saved != data.numbers.end())
                value = saved->second;
        engine_.restore_contact(k, state);
    }
    std::vector<Eigen::Vector3d> starts = engine_.level_starts(), shifts = engine_.level_shifts();
    for (std::size_t k = 0; k < starts.size(); ++k)
        for (int a = 0; a < S::dimension; ++a) {
            load(level_name(k, "start", a), starts[k][a]);
            load(level_name(k, "shift", a), shifts[k][a]);
        }
    engine_.restore_levels(std::move(starts), std::move(shifts));
    if (rest_ > 0 && data.scene != scene_text_) numbers_.scene_from_step = static_cast<double>(step_);
    if (numbers_.fixed_step != step_length_) {
        numbers_.fixed_step = step_length_;
        numbers_.fixed_from_step = static_cast<double>(step_);
        numbers_.fixed_from_time = time_;
    }
    for (std::size_t b = 0; b < assembly_.bodies.size(); ++b) {
        Particles<S>& particles = assembly_.bodies[b];
        const auto body = std::find_if(
            data.bodies.begin(), data.bodies.end(),
            [&](const CheckpointData::Body& candidate) { return candidate.name == particles.body(); });
        if (body == data.bodies.end())
            throw CheckpointError("the checkpoint has no body \"" + particles.body() + "\"");
        expect_fields(particles, *body);
        particles.resize(static_cast<Index>(body->size));
        for (const CheckpointData::Column& column : body->columns) {
            const int slot = particles.slot(column.field);
            const auto* values = std::get_if<std::vector<Real>>(&column.values);
            if (slot < 0) continue;  // an output that is no longer there asked for it
            if (!values || column.component >= particles.components(slot))
                throw CheckpointError("field \"" + column.field +
                                      "\" in the checkpoint is of another space or precision");
            std::copy(values->begin(), values->end(), particles.column(slot, column.component));
        }
        if (particles.has(Field::id)) particles.ids() = body->ids;
        std::vector<BlockRange> ranges;
        for (std::size_t r = 0; r < body->block_numbers.size(); ++r) {
            const bool last = r + 1 == body->block_numbers.size();
            const int number = body->block_numbers[r];
            ranges.push_back({engine_.levels().block_of(number), static_cast<Index>(body->block_begins[r]),
                              static_cast<Index>(last ? body->size : body->block_begins[r + 1]),
                              engine_.levels().level_of(number)});
        }
        engine_.restore(b, std::move(ranges));
    }
}

#define MATPOINT_INSTANTIATE(S) template class SceneSimulation<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
