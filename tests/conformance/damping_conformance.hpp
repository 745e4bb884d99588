#pragma once

#include "each_once.hpp"
#include "particle_cloud.hpp"

#include <matpoint/damping.hpp>
#include <matpoint/registry.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

/// What every damping must satisfy, in every space. Out of tree:
///
///     Registry registry;
///     matpoint_plugin_register(registry);
///     conformance::check_damping(registry, {{"type", "my_damping"}});
namespace matpoint::conformance {

/// Takes energy and never gives any, doesn't turn motion round by itself, and leaves what is at rest at rest.
template <class S>
void takes_energy(const Damping<S>& damping) {
    using Real = typename S::Real;
    std::vector<Real> velocity, acceleration;
    for (const double v : {0.0, 1e-6, 1.0, -1.0, -300.0, 1e6})
        for (const double a : {0.0, 1e-3, -1e-3, 10.0, -10.0, 1e8, -1e8}) {
            velocity.push_back(static_cast<Real>(v));
            acceleration.push_back(static_cast<Real>(a));
        }
    for (const double step : {1e-9, 1e-3, 1.0, 1e6}) {
        const auto dt = static_cast<Real>(step);
        std::vector<Real> slowed(velocity.size(), Real(7));
        damping.resist(velocity, acceleration, dt, slowed);
        for (std::size_t i = 0; i < slowed.size(); ++i) {
            SCOPED_TRACE("v = " + std::to_string(velocity[i]) + ", a = " + std::to_string(acceleration[i]));
            EXPECT_TRUE(std::isfinite(slowed[i]));
            EXPECT_LE(slowed[i] * velocity[i], 0);
            if (velocity[i] == 0) {
                EXPECT_EQ(slowed[i], 0);
            }
            if (acceleration[i] == 0) {
                EXPECT_LE(std::abs(slowed[i] * dt), std::abs(velocity[i]) * Real(1.000001));
            }
        }
    }
    EXPECT_FALSE(damping.stops(1, 2)) << "motion that is just beginning is stopped";
    EXPECT_FALSE(damping.stops(0, 0));
}

/// Runs all checks in all spaces. `own`: the damping's object as in a resolved scene.
inline void check_damping(const Registry& registry, const Json& own) {
    each_failure_once([&] {
        in_every_space([&]<class S>(const std::string& space) {
            SCOPED_TRACE(own.dump() + ", " + space);
            const Parameters::Context context{SpaceId::of<S>(), ".", &registry, nullptr};
            takes_energy(*registry.make<Damping<S>>("damping", own, context));
        });
    });
}

}  // namespace matpoint::conformance
