#include "run/plane_stress.hpp"

#include <matpoint/material.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace matpoint {

namespace {

/// The particles of a batch as the material within sees them.
template <class A>
struct Copy {
    using Real = typename A::Real;

    explicit Copy(const Material<A>& material) : particles("plane_stress"), gathered{} {
        deforms = material.uses_deformation_gradient();
        if (deforms) particles.require(Field::displacement_gradient);
        first_state = particles.field_count();
        for (const StateVariable& variable : material.state()) {
            particles.require(variable.name, 1, variable.initial);
            ++states;
        }
        particles.resize(batch_size);
    }
    ParticleBatch<A> batch(int count) { return {particles, 0, count, gathered, first_state}; }

    Particles<A> particles;
    Gathered<A> gathered;
    bool deforms;
    int first_state = 0, states = 0;
};

/// A material whose stress along the normal vanishes.
template <class S>
class PlaneStress final : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;
    using A = Space<2, Mode::axisymmetric, Real>;

    PlaneStress(const Parameters& parameters, std::shared_ptr<Material<A>> material)
        : Material<S>(parameters), material_(std::move(material)) {
        const Stiffness rest = stiffness_at_rest();
        const double share = rest.coupled / rest.normal;
        if (!(rest.normal > 0 && share * share < 1 - 1e-6))
            throw std::invalid_argument(
                "can't be in plane stress: it resists no change of shape, and so carries nothing where its "
                "pressure vanishes; choose \"mode\": \"plane_strain\"");
        stiffness_ = static_cast<Real>(rest.normal);
        share_ = static_cast<Real>(share);
    }

    std::vector<StateVariable> state() const override {
        std::vector<StateVariable> all = material_->state();
        all.push_back({"thickness_strain", 0, ""});
        return all;
    }
    bool uses_deformation_gradient() const override { return material_->uses_deformation_gradient(); }
    void update_stress(const Batch& batch, Real dt) const override { update(batch, dt); }

    Real wave_speed(const Batch& batch) const override {
        Loan copy(*this);
        Real fastest(0);
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Real own =
                speed_at_rest({batch.particles(), p, p + 1, batch.gathered(), batch.first_state()}, *copy);
            if (std::isnan(own)) return own;
            fastest = std::max(own, fastest);
        }
        return fastest;
    }
    std::optional<double> stored_energy(const Batch& batch, Index p) const override {
        Loan copy(*this);
        load(batch, *copy);
        for (int i = 0; i < count(batch); ++i) set_normal_strain(*copy, i, normal_strain(batch, *copy, i));
        return material_->stored_energy(copy->batch(count(batch)), p - batch.begin());
    }

    /// By the secant method, which begins with a small difference. The first guess is right of what is
    /// elastic and hardly strained.
    Real update(const Batch& batch, Real dt) const override {
        Loan copy(*this);
        Trial trial;
        const auto attempt = [&](Real offset) {
            load(batch, *copy);
            for (int i = 0; i < count(batch); ++i)
                stretch(batch, *copy, i, trial.strain[place(i)] + offset, dt);
            return material_->update(copy->batch(count(batch)), dt);
        };
        for (int i = 0; i < count(batch); ++i) {
            const Tensor<S> gradient = batch.velocity_gradient(batch.begin() + i);
            trial.strain[place(i)] = -share_ * dt * (gradient.plane(0, 0) + gradient.plane(1, 1));
        }
        attempt(probe);
        remember(batch, *copy, trial, probe);
        Real speed = attempt(0);
        find_slopes(batch, *copy, trial);
        const Real part = free_part(batch, *copy, speed, trial);
        for (int round = 0; improve(batch, *copy, trial); ++round) {
            if (round == most_rounds)
                throw std::runtime_error(
                    "no change of thickness frees a particle of the stress along the normal");
            speed = attempt(0);
            find_slopes(batch, *copy, trial);
        }
        for (int i = 0; i < count(batch); ++i) store(batch, *copy, i, trial.strain[place(i)]);
        return part * speed;
    }

  private:
    static constexpr int most_rounds = 50;
    /// A strain in which squares are lost beside it, but not it beside 1.
    static inline const Real probe = std::sqrt(std::numeric_limits<Real>::epsilon()) / 10;
    static constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

    /// By particle of the batch.
    struct Trial {
        template <class T>
        using ByParticle = std::array<T, batch_size>;
        using Stress = std::array<Real, 4>;           ///< xx yy zz xy
        ByParticle<Real> strain{}, strain_before{};   ///< along the normal, of the step
        ByParticle<Stress> stress_before{}, slope{};  ///< slope: over that strain, Pa
    };
    /// Slopes of the stress over a strain along the normal, Pa.
    struct Stiffness {
        double normal, coupled;  ///< of the stress along the normal, and of that in the plane
    };

    /// A copy that nobody else uses, for the life of this.
    class Loan {
      public:
        explicit Loan(const PlaneStress& owner) : owner_(owner) {
            const std::scoped_lock lock(owner.mutex_);
            if (owner.idle_.empty()) {
                copy_ = std::make_unique<Copy<A>>(*owner.material_);
                return;
            }
            copy_ = std::move(owner.idle_.back());
            owner.idle_.pop_back();
        }
        ~Loan() {
            const std::scoped_lock lock(owner_.mutex_);
            owner_.idle_.push_back(std::move(copy_));
        }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;
        Copy<A>& operator*() const { return *copy_; }
        Copy<A>* operator->() const { return copy_.get(); }

      private:
        const PlaneStress& owner_;
        std::unique_ptr<Copy<A>> copy_;
    };

    static std::size_t place(int i) { return static_cast<std::size_t>(i); }
    static int count(const Batch& batch) { return static_cast<int>(batch.end() - batch.begin()); }
    static Real normal_strain(const Batch& batch, const Copy<A>& copy, int i) {
        return batch.state(copy.states, batch.begin() + i);
    }
    static void set_normal_strain(Copy<A>& copy, int i, Real strain) {
        if (copy.deforms) copy.particles.column(Field::displacement_gradient, 4)[i] = strain;
    }

    /// Of a batch in which nothing moves.
    Real speed_at_rest(const Batch& batch, Copy<A>& copy) const {
        Trial trial;
        const auto attempt = [&](Real strain) {
            load(batch, copy);
            for (int c = 0; c < 4; ++c) copy.gathered.velocity_gradient[place(c)].fill(0);
            for (int i = 0; i < count(batch); ++i) stretch(batch, copy, i, strain, Real(1));
            return material_->update(copy.batch(count(batch)), Real(1));
        };
        attempt(probe);
        remember(batch, copy, trial, probe);
        const Real speed = attempt(0);
        find_slopes(batch, copy, trial);
        return free_part(batch, copy, speed, trial) * speed;
    }

    /// The state before the step, with the F, V and L of the plane after it.
    static void load(const Batch& batch, Copy<A>& copy) {
        const Index first = batch.begin();
        const int n = count(batch);
        const auto take = [&](const Real* from, Real* to) { std::copy_n(from, n, to); };
        for (const Field field :
             {Field::position, Field::velocity, Field::mass, Field::volume, Field::stress}) {
            const int components = copy.particles.components(copy.particles.slot(field));
            for (int c = 0; c < components; ++c)
                take(batch.particles().column(field, c) + first, copy.particles.column(field, c));
        }
        for (int c = 0; c < 4; ++c) {
            if (copy.deforms)
                take(batch.particles().column(Field::displacement_gradient, c) + first,
                     copy.particles.column(Field::displacement_gradient, c));
            take(batch.gathered().velocity_gradient[place(c)].data(),
                 copy.gathered.velocity_gradient[place(c)].data());
        }
        for (int k = 0; k < copy.states; ++k)
            take(&batch.state(k, first), copy.particles.column(copy.first_state + k, 0));
    }

    static void stretch(const Batch& batch, Copy<A>& copy, int i, Real strain, Real dt) {
        const Real before = normal_strain(batch, copy, i);
        set_normal_strain(copy, i, before + strain * (1 + before));
        copy.gathered.velocity_gradient[4][place(i)] = strain / dt;
        copy.particles.column(Field::volume)[i] *= 1 + strain;
    }

    static typename Trial::Stress stress(const Copy<A>& copy, int i) {
        typename Trial::Stress stress;
        for (int c = 0; c < 4; ++c) stress[place(c)] = copy.particles.column(Field::stress, c)[i];
        return stress;
    }
    static void remember(const Batch& batch, const Copy<A>& copy, Trial& trial, Real offset) {
        for (int i = 0; i < count(batch); ++i) {
            trial.strain_before[place(i)] = trial.strain[place(i)] + offset;
            trial.stress_before[place(i)] = stress(copy, i);
        }
    }
    void find_slopes(const Batch& batch, const Copy<A>& copy, Trial& trial) const {
        for (int i = 0; i < count(batch); ++i) {
            const std::size_t p = place(i);
            const Real step = trial.strain[p] - trial.strain_before[p];
            if (std::abs(step) < probe / 2) continue;  // rounding would swamp it
            const typename Trial::Stress now = stress(copy, i);
            for (std::size_t c = 0; c < 4; ++c)
                trial.slope[p][c] = (now[c] - trial.stress_before[p][c]) / step;
            if (!(trial.slope[p][2] > Real(1e-6) * stiffness_)) trial.slope[p][2] = stiffness_;
        }
    }
    /// Better strains where the stress along the normal is not small enough; whether there are any.
    bool improve(const Batch& batch, const Copy<A>& copy, Trial& trial) const {
        bool any = false;
        for (int i = 0; i < count(batch); ++i) {
            const std::size_t p = place(i);
            const typename Trial::Stress now = stress(copy, i);
            const Real strain = std::abs(normal_strain(batch, copy, i)) + std::abs(trial.strain[p]);
            const Real scale = std::abs(now[0]) + std::abs(now[1]) + std::abs(now[3]) + stiffness_ * strain;
            // What is not a number stays; the kernel reports it.
            if (!(std::abs(now[2]) > 16 * epsilon * scale)) continue;
            any = true;
            trial.strain_before[p] = trial.strain[p];
            trial.stress_before[p] = now;
            trial.strain[p] += std::clamp(-now[2] / trial.slope[p][2], Real(-0.5), Real(0.5));
        }
        return any;
    }
    /// Of the speed of waves that leave the thickness alone, a bound of the part that is left where it is
    /// free. Of the squared speed that takes c (c + sigma) / (rho s) with the slopes over the strain along
    /// the normal, c of the stress in the plane and s of that along the normal (c + sigma is the slope of the
    /// latter over a strain in the plane): at rest from (lambda + 2 mu) / rho to E / (rho (1 - nu^2)). No
    /// more from what yields, for waves may unload it.
    Real free_part(const Batch& batch, const Copy<A>& copy, Real speed, const Trial& trial) const {
        Real share = share_ * share_;
        for (int i = 0; i < count(batch); ++i) {
            const Real density =
                copy.particles.column(Field::mass)[i] / copy.particles.column(Field::volume)[i];
            const typename Trial::Stress& slope = trial.slope[place(i)];
            typename Trial::Stress other = stress(copy, i);
            for (std::size_t c = 0; c < 4; ++c) other[c] += slope[c];
            const Real coupled = least_product(in_plane(slope), in_plane(other));
            const Real own = coupled / (slope[2] * density * speed * speed);
            if (own < share) share = own;
        }
        return std::sqrt(1 - share);
    }
    struct Range {
        Real least, most;
    };
    /// What a tensor xx yy zz xy is along the directions of the plane.
    static Range in_plane(const std::array<Real, 4>& tensor) {
        const Real mean = (tensor[0] + tensor[1]) / 2;
        const Real spread = std::hypot((tensor[0] - tensor[1]) / 2, tensor[3]);
        return {mean - spread, mean + spread};
    }
    static Real least_product(const Range& a, const Range& b) {
        return std::min({a.least * b.least, a.least * b.most, a.most * b.least, a.most * b.most});
    }

    Stiffness stiffness_at_rest() const {
        Copy<A> copy(*material_);
        Particles<A>& particles = copy.particles;
        particles.column(Field::volume)[0] = 1 + probe;
        particles.column(Field::mass)[0] = static_cast<Real>(this->density());
        set_normal_strain(copy, 0, probe);
        copy.gathered.velocity_gradient[4][0] = probe;
        material_->update_stress(copy.batch(1), Real(1));
        const auto slope = [&](int c) {
            return static_cast<double>(particles.column(Field::stress, c)[0] / probe);
        };
        return {slope(2), slope(0)};
    }

    static void store(const Batch& batch, const Copy<A>& copy, int i, Real strain) {
        const Index p = batch.begin() + i;
        for (int c = 0; c < S::stress_size; ++c)
            batch.particles().column(Field::stress, c)[p] = copy.particles.column(Field::stress, c)[i];
        for (int k = 0; k < copy.states; ++k)
            batch.state(k, p) = copy.particles.column(copy.first_state + k, 0)[i];
        Real& thickness = batch.state(copy.states, p);
        thickness += strain * (1 + thickness);
        batch.particles().set_value(
            Field::volume, 0, p,
            batch.particles().value(Field::volume, 0, p) * (1 + static_cast<double>(strain)));
    }

    std::shared_ptr<Material<A>> material_;
    Real stiffness_{};  ///< Pa: the slope of the stress along the normal, at rest
    Real share_{};      ///< of a strain in the plane that the thickness takes back at rest, nu / (1 - nu)
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<Copy<A>>> idle_;
};

/// Puts the plane stress of a material in the place of its plane strain.
template <class S>
void replace(Registry::Entry& entry) {
    if constexpr (S::mode == Mode::plane_strain) {
        using A = typename PlaneStress<S>::A;
        const Factory within = entry.make[static_cast<std::size_t>(SpaceId::of<A>().index())];
        entry.make[static_cast<std::size_t>(SpaceId::of<S>().index())] =
            [within](const Parameters& parameters) -> std::shared_ptr<Component> {
            return std::make_shared<PlaneStress<S>>(
                parameters, std::static_pointer_cast<Material<A>>(within(parameters)));
        };
    }
}

}  // namespace

Registry with_plane_stress(const Registry& registry) {
    Registry result;
    for (const auto& [name, entry] : registry.entries()) {
        Registry::Entry own = entry;
        if (own.kind == "material") {
#define MATPOINT_REPLACE(S) replace<S>(own);
            MATPOINT_FOR_EACH_SPACE(MATPOINT_REPLACE)
#undef MATPOINT_REPLACE
        }
        result.add(std::move(own));
    }
    return result;
}

}  // namespace matpoint
