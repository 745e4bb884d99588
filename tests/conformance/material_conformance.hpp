#pragma once

#include "each_once.hpp"
#include "specimen.hpp"

#include <matpoint/registry.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>
#include <string>

/// What every material must satisfy, in every space. Out of tree:
///
///     Registry registry;
///     matpoint_plugin_register(registry);
///     conformance::check_material(registry, {{"type", "tait_water"}, {"density", 1000}, …});
///
/// with every parameter given. Choose them so that strains of 20 % store energy reversibly, if the
/// material has a stored energy.
namespace matpoint::conformance {

/// What a material promises: to be right for any motion, or as the linear theory is, for small strains and
/// rotations, where its energy needs to match its stress to the first order of the strain only (but in a
/// bar).
enum class MaterialLaw { objective, small_strain };

template <class S>
class MaterialChecks {
  public:
    using Real = typename S::Real;
    static constexpr double eps = std::numeric_limits<Real>::epsilon();
    /// Step of central differences, and bound of their relative error.
    static inline const double h = std::cbrt(eps), difference_error = 20 * h * h;

    explicit MaterialChecks(const Material<S>& material, MaterialLaw law = MaterialLaw::objective)
        : material_(material), objective_(law == MaterialLaw::objective) {
        Specimen<S> s(material_);
        modulus_ = static_cast<double>(s.density()) * std::pow(static_cast<double>(s.wave_speed()), 2);
    }

    void all() {
        zero_at_rest();
        state_is_initialised();
        stress_is_derivative_of_energy();
        rotation_turns_stress();
        waves_are_not_faster();
        survives_what_is_not_finite();
        batches_are_independent();
    }

    void zero_at_rest() const {
        Specimen<S> s(material_);
        for (int i = 0; i < 3; ++i) s.step(Tensor<S>());
        EXPECT_LE(norm(s.stress()), 100 * eps * modulus_) << "there is stress where nothing is strained";
        if (const auto energy = s.stored_energy()) {
            EXPECT_NEAR(*energy, 0, 100 * eps * modulus_) << "energy is stored where nothing is strained";
        }
    }

    void state_is_initialised() const {
        Specimen<S> s(material_, 3);
        std::set<std::string> names;
        const auto states = material_.state();
        for (std::size_t k = 0; k < states.size(); ++k) {
            EXPECT_FALSE(states[k].name.empty());
            EXPECT_TRUE(names.insert(states[k].name).second) << states[k].name << " is there twice";
            EXPECT_FALSE(field_from_name(states[k].name)) << states[k].name << " is a field of the kernel's";
            EXPECT_EQ(s.state(static_cast<int>(k), 2), static_cast<Real>(states[k].initial))
                << states[k].name;
        }
    }

    /// dW/dt = J sigma : D, W per initial volume.
    void stress_is_derivative_of_energy() {
        const double strain = objective_ || S::dimension == 1 ? 0.2 : 1e-3;
        const double neglected = objective_ || S::dimension == 1 ? 0 : 20 * strain * strain;
        for (int i = 0; i < 10; ++i) {
            Specimen<S> s = deformed(strain);
            if (!s.stored_energy()) return;
            const Tensor<S> direction = random_tensor<S>(random_);
            Specimen<S> plus = s, minus = s;
            plus.step(Real(h) * direction);
            minus.step(Real(-h) * direction);
            const double slope = (*plus.stored_energy() - *minus.stored_energy()) / (2 * h);
            const double power =
                static_cast<double>(determinant(s.deformation()) * contract(s.stress(), direction));
            EXPECT_NEAR(slope, power, (difference_error + neglected) * modulus_)
                << "the stress is not the derivative of the stored energy";
        }
    }

    /// In a rigid turn the stress turns along, exactly or to second order in the step. An unsymmetric
    /// stress fails too, of which only one half is stored.
    void rotation_turns_stress() {
        if (S::dimension == 1 || !objective_) return;
        constexpr int steps = 720;
        const double angle = 2 * std::numbers::pi / steps;
        Specimen<S> s = deformed();
        const Tensor<S> stress = s.stress();
        ASSERT_GT(norm(stress), 1e-3 * modulus_)
            << "the specimen is hardly stressed: choose other parameters";
        for (int k = 1; k <= steps; ++k) {
            s.step(turn<S>(angle));
            if (k != steps / 4 && k != steps) continue;
            const Tensor<S> r = rotation<S>(k * angle);
            EXPECT_LE(norm(s.stress() - r * stress * transpose(r)),
                      4 * angle * angle * norm(stress) + 4 * k * eps * modulus_)
                << "the stress does not turn with the body: after " << k << " steps of " << steps;
        }
    }

    /// rho c^2 bounds a.Q.a, where Q a is the change of traction on n under the strain a (x) n, for
    /// compression waves (a = n) and shear waves (a across n).
    void waves_are_not_faster() {
        std::vector<Specimen<S>> states{Specimen<S>(material_), deformed(), stretched(1.6), stretched(0.6)};
        states.push_back(stretched(1.6));
        states.back().step(turn<S>(0.5));
        for (Specimen<S>& s : states) {
            const double speed = static_cast<double>(s.wave_speed());
            ASSERT_TRUE(speed > 0 && std::isfinite(speed))
                << "wave speed of " << speed << " m/s: it must be positive and finite";
            double stiffest = 0;  // Pa
            for (int i = 0; i < 40; ++i) {
                const auto n = random_direction<S>(random_);
                typename S::Vector a = n;
                if (S::dimension > 1 && i % 2) {
                    const auto other = random_direction<S>(random_);
                    a = (other - other.dot(n) * n).normalized();
                }
                stiffest = std::max(stiffest, stiffness(s, n, a));
            }
            const auto density = static_cast<double>(s.density());
            if (stiffest > density * speed * speed + difference_error * modulus_)
                ADD_FAILURE() << "wave speed too low: " << speed << " m/s where waves run at "
                              << std::sqrt(stiffest / density)
                              << " m/s; time steps that follow from it are too long";
        }
    }

    static double stiffness(const Specimen<S>& s, const typename S::Vector& n, const typename S::Vector& a) {
        Tensor<S> strain;
        strain.plane = Real(h) * a * n.transpose();
        Specimen<S> plus = s, minus = s;
        plus.step(strain);
        minus.step(Real(-1) * strain);
        return static_cast<double>(a.dot((plus.stress() - minus.stress()).plane * n)) / (2 * h);
    }

    void survives_what_is_not_finite() const {
        Tensor<S> inverting;
        inverting.plane(0, 0) = -2;
        for (const Real factor : {Real(1), std::numeric_limits<Real>::infinity(),
                                  std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::max()}) {
            Specimen<S> s(material_);
            s.step(factor * inverting);
            s.wave_speed();
            s.stored_energy();
            s.step(Tensor<S>());
        }
    }

    void batches_are_independent() {
        Specimen<S> whole(material_, batch_size);
        std::vector<Tensor<S>> gradients;
        for (int p = 0; p < batch_size; ++p) gradients.push_back(Real(0.1) * random_tensor<S>(random_));
        for (const Index extent : {1, 7, 32}) {
            Specimen<S> split = whole, together = whole;
            for (int step = 0; step < 2; ++step) {
                split.step(gradients, extent);
                together.step(gradients, batch_size);
            }
            for (int f = 0; f < whole.particles().field_count(); ++f)
                for (int c = 0; c < whole.particles().components(f); ++c)
                    for (Index p = 0; p < batch_size; ++p)
                        ASSERT_EQ(split.particles().column(f, c)[p], together.particles().column(f, c)[p])
                            << whole.particles().name(f) << " of particle " << p << ", batches of " << extent;
            EXPECT_EQ(split.wave_speed(extent), together.wave_speed()) << "batches of " << extent;
        }
    }

  private:
    static double norm(const Tensor<S>& t) { return std::sqrt(static_cast<double>(contract(t, t))); }

    Specimen<S> deformed(double strain = 0.2) {
        Specimen<S> s(material_);
        const Tensor<S> direction = random_tensor<S>(random_);
        for (int i = 0; i < 4; ++i) s.step(static_cast<Real>(strain / 4) * direction);
        return s;
    }
    Specimen<S> stretched(double stretch) const {
        Specimen<S> s(material_);
        Tensor<S> gradient;
        gradient.plane(0, 0) = static_cast<Real>(std::pow(stretch, 0.05) - 1);
        for (int i = 0; i < 20; ++i) s.step(gradient);
        return s;
    }

    const Material<S>& material_;
    bool objective_;
    double modulus_;  ///< Pa
    std::mt19937 random_{1};
};

/// Runs all checks in all spaces. `own`: the material's object as in a resolved scene.
inline void check_material(const Registry& registry, const Json& own,
                           MaterialLaw law = MaterialLaw::objective) {
    each_failure_once([&] {
        constexpr const char* modes[] = {"bar", "plane strain", "axisymmetric", "solid"};
        for (const Mode mode : {Mode::bar, Mode::plane_strain, Mode::axisymmetric, Mode::solid}) {
            for (const bool single : {false, true}) {
                const SpaceId id{mode, single};
                SCOPED_TRACE(own.at("type").get<std::string>() + ", " + modes[static_cast<int>(mode)] +
                             (single ? ", single precision" : ", double precision"));
                with_space(id, [&]<class S>() {
                    const Parameters::Context context{id, ".", &registry, nullptr};
                    MaterialChecks<S>(*registry.make<Material<S>>("material", own, context), law).all();
                });
            }
        }
    });
}

}  // namespace matpoint::conformance
