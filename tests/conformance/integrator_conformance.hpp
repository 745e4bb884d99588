#pragma once

#include "each_once.hpp"
#include "particle_cloud.hpp"

#include <matpoint/integrator.hpp>
#include <matpoint/registry.hpp>

#include <gtest/gtest.h>

#include <cmath>

/// What every integrator must satisfy, in every space. Out of tree:
///
///     Registry registry;
///     matpoint_plugin_register(registry);
///     conformance::check_integrator(registry, {{"type", "my_integrator"}}, order);
namespace matpoint::conformance {

/// One particle of unit mass on a spring, seen through the phases of a step: its "stress" is the
/// spring's extension, its grid a single node. It also checks that phases come in an order that makes
/// sense.
template <class S>
class Oscillator final : public Phases<S> {
  public:
    using typename Phases<S>::Real;
    using typename Phases<S>::Projection;
    using typename Phases<S>::Update;

    double stiffness = 1;
    double carried = 1;  ///< share of the particle's velocity that reaches the node
    double position = 0, extension = 0, velocity = 0;

    void step(const Integrator<S>& integrator, double dt) {
        dt_ = static_cast<Real>(dt);
        done_ = {};
        has_remapped_ = false;
        for (const NodeField field : integrator.node_fields())
            has_remapped_ |= field == NodeField::remapped_velocity;
        lags_ = integrator.lags();
        integrator.step(*this, dt_);
        EXPECT_TRUE(done_.velocity && done_.position && done_.accelerated);
        EXPECT_NEAR(done_.strained, dt, 1e-6 * dt) << "strain over less or more than the step";
        ++number_;
    }

    long step_number() const override { return number_; }
    void project(Projection what) override {
        EXPECT_TRUE(what.velocity || what.internal_force);
        EXPECT_FALSE(done_.accelerated);
        if (what.velocity) {
            EXPECT_FALSE(done_.projected);
            node_velocity_ = carried * velocity;
            done_.projected = true;
        }
        if (what.internal_force) {
            force_ = -stiffness * extension;
            done_.force = true;
        }
    }
    void accelerate(Real dt, Real factor) override {
        EXPECT_TRUE(done_.projected && done_.force);
        EXPECT_FALSE(done_.accelerated);
        EXPECT_EQ(dt, dt_);
        EXPECT_GT(factor, 0);
        EXPECT_LE(factor, 1);
        acceleration_ = static_cast<double>(factor) * force_;
        node_velocity_ += acceleration_ * static_cast<double>(dt);
        done_.accelerated = true;
    }
    void remap() override {
        EXPECT_TRUE(has_remapped_) << "the integrator has not asked for NodeField::remapped_velocity";
        EXPECT_TRUE(done_.velocity);
        remapped_velocity_ = carried * velocity;
        done_.remapped = true;
    }
    void update(Update what, Real step) override {
        EXPECT_TRUE(what.velocity || what.position || what.stress || what.lag);
        if (what.lag) {
            EXPECT_TRUE(lags_) << "the integrator has not said that it lags";
            EXPECT_FALSE(what.velocity || what.position || what.stress);
            lag_ = node(*what.lag) - strained_with_;
            return;
        }
        if (!what.stress || what.velocity || what.position) {
            EXPECT_EQ(step, dt_);
        }
        const auto dt = static_cast<double>(step);
        if (what.velocity) {
            EXPECT_TRUE(done_.accelerated);
            EXPECT_FALSE(done_.velocity);
            velocity += acceleration_ * dt;
            done_.velocity = true;
        }
        if (what.position) {
            EXPECT_FALSE(done_.position);
            position += node(*what.position) * dt;
            done_.position = true;
        }
        if (what.stress) {
            strained_with_ = node(*what.stress);
            extension += (strained_with_ + lag_) * dt;
            lag_ = 0;
            done_.strained += dt;  // in parts, if the integrator likes
        }
    }

  private:
    double node(NodeField field) const {
        EXPECT_TRUE(done_.projected);
        if (field == NodeField::velocity) return node_velocity_;
        EXPECT_EQ(field, NodeField::remapped_velocity);
        EXPECT_TRUE(done_.remapped);
        return remapped_velocity_;
    }

    struct Done {
        bool projected = false, force = false, accelerated = false, remapped = false;
        bool velocity = false, position = false;
        double strained = 0;  // s
    };
    Done done_;
    bool has_remapped_ = false, lags_ = false;
    double lag_ = 0, strained_with_ = 0;
    long number_ = 0;
    Real dt_ = 0;
    double node_velocity_ = 0, remapped_velocity_ = 0, force_ = 0, acceleration_ = 0;
};

template <class S>
class IntegratorChecks {
  public:
    explicit IntegratorChecks(const Integrator<S>& integrator) : integrator_(integrator) {}

    void all(int order) const {
        moves_freely_without_force();
        energy_is_bounded();
        stays_bounded_up_to_its_largest_phase();
        EXPECT_NEAR(measured_order(), order, 0.15);
    }

    void moves_freely_without_force() const {
        Oscillator<S> particle;
        particle.stiffness = 0;
        particle.velocity = 2;
        for (int i = 0; i < 8; ++i) particle.step(integrator_, 0.125);
        EXPECT_EQ(particle.velocity, 2);
        EXPECT_EQ(particle.position, 2);
        EXPECT_EQ(particle.extension, 2);
    }

    void energy_is_bounded() const {
        Oscillator<S> spring;
        spring.extension = spring.position = 1;
        for (int i = 0; i < 20000; ++i) {
            spring.step(integrator_, 0.125);
            const double energy = spring.velocity * spring.velocity + spring.extension * spring.extension;
            ASSERT_NEAR(energy, 1, 0.15) << "step " << i;
        }
    }

    /// Whether particles carry the node's motion on to the next step or not.
    void stays_bounded_up_to_its_largest_phase() const {
        EXPECT_GT(integrator_.largest_phase(), 0);
        for (const double carried : {1.0, 0.0}) {
            Oscillator<S> spring;
            spring.extension = spring.position = 1;
            spring.carried = carried;
            for (int i = 0; i < 2000 && std::abs(spring.extension) < 1e3; ++i)
                spring.step(integrator_, 0.99 * integrator_.largest_phase());
            EXPECT_LT(std::abs(spring.extension), 1e3)
                << "largest_phase is too high where nodes carry " << carried << " of the velocity";
        }
    }

    /// From the extension and the position of the spring at time 1, which are cos(1).
    double measured_order() const {
        const auto error = [&](int steps) {
            Oscillator<S> spring;
            spring.extension = spring.position = 1;
            for (int i = 0; i < steps; ++i) spring.step(integrator_, 1.0 / steps);
            return std::max(std::abs(spring.extension - std::cos(1.0)),
                            std::abs(spring.position - std::cos(1.0)));
        };
        return std::log2(error(64) / error(128));
    }

  private:
    const Integrator<S>& integrator_;
};

/// Runs all checks in all spaces. `own`: the integrator's object as in a resolved scene; `order`: of
/// its positions and strains.
inline void check_integrator(const Registry& registry, const Json& own, int order) {
    each_failure_once([&] {
        in_every_space([&]<class S>(const std::string& space) {
            SCOPED_TRACE(own.dump() + ", " + space);
            const Parameters::Context context{SpaceId::of<S>(), ".", &registry, nullptr};
            IntegratorChecks<S>(*registry.make<Integrator<S>>("integrator", own, context)).all(order);
        });
    });
}

}  // namespace matpoint::conformance
