#include "step/phase_timer.hpp"

#include <matpoint/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace matpoint {

namespace {
/// Nodes below this part of the largest particle's mass are not accelerated.
constexpr double mass_cutoff = 1e-13;

/// kg/m^3, of the bodies at the start: the same for a run that continues.
template <class S>
double lowest_density(const std::vector<std::shared_ptr<Material<S>>>& materials) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const auto& material : materials) lowest = std::min(lowest, material->density());
    return lowest;
}
}  // namespace

template <class S>
Engine<S>::Engine(Components<S> components, std::vector<Particles<S>>& bodies, std::vector<int> first_states)
    : components_(std::move(components)),
      bodies_(bodies),
      first_states_(std::move(first_states)),
      levels_(*components_.levels),
      patch_(levels_.patch(0)),
      ordering_(bodies.size()),
      walls_(components_.conditions),
      ties_(levels_.count(), walls_, borders_),
      unilateral_(components_.conditions),
      held_parts_(components_.conditions),
      light_nodes_(components_.light_nodes, lowest_density<S>(components_.materials)) {
    if (!components_.loads.empty()) patch_.require(NodeField::external_force);
    for (const NodeField field : components_.integrator->node_fields()) patch_.require(field);
    if (has_terms())
        for (const NodeField field :
             {NodeField::lumped_velocity, NodeField::resampled_momentum, NodeField::resampled_velocity})
            patch_.require(field);
    if (levels_.count() > 1 && components_.transfer->affine()) patch_.require(NodeField::affine_momentum);
    make_layers();
    for (const Follow& follow : components_.follows) level_starts_.push_back(place_of(follow));
    level_shifts_.assign(level_starts_.size(), Eigen::Vector3d::Zero());
    for (const Particles<S>& particles : bodies_) {
        const Real* mass = particles.column(Field::mass);
        for (Index p = 0; p < particles.size(); ++p)
            largest_mass_ = std::max(largest_mass_, static_cast<double>(mass[p]));
    }
    tally_.reactions.resize(walls_.conditions().size());
    held_.resize(walls_.conditions().size());
}

template <class S>
void Engine<S>::step(long number, double time, double dt, double last_dt) {
    number_ = number;
    time_ = time;
    dt_ = dt;
    const bool staggered = components_.integrator->staggered();
    velocity_from_ = {staggered && number > 0 ? time - last_dt / 2 : time, number > 0 ? -last_dt : 0};
    velocity_to_ = {staggered ? time + dt / 2 : time + dt, dt};
    faults_.clear();
    const double energy_before = tally_.kinetic;
    tally_.strain_work = tally_.external_work = tally_.damped = tally_.contact = 0;
    tally_.impulse = {};
    for (auto& reaction : tally_.reactions) reaction = {};
    if (pairs_)
        for (ContactReport& report : pairs_->reports()) report.force = {};

    prepare();
    unilateral_.measure(nodes_of_, bodies_, ordering_, dt);
    guarded(*components_.integrator, "step",
            [&] { components_.integrator->step(*this, static_cast<Real>(dt)); });
    if (const auto& damping = components_.damping)
        guarded(*damping, "stops", [&] {
            if (damping->stops(energy_before, tally_.kinetic)) stop();
        });
}

template <class S>
void Engine<S>::prepare() {
    const Timer timer(*this, StepPhase::order);
    move_levels();
    for (Particles<S>& particles : bodies_)
        guarded(*components_.shape, "start_step",
                [&] { components_.shape->start_step(levels_.finest(), particles); });
    if (ordering_.update(levels_, bodies_, *components_.shape) || !located_) {
        make_blocks();
        borders_.locate(levels_, layers_);
        walls_.locate(layers_, borders_.followers());
        inside_.resize(static_cast<std::size_t>(patch_.node_count()));
        for (int i = 0; i < static_cast<int>(patch_.node_count()); ++i)
            inside_[static_cast<std::size_t>(i)] =
                layers_[patch_.layer_of(i)]->inside(patch_.node_coordinates(i));
        for (std::size_t i = 0; i < borders_.followers().size(); ++i)
            if (borders_.followers()[i] != 0) inside_[i] = 0;
        unilateral_.locate(layers_, inside_, walls_.prescribed_components());
        located_ = true;
    }
}

template <class S>
void Engine<S>::project_velocity(double time) {
    const Tally kept = tally_;
    time_ = time;
    dt_ = 0;  // no step follows, along which walls would move
    velocity_from_ = {time};
    prepare();
    project({.velocity = true});
    tally_ = kept;  // no step was taken
}

template <class S>
bool Engine<S>::extends(NodeField momentum) const {
    const auto field = components_.transfer->affine();
    // L is a step older than the velocity that is projected anew: only what came with it extends it.
    return field && !(field == Field::velocity_gradient && momentum == NodeField::remapped_velocity);
}

template <class S>
void Engine<S>::scatter(const Scatter& request) {
    const Timer timer(*this, StepPhase::scatter);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        Scatter own = request;
        if (bodies_[b].has(Field::total_stress)) own.stress = Field::total_stress;
        if (request.momentum == NodeField::resampled_momentum)
            own.velocity_slot = bodies_[b].slot(Field::grid_velocity);
        own.affine_slot = request.momentum && extends(*request.momentum)
                              ? bodies_[b].slot(*components_.transfer->affine())
                              : -1;
        const auto& ranges = ordering_.ranges(b);
        for (const std::vector<Index>& colour : ordering_.colours(b))
            parallel_for(static_cast<Index>(colour.size()),
                         bodies_[b].size() / static_cast<Index>(ordering_.colours(b).size()), [&](Index k) {
                             const BlockRange& range =
                                 ranges[static_cast<std::size_t>(colour[static_cast<std::size_t>(k)])];
                             guarded(*components_.shape, "scatter", [&] {
                                 components_.shape->scatter(nodes(b, range.level), bodies_[b], range.begin,
                                                            range.end, own);
                             });
                         });
    }
    if (levels_.count() > 1 && request.momentum && extends(*request.momentum))
        extend_to_parents(*request.momentum);
}

template <class S>
void Engine<S>::project(typename Phases<S>::Projection projection) {
    const Timer timer(*this, StepPhase::nodes);
    Scatter request;
    if (projection.velocity) {
        request.mass = true;
        request.momentum = NodeField::velocity;
        patch_.clear(NodeField::mass);
        patch_.clear(NodeField::velocity);
    }
    if (projection.internal_force) {
        request.internal_force = true;
        patch_.clear(NodeField::force);
    }
    scatter(request);
    if (projection.velocity) {
        apply_loads();  // while mass is what the particles gave, not yet folded
        held_parts_.hold(nodes_of_, inside_, bodies_, ordering_, *components_.shape, walls_);
        ties_.fold_mass(patch_);
        if (pairs_) meet();
        light_nodes_.locate(layers_, inside_, walls_.prescribed_components(), borders_.left(),
                            !components_.loads.empty());
        ties_.fold_momentum(patch_, NodeField::velocity, velocity_from_);
        // A transfer that replaces particle velocities lets walls stop momentum here already; the
        // momentum itself is kept in the acceleration until that is counted.
        const Real share = components_.transfer->grid_share();
        if (share > 0)
            for (int c = 0; c < S::dimension; ++c)
                std::copy_n(patch_.column(NodeField::velocity, c), patch_.node_count(),
                            patch_.column(NodeField::acceleration, c));
        finish_velocity(NodeField::velocity, velocity_from_);
        if (share > 0)
            add_reactions(NodeField::acceleration, NodeField::velocity, static_cast<double>(share),
                          velocity_from_);
        if (!projection.internal_force) {  // it is to be read before it is accelerated, as that of this step
            const PathMean ahead{velocity_from_.time, dt_};
            walls_.constrain(patch_, NodeField::velocity, ahead);
            if (pairs_) separate(NodeField::velocity);
            light_nodes_.keep_velocity(patch_);
            light_nodes_.follow_velocity(patch_, NodeField::velocity);
            if (dt_ > 0) unilateral_.push_ahead(patch_);  // else no step follows
            ties_.fill_velocity(patch_, NodeField::velocity, ahead);
            if (has_terms()) add_terms(NodeField::velocity, ahead);
        }
        terms_added_ = has_terms() && !projection.internal_force;
    }
    if (projection.internal_force) ties_.fold_force(patch_, NodeField::force);
}

template <class S>
void Engine<S>::apply_loads() {
    if (components_.loads.empty()) return;
    const Timer timer(*this, StepPhase::loads);
    patch_.clear(NodeField::external_force);
    LoadContext<S> context{time_,
                           patch_,
                           bodies_,
                           *components_.shape,
                           components_.exact_solution.get(),
                           nodes_of_,
                           levels_.count() > 1 ? &level_at_ : nullptr};
    for (const auto& load : components_.loads) guarded(*load, "apply", [&] { load->apply(context); });
    double squares = 0;
    for (int c = 0; c < S::dimension; ++c) {
        const Real* force = patch_.column(NodeField::external_force, c);
        double total = 0, size = 0;
        for (Index i = 0; i < patch_.node_count(); ++i) {
            total += static_cast<double>(force[i]);
            size += std::abs(static_cast<double>(force[i]));
        }
        load_force_[static_cast<std::size_t>(c)] = total;
        squares += size * size;
    }
    const Real* mass = patch_.column(NodeField::mass);
    const double whole = std::accumulate(mass, mass + patch_.node_count(), 0.0);
    tally_.load_acceleration = whole > 0 ? std::sqrt(squares) / whole : 0;
    ties_.fold_force(patch_, NodeField::external_force);
}

template <class S>
void Engine<S>::finish_velocity(NodeField field, const PathMean& mean) {
    // However small the mass, momentum over mass is a mean of the particles' velocities, which read it
    // back: cutting it off would strain a body that flies freely.
    const Real* mass = patch_.column(NodeField::mass);
    const Real smallest = std::numeric_limits<Real>::min();
    for_nodes([&](Index, Index begin, Index end) {
        for (int c = 0; c < S::dimension; ++c) {
            Real* v = patch_.column(field, c);
            for (Index i = begin; i < end; ++i) v[i] = mass[i] > smallest ? v[i] / mass[i] : Real(0);
        }
    });
    walls_.constrain(patch_, field, mean);
    ties_.fill_velocity(patch_, field, mean);
}

template <class S>
void Engine<S>::accelerate(Real dt, Real factor) {
    const Timer timer(*this, StepPhase::nodes);
    const bool loaded = !components_.loads.empty();
    const Real* mass = patch_.column(NodeField::mass);
    const Real cutoff = static_cast<Real>(mass_cutoff * largest_mass_);
    if (std::exchange(terms_added_, false))
        for (int c = 0; c < S::dimension; ++c)
            std::copy_n(patch_.column(NodeField::lumped_velocity, c), patch_.node_count(),
                        patch_.column(NodeField::velocity, c));

    for_nodes([&](Index, Index begin, Index end) {
        for (int c = 0; c < S::dimension; ++c) {
            Real* f = patch_.column(NodeField::force, c);
            Real* a = patch_.column(NodeField::acceleration, c);
            const Real* external = loaded ? patch_.column(NodeField::external_force, c) : nullptr;
            for (Index i = begin; i < end; ++i) {
                f[i] = factor * (external ? f[i] + external[i] : f[i]);
                a[i] = mass[i] > cutoff ? f[i] / mass[i] : Real(0);
            }
        }
    });
    walls_.constrain_acceleration(patch_, velocity_from_, velocity_to_, dt_);
    unilateral_.restore(patch_);
    light_nodes_.restore_velocity(patch_);
    if (pairs_) add_contact_forces(dt);
    act_with_tools();
    light_nodes_.follow_acceleration(patch_);
    unilateral_.push_again(patch_, dt);
    if (components_.measures_balance) measure_balance(factor);
    if (components_.damping) damp(dt);
    for_nodes([&](Index, Index begin, Index end) {
        for (int c = 0; c < S::dimension; ++c) {
            const Real* a = patch_.column(NodeField::acceleration, c);
            Real* v = patch_.column(NodeField::velocity, c);
            for (Index i = begin; i < end; ++i) v[i] += a[i] * dt;
        }
    });
    walls_.constrain(patch_, NodeField::velocity, velocity_to_);
    follow_light_nodes(components_.transfer->grid_share() / dt);
    unilateral_.push(patch_, dt);
    ties_.fill_acceleration(patch_, velocity_from_, velocity_to_, dt_);
    ties_.fill_velocity(patch_, NodeField::velocity, velocity_to_);
    add_reactions(NodeField::force, NodeField::acceleration, dt_,
                  {(velocity_from_.time + velocity_to_.time) / 2});
    if (has_terms()) {
        add_terms(NodeField::velocity, velocity_to_);
        // The rounds before the last were of the same momentum: what walls gave to it is taken back.
        add_reactions(NodeField::resampled_momentum, NodeField::resampled_velocity, -1, velocity_to_);
    }
    if (loaded) add_load_work(dt, factor);
    if (components_.damping) add_damping_work(dt);
    if (!components_.contacts.empty()) add_contact_work(dt);
    if (!unilateral_.empty()) add_pushes(dt);
}

/// `share` of the velocity becomes the particles', 1/s: walls take what light nodes give to them and their
/// images.
template <class S>
void Engine<S>::follow_light_nodes(Real share) {
    const bool count = share > 0 && !light_nodes_.empty();
    if (count) {
        ties_.fill_velocity(patch_, NodeField::velocity, velocity_to_);
        walls_.keep_ghosts(patch_, NodeField::velocity);
    }
    light_nodes_.follow_velocity(patch_, NodeField::velocity, share);
    if (!count) return;
    // What ghosts are images of may follow from others.
    if (levels_.count() > 1) ties_.fill_velocity(patch_, NodeField::velocity, velocity_to_);
    walls_.add_change_of_ghosts(patch_, NodeField::velocity, velocity_to_, share);
}

template <class S>
void Engine<S>::add_load_work(Real dt, Real factor) {
    for (std::size_t c = 0; c < S::dimension; ++c)
        tally_.impulse[c] += static_cast<double>(factor) * load_force_[c] * dt_;
    tally_.external_work += static_cast<double>(factor) *
                            node_work(dt, [&](int c) { return patch_.column(NodeField::external_force, c); });
}

template <class S>
void Engine<S>::add_reactions(NodeField source, NodeField value, double share, const PathMean& mean) {
    if (walls_.conditions().empty()) return;
    std::vector<typename Walls<S>::Sum> sums(walls_.conditions().size());
    walls_.reaction(patch_, source, value, mean, sums);
    add_reactions(sums, share);
}

template <class S>
void Engine<S>::add_pushes(Real dt) {
    std::vector<typename Walls<S>::Sum> sums(walls_.conditions().size());
    const double nearer = unilateral_.reaction(patch_, dt, sums);
    add_reactions(sums, 1);
    tally_.unbalanced_force = std::max(0.0, tally_.unbalanced_force - nearer);
}

template <class S>
void Engine<S>::add_reactions(const std::vector<typename Walls<S>::Sum>& sums, double share) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
        tally_.external_work += sums[k].power * share;
        if (sums[k].held) held_[k] = 1;
        for (std::size_t c = 0; c < S::dimension; ++c) {
            tally_.impulse[c] += sums[k].total[c] * share;
            tally_.reactions[k][c] += sums[k].total[c] * share / dt_;
        }
    }
}

template <class S>
void Engine<S>::remap() {
    const Timer timer(*this, StepPhase::nodes);
    patch_.clear(NodeField::remapped_velocity);
    scatter({.momentum = NodeField::remapped_velocity});
    ties_.fold_momentum(patch_, NodeField::remapped_velocity, velocity_to_);
    finish_velocity(NodeField::remapped_velocity, velocity_to_);
    if (pairs_) {
        separate(NodeField::remapped_velocity);
        separation_.clear();
    }
    light_nodes_.follow_velocity(patch_, NodeField::remapped_velocity);
    unilateral_.hold(patch_, NodeField::remapped_velocity);
    ties_.fill_velocity(patch_, NodeField::remapped_velocity, velocity_to_);
    if (has_terms()) add_terms(NodeField::remapped_velocity, velocity_to_);
}

#define MATPOINT_INSTANTIATE(S) template class Engine<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
