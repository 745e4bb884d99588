// How far a scene is from rest, and what leads it there.
#include <matpoint/parallel.hpp>

#include "step/phase_timer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace matpoint {

template <class S>
void Engine<S>::measure_balance(Real factor) {
    struct Sums {
        double unbalanced = 0, internal = 0, external = 0;  // N
    };
    std::vector<Sums> sums(static_cast<std::size_t>(node_tasks()));
    const bool loaded = !components_.loads.empty();
    const Real* mass = patch_.column(NodeField::mass);
    for_nodes([&](Index task, Index begin, Index end) {
        Sums own;
        for (int c = 0; c < S::dimension; ++c) {
            const Real* f = patch_.column(NodeField::force, c);
            const Real* a = patch_.column(NodeField::acceleration, c);
            const Real* external = loaded ? patch_.column(NodeField::external_force, c) : nullptr;
            for (Index i = begin; i < end; ++i) {
                if (!inside_[static_cast<std::size_t>(i)]) continue;
                const Real load = external ? external[i] * factor : Real(0);
                own.external += std::abs(static_cast<double>(load));
                own.internal += std::abs(static_cast<double>(f[i] - load));
                // Not f itself: light nodes have handed on what they don't carry.
                if (moves_freely(i, c)) own.unbalanced += std::abs(static_cast<double>(mass[i] * a[i]));
            }
        }
        sums[static_cast<std::size_t>(task)] = own;
    });
    Sums all;
    for (const Sums& own : sums) {
        all.unbalanced += own.unbalanced;
        all.internal += own.internal;
        all.external += own.external;
    }
    tally_.unbalanced_force = all.unbalanced;
    tally_.carried_force = std::max(all.internal, all.external);
}

template <class S>
void Engine<S>::damp(Real dt) {
    constexpr Index chunk = 64;
    using Force = std::array<double, 3>;
    std::vector<Force> sums(static_cast<std::size_t>(node_tasks()), Force{});
    damping_force_.resize(static_cast<std::size_t>(S::dimension * patch_.node_count()));
    const Real* mass = patch_.column(NodeField::mass);
    for_nodes([&](Index task, Index first, Index last) {
        std::array<Real, chunk> slowed;
        Force own{};
        for (int c = 0; c < S::dimension; ++c) {
            const Real* v = patch_.column(NodeField::velocity, c);
            Real* a = patch_.column(NodeField::acceleration, c);
            Real* damping = damping_force_.data() + c * patch_.node_count();
            for (Index begin = first; begin < last; begin += chunk) {
                const auto count = static_cast<std::size_t>(std::min(chunk, last - begin));
                guarded(*components_.damping, "resist", [&] {
                    components_.damping->resist({v + begin, count}, {a + begin, count}, dt,
                                                std::span(slowed).first(count));
                });
                for (std::size_t k = 0; k < count; ++k) {
                    const Index i = begin + static_cast<Index>(k);
                    const Real resistance = moves_freely(i, c) ? slowed[k] : Real(0);
                    damping[i] = mass[i] * resistance;
                    a[i] += resistance;
                    own[static_cast<std::size_t>(c)] += static_cast<double>(damping[i]);
                }
            }
        }
        sums[static_cast<std::size_t>(task)] = own;
    });
    for (const Force& own : sums)
        for (std::size_t c = 0; c < S::dimension; ++c) tally_.impulse[c] += own[c] * dt_;
}

template <class S>
void Engine<S>::add_damping_work(Real dt) {
    tally_.damped -= node_work(dt, [&](int c) { return damping_force_.data() + c * patch_.node_count(); });
}

template <class S>
void Engine<S>::stop() {
    for (Particles<S>& particles : bodies_)
        for (const Field field : {Field::velocity, Field::velocity_remainder, Field::velocity_gradient,
                                  Field::affine_velocity, Field::grid_velocity_gradient}) {
            if (!particles.has(field)) continue;
            for (int c = 0; c < particles.components(particles.slot(field)); ++c)
                std::fill_n(particles.column(field, c), particles.size(), Real(0));
        }
    tally_.damped += tally_.kinetic;
    for (std::size_t c = 0; c < 3; ++c) tally_.impulse[c] -= tally_.momentum[c];
    tally_.kinetic = tally_.noise_energy = tally_.momentum_scale = tally_.largest_speed = 0;
    tally_.momentum = {};
}

#define MATPOINT_INSTANTIATE(S)                         \
    template void Engine<S>::measure_balance(S::Real);  \
    template void Engine<S>::damp(S::Real);             \
    template void Engine<S>::add_damping_work(S::Real); \
    template void Engine<S>::stop();
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
