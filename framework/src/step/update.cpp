// The nodes-to-particles pass: a batch is gathered, moved, strained and stressed while it is in cache.
#include <matpoint/parallel.hpp>

#include "step/engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace matpoint {

template <class S>
class Engine<S>::BatchUpdate final : public GatherSink<S> {
  public:
    BatchUpdate(Particles<S>& particles, std::size_t body, const Material<S>& material, int first_state,
                const Transfer<S>& transfer, typename Phases<S>::Update what, Real dt, Partial& sums)
        : particles_(particles),
          body_(body),
          material_(material),
          first_state_(first_state),
          transfer_(transfer),
          what_(what),
          dt_(dt),
          sums_(sums) {}

    void receive(Index begin, int count, const Gathered<S>& gathered) override {
        const ParticleBatch<S> batch(particles_, begin, begin + count, gathered, first_state_);
        if (what_.velocity) {
            transfer_.update(batch, dt_);
            add_motion(batch);
        }
        if (what_.position) move(batch);
        if (what_.stress) strain(batch);
    }

    void add_motion(const ParticleBatch<S>& batch) {
        const Real* mass = particles_.column(Field::mass);
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const typename S::Vector v = particles_.velocity(p);
            const auto m = static_cast<double>(mass[p]);
            const auto speed_squared = static_cast<double>(v.squaredNorm());
            const double speed = std::sqrt(speed_squared);
            sums_.kinetic += m * speed_squared / 2;
            sums_.momentum_scale += m * speed;
            for (int a = 0; a < S::dimension; ++a)
                sums_.momentum[static_cast<std::size_t>(a)] += m * static_cast<double>(v[a]);
            sums_.largest_speed = std::max(sums_.largest_speed, speed);
            if (!std::isfinite(speed)) report(p, false, 0);
        }
    }

    void add_wave_speed(const ParticleBatch<S>& batch) {
        const auto speed = static_cast<double>(material_.wave_speed(batch));
        if (!std::isfinite(speed)) report(batch.begin(), false, 0);
        sums_.largest_wave_speed = std::max(sums_.largest_wave_speed, speed);
    }

  private:
    void move(const ParticleBatch<S>& batch) {
        for (int a = 0; a < S::dimension; ++a) {
            Real* x = particles_.column(Field::position, a) + batch.begin();
            const Real* v = batch.gathered().velocity[static_cast<std::size_t>(a)].data();
            for (Index k = 0; k < batch.end() - batch.begin(); ++k) x[k] += v[k] * dt_;
        }
    }

    /// Column of the stress's component (a, b).
    static constexpr int stress_component(int a, int b) {
        if (a == b) return a;
        if constexpr (S::dimension == 2) return 3;
        return a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
    }

    /// Sum of V sigma : L (W) at the end of the step, where the same velocities have the gradient
    /// L (I + L dt)^-1; L - dt L^2 leaves the work that is summed from it of second order in dt. Column by
    /// column, as all particles of all scenes come by here.
    double end_power(const ParticleBatch<S>& batch) const {
        constexpr int d = S::dimension;
        const auto count = static_cast<std::size_t>(batch.end() - batch.begin());
        const auto& gradients = batch.gathered().velocity_gradient;
        const auto gradient = [&](int a, int b) {
            return gradients[static_cast<std::size_t>(a + d * b)].data();
        };
        std::array<Real, batch_size> density{};  // W/m^3
        for (int a = 0; a < d; ++a)
            for (int b = 0; b < d; ++b) {
                const Real* stress = particles_.column(Field::stress, stress_component(a, b)) + batch.begin();
                for (std::size_t k = 0; k < count; ++k) {
                    Real end = gradient(a, b)[k];
                    for (int c = 0; c < d; ++c) end -= dt_ * gradient(a, c)[k] * gradient(c, b)[k];
                    density[k] += stress[k] * end;
                }
            }
        if constexpr (S::axisymmetric) {
            const Real* stress = particles_.column(Field::stress, 2) + batch.begin();
            const Real* hoop = gradients[d * d].data();
            for (std::size_t k = 0; k < count; ++k)
                density[k] += stress[k] * (hoop[k] - dt_ * hoop[k] * hoop[k]);
        }
        const Real* volume = particles_.column(Field::volume) + batch.begin();
        double power = 0;
        for (std::size_t k = 0; k < count; ++k) power += static_cast<double>(volume[k] * density[k]);
        return power;
    }

    /// F = (I + L dt) F, V = det(I + L dt) V, then the stress [Wallstedt & Guilkey 2008, eq. 11-13].
    void strain(const ParticleBatch<S>& batch) {
        Real* volume = particles_.column(Field::volume);
        const bool deforms = particles_.has(Field::deformation_gradient);
        const bool keeps_gradient = particles_.has(Field::velocity_gradient);
        double power = 0;  // V sigma : L before and after: the work is second order in dt
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Tensor<S> gradient = batch.velocity_gradient(p);
            power += static_cast<double>(volume[p] * contract(batch.stress(p), gradient));
            const Tensor<S> increment = Tensor<S>::identity() + dt_ * gradient;
            const Real ratio = determinant(increment);
            if (!(ratio > 0)) {
                report(p, std::isfinite(ratio), static_cast<double>(ratio));
                continue;
            }
            volume[p] *= ratio;
            if (deforms)
                ParticleBatch<S>::store_deformation(particles_, p, increment * batch.deformation_gradient(p));
            if (keeps_gradient)
                for (int c = 0; c < S::dimension * S::dimension; ++c)
                    particles_.column(Field::velocity_gradient, c)[p] = gradient.plane.data()[c];
        }
        material_.update_stress(batch, dt_);
        power += end_power(batch);
        sums_.strain_work += power * static_cast<double>(dt_) / 2;
        if (!std::isfinite(power)) report(batch.begin(), false, 0);
        add_wave_speed(batch);
    }

    void report(Index p, bool finite, double ratio) {
        if (!sums_.fault) sums_.fault = Fault{body_, p, finite, ratio};
    }

    Particles<S>& particles_;
    std::size_t body_;
    const Material<S>& material_;
    int first_state_;
    const Transfer<S>& transfer_;
    typename Phases<S>::Update what_;
    Real dt_;
    Partial& sums_;
};

template <class S>
void Engine<S>::update(typename Phases<S>::Update what, Real dt) {
    const Transfer<S>& transfer = *components_.transfer;
    Gather request;
    if (what.position) request.velocity = what.position;
    if (what.velocity) {
        request.velocity = NodeField::velocity;
        request.acceleration = transfer.needs_acceleration();
        request.affine = transfer.needs_affine();
    }
    request.gradient = what.stress;

    partials_.clear();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const auto& ranges = ordering_.ranges(b);
        const std::size_t first = partials_.size();
        partials_.resize(first + ranges.size());
        parallel_for(static_cast<Index>(ranges.size()), bodies_[b].size(), [&](Index r) {
            const BlockRange& range = ranges[static_cast<std::size_t>(r)];
            BatchUpdate sink(bodies_[b], b, *components_.materials[b], first_states_[b], transfer, what, dt,
                             partials_[first + static_cast<std::size_t>(r)]);
            components_.shape->gather(patch_, bodies_[b], range.begin, range.end, request, sink);
        });
    }
    collect(what.velocity, what.stress.has_value());
}

template <class S>
void Engine<S>::measure() {
    static const Gathered<S> nothing{};
    partials_.assign(bodies_.size(), {});
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        BatchUpdate sums(bodies_[b], b, *components_.materials[b], first_states_[b], *components_.transfer,
                         {}, Real(0), partials_[b]);
        for (Index begin = 0; begin < bodies_[b].size(); begin += batch_size) {
            const ParticleBatch<S> batch(bodies_[b], begin, std::min(bodies_[b].size(), begin + batch_size),
                                         nothing, first_states_[b]);
            sums.add_motion(batch);
            sums.add_wave_speed(batch);
        }
    }
    collect(true, true);
}

template <class S>
void Engine<S>::collect(bool velocity, bool stress) {
    if (velocity) {
        tally_.kinetic = tally_.momentum_scale = tally_.largest_speed = 0;
        tally_.momentum = {};
    }
    if (stress) tally_.largest_wave_speed = 0;
    for (const Partial& part : partials_) {
        if (velocity) {
            tally_.kinetic += part.kinetic;
            tally_.momentum_scale += part.momentum_scale;
            for (std::size_t c = 0; c < 3; ++c) tally_.momentum[c] += part.momentum[c];
            tally_.largest_speed = std::max(tally_.largest_speed, part.largest_speed);
        }
        if (stress) {
            tally_.strain_work += part.strain_work;
            tally_.largest_wave_speed = std::max(tally_.largest_wave_speed, part.largest_wave_speed);
        }
        if (part.fault) faults_.push_back(*part.fault);
    }
}

#define MATPOINT_INSTANTIATE(S)                                                    \
    template void Engine<S>::update(typename Phases<S>::Update, typename S::Real); \
    template void Engine<S>::measure();
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
