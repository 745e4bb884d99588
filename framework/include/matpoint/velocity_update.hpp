#pragma once

#include <matpoint/particles.hpp>

#include <algorithm>

namespace matpoint {

/// v_p += sum S a dt [Wallstedt & Guilkey 2008, eq. 18], for transfers that declare
/// Field::velocity_remainder; dt in s.
template <class S>
void add_acceleration(const ParticleBatch<S>& batch, typename S::Real dt) {
    using Real = typename S::Real;
    const Index count = batch.end() - batch.begin();
    for (int c = 0; c < S::dimension; ++c) {
        Real* v = batch.particles().column(Field::velocity, c) + batch.begin();
        const Real* a = batch.gathered().acceleration[static_cast<std::size_t>(c)].data();
        if constexpr (S::single) {
            // What rounding leaves out is added the next time: a dt may be far smaller than v.
            Real* rest = batch.particles().column(Field::velocity_remainder, c) + batch.begin();
            for (Index i = 0; i < count; ++i) {
                const Real before = v[i], increment = rest[i] + a[i] * dt;
                v[i] = before + increment;
                rest[i] = increment - (v[i] - before);
            }
        } else {
            for (Index i = 0; i < count; ++i) v[i] += a[i] * dt;
        }
    }
}

/// v_p = (1 - share) v_p + share sum S v.
template <class S>
void mix_velocity(const ParticleBatch<S>& batch, typename S::Real share) {
    using Real = typename S::Real;
    if (share == Real(0)) return;
    const Index count = batch.end() - batch.begin();
    for (int c = 0; c < S::dimension; ++c) {
        Real* v = batch.particles().column(Field::velocity, c) + batch.begin();
        const Real* grid = batch.gathered().velocity[static_cast<std::size_t>(c)].data();
        for (Index i = 0; i < count; ++i) v[i] = (Real(1) - share) * v[i] + share * grid[i];
    }
}

/// C_p = B_p D_p^-1 [Jiang et al. 2015].
template <class S>
void take_affine_velocity(const ParticleBatch<S>& batch) {
    const Index count = batch.end() - batch.begin();
    const auto& affine = batch.gathered().affine;
    for (std::size_t c = 0; c < affine.size(); ++c)
        std::copy_n(affine[c].data(), count,
                    batch.particles().column(Field::affine_velocity, static_cast<int>(c)) + batch.begin());
}

}  // namespace matpoint
