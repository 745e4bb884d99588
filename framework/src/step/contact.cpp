// Bodies that meet: layers of nodes, and what contact does to them in a step.
#include <matpoint/parallel.hpp>

#include "step/phase_timer.hpp"

namespace matpoint {

template <class S>
void Engine<S>::make_layers() {
    const ContactLayers& own = components_.layers;
    for (int level = 0; level < levels_.count(); ++level) {
        Patch<S>& first = levels_.patch(level);
        const std::size_t begin = layers_.size();
        layers_.push_back(&first);
        for (std::size_t k = 1; k < own.count; ++k) {
            further_layers_.push_back(first.layer());
            layers_.push_back(&further_layers_.back());
        }
        for (std::size_t b = 0; b < bodies_.size(); ++b)
            nodes_of_.push_back(own.count > 1 ? layers_[begin + own.layer[b]] : &first);
    }
    if (own.count > 1) pairs_.emplace(components_.contacts, own, patch_, *components_.shape);
}

template <class S>
void Engine<S>::make_blocks() {
    const std::size_t per_level = layers_.size() / static_cast<std::size_t>(levels_.count());
    std::vector<std::vector<std::size_t>> bodies(per_level);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        bodies[pairs_ ? components_.layers.layer[b] : 0].push_back(b);
    std::vector<std::vector<int>> blocks;
    for (std::size_t k = 0; k < layers_.size(); ++k)
        blocks.push_back(ordering_.blocks(*layers_[k], bodies[k % per_level]));
    LevelBorders<S>::add_parents(levels_, blocks);
    patch_.set_blocks(layers_, blocks);
    if (!pairs_) return;
    std::vector<ParticlesOfBlock> particles;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (const BlockRange& range : ordering_.ranges(b))
            particles.push_back({b, range.block, range.begin, range.end, range.level});
    pairs_->nodes().locate(layers_, components_.layers.layer, particles);
}

template <class S>
void Engine<S>::meet() {
    pairs_->nodes().find(bodies_, inside_, walls_.mirrors(), pairs_->needs_neighbours());
    pairs_->orient();
    separation_.clear();
}

template <class S>
void Engine<S>::read_meeting(NodeField field) {
    const auto& shares = pairs_->nodes().shares();
    meeting_.resize(shares.size());
    for (std::size_t k = 0; k < shares.size(); ++k)
        for (int c = 0; c < S::dimension; ++c)
            meeting_[k][c] = static_cast<double>(patch_.column(field, c)[shares[k].place]);
}

/// Velocities that are read as they are, before forces or after all of them.
template <class S>
void Engine<S>::separate(NodeField velocity) {
    if (!pairs_->meet() || dt_ == 0) return;  // nothing moves without a step
    read_meeting(velocity);
    pairs_->resolve(meeting_, walls_.prescribed_components(), dt_, separation_);
    const auto& shares = pairs_->nodes().shares();
    for (std::size_t k = 0; k < shares.size(); ++k)
        for (int c = 0; c < S::dimension; ++c)
            patch_.column(velocity, c)[shares[k].place] =
                static_cast<Real>(meeting_[k][c] + separation_[k].velocity[c]);
    if (velocity == NodeField::velocity) pairs_->report(meeting_, dt_);
}

template <class S>
void Engine<S>::rejoin() {
    const auto& shares = pairs_->nodes().shares();
    for (std::size_t k = 0; k < separation_.size(); ++k)
        for (int c = 0; c < S::dimension; ++c)
            patch_.column(NodeField::velocity, c)[shares[k].place] = static_cast<Real>(meeting_[k][c]);
}

/// Impulses become forces of the step: walls, light nodes and transfers treat them as any other. Walls take
/// what contact gives to the components that they prescribe.
template <class S>
void Engine<S>::add_contact_forces(Real dt) {
    if (!pairs_->meet()) return;
    rejoin();
    const auto& shares = pairs_->nodes().shares();
    read_meeting(NodeField::velocity);
    start_ = meeting_;
    for (std::size_t k = 0; k < shares.size(); ++k)
        for (int c = 0; c < S::dimension; ++c) {
            const Real a = patch_.column(NodeField::acceleration, c)[shares[k].place];
            meeting_[k][c] += static_cast<double>(a * dt);
        }
    const bool separated = !separation_.empty();
    if (separated)
        for (std::size_t k = 0; k < shares.size(); ++k) meeting_[k] += separation_[k].velocity;
    pairs_->resolve(meeting_, walls_.prescribed_components(), dt_, change_);
    pairs_->report(start_, dt_);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        if (separated) {
            change_[k].velocity += separation_[k].velocity;
            change_[k].impulse += separation_[k].impulse;
        }
        for (int c = 0; c < S::dimension; ++c) {
            patch_.column(NodeField::acceleration, c)[shares[k].place] +=
                static_cast<Real>(change_[k].velocity[c] / dt_);
            patch_.column(NodeField::force, c)[shares[k].place] +=
                static_cast<Real>(change_[k].impulse[c] / dt_);
        }
    }
    separation_.clear();
}

template <class S>
void Engine<S>::act_with_tools() {
    pushes_.clear();
    for (const PlacedContact<S>& placed : components_.contacts) {
        Tool<S>* const tool = placed.contact->tool();
        if (!tool) continue;
        ToolContext<S> context{time_,
                               dt_,
                               bodies_,
                               nodes_of_,
                               *components_.shape,
                               walls_.prescribed_components(),
                               inside_,
                               pushes_,
                               levels_.count() > 1 ? &level_at_ : nullptr,
                               levels_.count() > 1 ? &parents_of_ : nullptr};
        guarded(*tool, "act", [&] { tool->act(context); });
    }
    for (const auto& push : pushes_)
        for (int c = 0; c < S::dimension; ++c)
            tally_.impulse[static_cast<std::size_t>(c)] += static_cast<double>(push.impulse[c]);
}

/// Of impulses together with all other forces, over the way that nodes go in the step.
template <class S>
void Engine<S>::add_contact_work(Real dt) {
    const auto way = [&](int node, int c) {
        return static_cast<double>(patch_.column(NodeField::velocity, c)[node] -
                                   patch_.column(NodeField::acceleration, c)[node] * dt / 2);
    };
    if (pairs_ && pairs_->meet()) {
        const auto& shares = pairs_->nodes().shares();
        for (std::size_t k = 0; k < shares.size(); ++k)
            for (int c = 0; c < S::dimension; ++c)
                tally_.contact -= change_[k].impulse[c] * way(shares[k].place, c);
    }
    for (const auto& push : pushes_)
        for (int c = 0; c < S::dimension; ++c)
            tally_.external_work += static_cast<double>(push.impulse[c]) * way(push.node, c);
}

template <class S>
ContactReport Engine<S>::contact_report(std::size_t contact) const {
    Contact<S>& own = *components_.contacts[contact].contact;
    if (const Tool<S>* tool = own.tool()) return guarded(*tool, "report", [&] { return tool->report(); });
    return pairs_ ? pairs_->report_of(contact) : ContactReport{};
}

template <class S>
std::map<std::string, double> Engine<S>::contact_state(std::size_t contact) const {
    Contact<S>& own = *components_.contacts[contact].contact;
    if (const Tool<S>* tool = own.tool()) return guarded(*tool, "state", [&] { return tool->state(); });
    std::map<std::string, double> state;
    const ContactReport report = contact_report(contact);
    visit_report(report, [&](const std::string& name, double value) { state[name] = value; });
    return state;
}

template <class S>
void Engine<S>::restore_contact(std::size_t contact, const std::map<std::string, double>& state) {
    Contact<S>& own = *components_.contacts[contact].contact;
    if (Tool<S>* tool = own.tool()) return guarded(*tool, "restore", [&] { tool->restore(state); });
    if (pairs_)
        visit_report(pairs_->reports()[contact],
                     [&](const std::string& name, double& value) { value = state.at(name); });
}

#define MATPOINT_INSTANTIATE(S)                                                         \
    template void Engine<S>::make_layers();                                             \
    template void Engine<S>::make_blocks();                                             \
    template void Engine<S>::meet();                                                    \
    template void Engine<S>::separate(NodeField);                                       \
    template void Engine<S>::add_contact_forces(S::Real);                               \
    template void Engine<S>::add_contact_work(S::Real);                                 \
    template void Engine<S>::act_with_tools();                                          \
    template ContactReport Engine<S>::contact_report(std::size_t) const;                \
    template std::map<std::string, double> Engine<S>::contact_state(std::size_t) const; \
    template void Engine<S>::restore_contact(std::size_t, const std::map<std::string, double>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
