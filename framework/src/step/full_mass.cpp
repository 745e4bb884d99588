// Velocities of the full mass matrix, term by term of the series for its inverse.
#include <matpoint/parallel.hpp>

#include "step/phase_timer.hpp"

#include <algorithm>

namespace matpoint {

/// Keeps what particles read of a nodal velocity.
template <class S>
class Engine<S>::GridVelocity final : public GatherSink<S> {
  public:
    explicit GridVelocity(Particles<S>& particles) : particles_(particles) {}

    void receive(Index begin, int count, const Gathered<S>& gathered) override {
        for (int c = 0; c < S::dimension; ++c)
            std::copy_n(gathered.velocity[static_cast<std::size_t>(c)].data(), count,
                        particles_.column(Field::grid_velocity, c) + begin);
    }

  private:
    Particles<S>& particles_;
};

/// S+ S v into NodeField::resampled_velocity: what comes back of a velocity that particles read.
template <class S>
void Engine<S>::resample(NodeField velocity, const PathMean& mean) {
    {
        const Timer timer(*this, StepPhase::gather);
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const auto& ranges = ordering_.ranges(b);
            parallel_for(static_cast<Index>(ranges.size()), bodies_[b].size(), [&](Index r) {
                const BlockRange& range = ranges[static_cast<std::size_t>(r)];
                GridVelocity sink(bodies_[b]);
                guarded(*components_.shape, "gather", [&] {
                    components_.shape->gather(nodes(b, range.level), bodies_[b], range.begin, range.end,
                                              {.velocity = velocity}, sink);
                });
            });
        }
    }
    patch_.clear(NodeField::resampled_momentum);
    scatter({.momentum = NodeField::resampled_momentum});
    ties_.fold_momentum(patch_, NodeField::resampled_momentum, mean);
    for (int c = 0; c < S::dimension; ++c)
        std::copy_n(patch_.column(NodeField::resampled_momentum, c), patch_.node_count(),
                    patch_.column(NodeField::resampled_velocity, c));
    finish_velocity(NodeField::resampled_velocity, mean);
    light_nodes_.follow_velocity(patch_, NodeField::resampled_velocity, Real(1),
                                 NodeField::resampled_momentum);
    ties_.fill_velocity(patch_, NodeField::resampled_velocity, mean);
}

/// With S+ S = m^-1 M, M the full mass matrix and m the lumped one,
///
///     M^-1 p = sum_l (1 - S+ S)^l m^-1 p    [Nairn & Hammerquist 2021]
///
/// whose first k terms are k - 1 rounds of v <- v + (m^-1 p - S+ S v), from v = m^-1 p. Walls and light nodes
/// act on each, and keep them linear.
template <class S>
void Engine<S>::add_terms(NodeField velocity, const PathMean& mean) {
    for (int c = 0; c < S::dimension; ++c)
        std::copy_n(patch_.column(velocity, c), patch_.node_count(),
                    patch_.column(NodeField::lumped_velocity, c));
    for (int term = 1; term < components_.transfer->order(); ++term) {
        resample(velocity, mean);
        for_nodes([&](Index, Index begin, Index end) {
            for (int c = 0; c < S::dimension; ++c) {
                Real* v = patch_.column(velocity, c);
                const Real* lumped = patch_.column(NodeField::lumped_velocity, c);
                const Real* resampled = patch_.column(NodeField::resampled_velocity, c);
                for (Index i = begin; i < end; ++i) v[i] += lumped[i] - resampled[i];
            }
        });
    }
}

#define MATPOINT_INSTANTIATE(S)                                    \
    template void Engine<S>::resample(NodeField, const PathMean&); \
    template void Engine<S>::add_terms(NodeField, const PathMean&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
