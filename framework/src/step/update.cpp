// The nodes-to-particles pass: a batch is gathered, moved, strained and stressed while it is in cache.
#include <matpoint/parallel.hpp>
#include <matpoint/particle_pack.hpp>

#include "step/mixing.hpp"
#include "step/phase_timer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace matpoint {

template <class S>
class Engine<S>::BatchUpdate final : public GatherSink<S> {
  public:
    using Number = Pack<Real>;
    using Wide = Pack<double, Number::lanes>;  ///< what sums over particles are made of

    BatchUpdate(const Patch<S>& patch, Particles<S>& particles, std::size_t body, const Material<S>& material,
                int first_state, const Transfer<S>& transfer, typename Phases<S>::Update what, Real dt,
                const ArtificialViscosity* viscosity, double last_compression, Partial& sums)
        : room_(domain(patch)),
          particles_(particles),
          body_(body),
          material_(material),
          first_state_(first_state),
          transfer_(transfer),
          what_(what),
          dt_(dt),
          viscosity_(viscosity),
          last_compression_(last_compression),
          sums_(sums) {
        sums_.body = body;
    }

    void receive(Index begin, int count, const Gathered<S>& gathered) override {
        const ParticleBatch<S> batch(particles_, begin, begin + count, gathered, first_state_);
        if (what_.lag) return remember_lag(batch);
        if (what_.velocity) {
            guarded(transfer_, "update", [&] { transfer_.update(batch, dt_); });
            add_motion(batch);
        }
        if (what_.position) move(batch);
        if (!what_.stress) return;
        if (!particles_.has(Field::grid_velocity_gradient)) return strain_with_viscosity(batch);
        take_lag(batch);
        strain_with_viscosity(ParticleBatch<S>(particles_, begin, begin + count, lagged_, first_state_));
    }

    MATPOINT_FLATTEN void add_motion(const ParticleBatch<S>& batch) {
        LaneSums kinetic, noise, momentum_scale;
        std::array<LaneSums, S::dimension> momentum;
        Number fastest(0);
        visit_packs(batch, [&](const auto& p) {
            const Wide mass = wide(p.mass());
            Wide energy(0);
            Number square(0), unseen_square(0);
            for (int a = 0; a < S::dimension; ++a) {
                const Number v = p.load(Field::velocity, a);
                const Number unseen = v - p.load(batch.gathered().velocity[static_cast<std::size_t>(a)]);
                square += v * v;
                unseen_square += unseen * unseen;
                const Wide own = mass * wide(v);
                energy += own * wide(v);
                momentum[static_cast<std::size_t>(a)].add(p, own);
            }
            kinetic.add(p, Wide(0.5) * energy);
            noise.add(p, Wide(0.5) * mass * wide(unseen_square));
            momentum_scale.add(p, mass * wide(sqrt(square)));
            fastest = max(square, fastest);
        });
        sums_.kinetic += kinetic.total();
        sums_.noise_energy += noise.total();
        sums_.momentum_scale += momentum_scale.total();
        for (std::size_t a = 0; a < S::dimension; ++a) sums_.momentum[a] += momentum[a].total();
        sums_.largest_speed = std::max(sums_.largest_speed, std::sqrt(static_cast<double>(largest(fastest))));
        if (!std::isfinite(kinetic.total())) report_not_finite(batch, Field::velocity);
    }

    /// Where the particles are that were moved.
    const Bounds<S>& bounds() const { return bounds_; }

    void add_wave_speed(const ParticleBatch<S>& batch, Real wave_speed) {
        const auto speed = static_cast<double>(wave_speed);
        if (!(speed >= 0 && std::isfinite(speed))) report_wave_speed(batch, speed);
        sums_.largest_wave_speed = std::max(sums_.largest_wave_speed, speed);
    }

  private:
    MATPOINT_FLATTEN void move(const ParticleBatch<S>& batch) {
        for (int a = 0; a < S::dimension; ++a) {
            const Number low(room_.low[a]), high(room_.high[a]);
            Number least(bounds_.low[a]), greatest(bounds_.high[a]);
            auto inside = low <= high;
            const auto& v = batch.gathered().velocity[static_cast<std::size_t>(a)];
            visit_packs(batch, [&](const auto& p) {
                Number x = p.template add<Field::position>(a, p.load(v) * Number(dt_));
                x = head(x, p.count(), Number(x[0]));
                least = min(x, least);
                greatest = max(x, greatest);
                inside = inside && x >= low && x <= high;  // what is not a number is not
            });
            sums_.off_grid |= any(!inside);
            bounds_.low[a] = -largest(-least);
            bounds_.high[a] = largest(greatest);
        }
    }

    /// From here on the field holds what the gradient that was gathered has beyond the one that it held.
    void remember_lag(const ParticleBatch<S>& batch) {
        for (std::size_t c = 0; c < S::deformation_size; ++c) {
            Real* const lag =
                particles_.column(Field::grid_velocity_gradient, static_cast<int>(c)) + batch.begin();
            const auto& gathered = batch.gathered().velocity_gradient[c];
            for (Index i = 0; i < batch.end() - batch.begin(); ++i)
                lag[i] = gathered[static_cast<std::size_t>(i)] - lag[i];
        }
    }
    /// L with the lag, in whose place the field gets what was gathered.
    void take_lag(const ParticleBatch<S>& batch) {
        lagged_ = batch.gathered();
        for (std::size_t c = 0; c < S::deformation_size; ++c) {
            Real* const lag =
                particles_.column(Field::grid_velocity_gradient, static_cast<int>(c)) + batch.begin();
            for (Index i = 0; i < batch.end() - batch.begin(); ++i) {
                const Real gathered = lagged_.velocity_gradient[c][static_cast<std::size_t>(i)];
                lagged_.velocity_gradient[c][static_cast<std::size_t>(i)] += lag[i];
                lag[i] = gathered;
            }
        }
    }

    void strain_with_viscosity(const ParticleBatch<S>& batch) {
        if (!viscosity_) {
            strain(batch);
            return;
        }
        double power = viscous_power(batch, Real(0));
        compress(batch, static_cast<double>(strain(batch)));
        power += viscous_power(batch, dt_);
        sums_.strain_work += power * static_cast<double>(dt_) / 2;
    }
    /// The new artificial pressure; it is no part of the material's state.
    void compress(const ParticleBatch<S>& batch, double wave_speed) {
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Tensor<S> gradient = batch.velocity_gradient(p);
            const ArtificialViscosity::State state{static_cast<double>(batch.density(p)), wave_speed,
                                                   std::max(0.0, -static_cast<double>(trace(gradient))),
                                                   last_compression_};
            const double pressure = viscosity_->pressure(state);
            sums_.largest_compression = std::max(sums_.largest_compression, state.compression);
            sums_.largest_wave_speed = std::max(sums_.largest_wave_speed, viscosity_->speed(state, pressure));
            ParticleBatch<S>::store_stress(
                particles_, p, batch.stress(p) - static_cast<Real>(pressure) * Tensor<S>::identity(),
                Field::total_stress);
        }
    }
    /// W, that of the artificial pressure, by the gradient at the end of a step of length dt.
    double viscous_power(const ParticleBatch<S>& batch, Real dt) const {
        double power = 0;
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Tensor<S> gradient = batch.velocity_gradient(p);
            const Tensor<S> beside =
                ParticleBatch<S>::load_stress(particles_, p, Field::total_stress) - batch.stress(p);
            power += static_cast<double>(batch.volume(p)) *
                     static_cast<double>(contract(beside, gradient - dt * (gradient * gradient)));
        }
        return power;
    }

    static Wide wide(Number a) { return a.template as<double>(); }
    /// Sums over the particles of a batch, in an order that does not depend on how many lanes there are.
    class LaneSums {
      public:
        template <class Point>
        MATPOINT_INLINE void add(const Point& p, Wide a) {
            double* const sums = sums_.data() + p.at() % batch_multiple;
            (Wide::load(sums) + p.mine(a)).store(sums);
        }
        double total() const { return std::accumulate(sums_.begin(), sums_.end(), 0.0); }

      private:
        std::array<double, batch_multiple> sums_{};
    };
    /// F = (I + L dt) F, V = det(I + L dt) V, then the stress [Wallstedt & Guilkey 2008, eq. 11-13]; in terms
    /// of H = F - I, and of what V grows by, which keep what is small beside 1. The stress's work is that of
    /// V sigma : L before and after, of second order in dt. At the end of the step the same velocities have
    /// the gradient L (I + L dt)^-1, for which L - dt L^2 is enough. Returns the wave speed, m/s.
    MATPOINT_FLATTEN Real strain(const ParticleBatch<S>& batch) {
        const bool deforms = particles_.has(Field::displacement_gradient);
        const bool keeps_gradient = particles_.has(Field::velocity_gradient);
        LaneSums power;  // W
        visit_packs(batch, [&](const auto& p) {
            const Tensor<S, Number> gradient = p.velocity_gradient();
            const Number volume = p.volume();
            power.add(p, wide(volume) * wide(contract(p.stress(), gradient)));
            Tensor<S, Number> increment = dt_ * gradient;
            Number growth = volume_change(increment);
            const auto sound = growth > Number(-1);
            if (__builtin_expect(any(!sound), 0)) {
                report_inverted(batch, p, Number(1) + growth);
                // One that turned inside out stays as it was.
                increment = select(sound, increment, Tensor<S, Number>());
                growth = select(sound, growth, Number(0));
            }
            p.template add<Field::volume>(0, volume * growth);
            if (deforms) {
                const Tensor<S, Number> h = p.displacement_gradient();
                p.set_displacement_gradient(h + (increment + increment * h));
            }
            if (keeps_gradient)
                for (int c = 0; c < S::dimension * S::dimension; ++c)
                    p.store(Field::velocity_gradient, c, gradient.plane.data()[c]);
        });
        const Real wave_speed = guarded(material_, "update", [&] { return material_.update(batch, dt_); });
        add_wave_speed(batch, wave_speed);
        visit_packs(batch, [&](const auto& p) {
            const Tensor<S, Number> gradient = p.velocity_gradient();
            power.add(p,
                      wide(p.volume()) * wide(contract(p.stress(), gradient - dt_ * (gradient * gradient))));
        });
        sums_.strain_work += power.total() * static_cast<double>(dt_) / 2;
        if (!std::isfinite(power.total())) report_not_finite(batch, Field::stress);
        return wave_speed;
    }

    template <class Point>
    void report_inverted(const ParticleBatch<S>& batch, const Point& p, const Number& ratio) {
        for (int i = 0; i < p.count(); ++i)
            if (!(ratio[i] > 0)) {
                const auto value = static_cast<double>(ratio[i]);
                return report(batch.begin() + p.at() + i,
                              std::isfinite(value) ? Fault::Kind::inverted : Fault::Kind::not_finite, value);
            }
    }

    /// Of a batch in which something is not finite: the first particle whose own field tells, or the first of
    /// all.
    void report_not_finite(const ParticleBatch<S>& batch, Field field) {
        report(first_not_finite(batch, field).value_or(batch.begin()), Fault::Kind::not_finite, 0);
    }

    /// Of what can't be a wave speed: the material's fault where the particles are sound.
    void report_wave_speed(const ParticleBatch<S>& batch, double speed) {
        if (const auto p = first_not_finite(batch, Field::stress))
            return report(*p, Fault::Kind::not_finite, 0);
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const ParticleBatch<S> one(particles_, p, p + 1, batch.gathered(), first_state_);
            const auto own = static_cast<double>(material_.wave_speed(one));
            if (!(own >= 0 && std::isfinite(own))) return report(p, Fault::Kind::wave_speed, own);
        }
        report(batch.begin(), Fault::Kind::wave_speed, speed);
    }

    std::optional<Index> first_not_finite(const ParticleBatch<S>& batch, Field field) const {
        const int components = particles_.components(particles_.slot(field));
        for (Index p = batch.begin(); p < batch.end(); ++p)
            for (int c = 0; c < components; ++c)
                if (!std::isfinite(particles_.column(field, c)[p])) return p;
        return {};
    }

    void report(Index p, Fault::Kind kind, double value) {
        if (!sums_.fault) sums_.fault = Fault{body_, p, kind, value};
    }

    Bounds<S> room_;  ///< that particles may be in
    Bounds<S> bounds_{S::Vector::Constant(std::numeric_limits<Real>::infinity()),
                      S::Vector::Constant(-std::numeric_limits<Real>::infinity())};
    Particles<S>& particles_;
    std::size_t body_;
    const Material<S>& material_;
    int first_state_;
    const Transfer<S>& transfer_;
    typename Phases<S>::Update what_;
    Real dt_;
    const ArtificialViscosity* viscosity_;  ///< null: none
    double last_compression_;               ///< Tally::largest_compression of the last step, 1/s
    Partial& sums_;
    Gathered<S> lagged_;  ///< of integrators that lag
};

template <class S>
void Engine<S>::update(typename Phases<S>::Update what, Real dt) {
    const Timer timer(*this, StepPhase::gather);
    const Transfer<S>& transfer = *components_.transfer;
    Gather request;
    if (what.position) request.velocity = what.position;
    if (what.velocity) {
        request.velocity = NodeField::velocity;
        request.acceleration = transfer.needs_acceleration();
        request.affine = transfer.needs_affine();
    }
    request.gradient = what.lag ? what.lag : what.stress;

    partials_.clear();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const auto& ranges = ordering_.ranges(b);
        const std::size_t first = partials_.size();
        partials_.resize(first + ranges.size());
        parallel_for(static_cast<Index>(ranges.size()), bodies_[b].size(), [&](Index r) {
            const BlockRange& range = ranges[static_cast<std::size_t>(r)];
            BatchUpdate sink(patch_, bodies_[b], b, *components_.materials[b], first_states_[b], transfer,
                             what, dt, viscosity(b), tally_.largest_compression,
                             partials_[first + static_cast<std::size_t>(r)]);
            guarded(*components_.shape, "gather", [&] {
                components_.shape->gather(nodes(b, range.level), bodies_[b], range.begin, range.end, request,
                                          sink);
            });
            if (!what.position) return;
            ordering_.bounds(b)[static_cast<std::size_t>(r)] = sink.bounds();
            // While they are in the cache; but a fault names a particle by its place.
            if (faults_.empty() && !partials_[first + static_cast<std::size_t>(r)].fault)
                guarded(*components_.shape, "base_nodes", [&] {
                    sort_if_mixed(levels_.patch(range.level), bodies_[b], range, *components_.shape);
                });
        });
    }
    collect(what);
    if (what.position && off_grid_) hold_at_walls();
}

template <class S>
void Engine<S>::hold_at_walls() {
    off_grid_ = false;
    for (const Stray& stray : ordering_.strays(patch_, bodies_))
        if (!walls_.hold(patch_, bodies_[stray.body], stray.particle, velocity_to_.time)) off_grid_ = true;
    for (std::size_t b = 0; b < bodies_.size(); ++b) ordering_.measure(bodies_[b], b);
}

template <class S>
void Engine<S>::measure() {
    static const Gathered<S> nothing{};
    partials_.assign(bodies_.size(), {});
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        BatchUpdate sums(patch_, bodies_[b], b, *components_.materials[b], first_states_[b],
                         *components_.transfer, {}, Real(0), nullptr, 0, partials_[b]);
        for (Index begin = 0; begin < bodies_[b].size(); begin += batch_size) {
            const ParticleBatch<S> batch(bodies_[b], begin, std::min(bodies_[b].size(), begin + batch_size),
                                         nothing, first_states_[b]);
            sums.add_motion(batch);
            const Material<S>& material = *components_.materials[b];
            sums.add_wave_speed(batch,
                                guarded(material, "wave_speed", [&] { return material.wave_speed(batch); }));
        }
    }
    collect({.velocity = true, .stress = NodeField::velocity});
    tally_.noise_energy = 0;  // nothing was gathered
    if (components_.loads.empty()) return;
    Tally found = tally_;
    project({.velocity = true});
    found.load_acceleration = tally_.load_acceleration;
    tally_ = std::move(found);  // no step was taken
}

/// Dust has no waves, and its stress does no work.
template <class S>
void Engine<S>::find_stiff_without_waves() {
    tally_.stiff_without_waves.reset();
    for (auto part = partials_.begin(); part != partials_.end() && !tally_.stiff_without_waves;) {
        const std::size_t body = part->body;
        bool works = false, waves = false;
        for (; part != partials_.end() && part->body == body; ++part) {
            works = works || part->strain_work != 0;
            waves = waves || part->largest_wave_speed > 0;
        }
        if (works && !waves) tally_.stiff_without_waves = body;
    }
}

template <class S>
void Engine<S>::collect(typename Phases<S>::Update what) {
    const bool velocity = what.velocity, stress = what.stress.has_value();
    if (what.position) off_grid_ = false;
    if (velocity) {
        tally_.kinetic = tally_.noise_energy = tally_.momentum_scale = tally_.largest_speed = 0;
        tally_.momentum = {};
    }
    if (stress) {
        tally_.largest_wave_speed = tally_.largest_compression = 0;
        find_stiff_without_waves();
    }
    for (const Partial& part : partials_) {
        off_grid_ |= part.off_grid;
        if (velocity) {
            tally_.kinetic += part.kinetic;
            tally_.noise_energy += part.noise_energy;
            tally_.momentum_scale += part.momentum_scale;
            for (std::size_t c = 0; c < 3; ++c) tally_.momentum[c] += part.momentum[c];
            tally_.largest_speed = std::max(tally_.largest_speed, part.largest_speed);
        }
        if (stress) {
            tally_.strain_work += part.strain_work;
            tally_.largest_wave_speed = std::max(tally_.largest_wave_speed, part.largest_wave_speed);
            tally_.largest_compression = std::max(tally_.largest_compression, part.largest_compression);
        }
        if (part.fault) faults_.push_back(*part.fault);
    }
}

#define MATPOINT_INSTANTIATE(S)                                                    \
    template void Engine<S>::update(typename Phases<S>::Update, typename S::Real); \
    template void Engine<S>::measure();
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
