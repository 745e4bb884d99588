#pragma once

#include "each_once.hpp"
#include "particle_cloud.hpp"

#include <matpoint/contact.hpp>
#include <matpoint/registry.hpp>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <string>
#include <vector>

/// What every law between bodies must satisfy, in every space, except that laws which bond may pull. Out of
/// tree:
///
///     Registry registry;
///     matpoint_plugin_register(registry);
///     conformance::check_contact(registry, {{"type", "my_law"}, {"between", {"a", "b"}}, …});
///
/// Momentum is kept whatever a law says: the kernel gives its impulse to one body, and the opposite to the
/// other.
namespace matpoint::conformance {

/// A point as the kernel gives it, with sliding and closing velocities (m/s) and a gap (m).
template <class S>
ContactPoint<S> contact_point(const typename S::Vector& normal, const typename S::Vector& velocity,
                              double gap, double mass, double dt) {
    using Real = typename S::Real;
    ContactPoint<S> point;
    point.normal = normal;
    point.gap = static_cast<Real>(gap);
    point.mass = static_cast<Real>(mass);
    point.velocity = velocity;
    point.dt = static_cast<Real>(dt);
    const Real along = normal.dot(velocity);
    point.pressing = std::max(point.mass * (-std::max(point.gap, Real(0)) / point.dt - along), Real(0));
    point.sticking = -point.mass * (velocity - along * normal);
    return point;
}

template <class S>
std::vector<ContactPoint<S>> contact_points() {
    using Vector = typename S::Vector;
    using Real = typename S::Real;
    std::vector<ContactPoint<S>> points;
    for (const double turn : {0.0, 0.3, 1.1, 2.5, 4.0})
        for (const double closing : {-2.0, -1e-3, 0.0, 1e-3, 2.0})
            for (const double sliding : {0.0, 1e-4, -0.7, 30.0})
                for (const double gap : {-1e-3, 0.0, 1e-4, 0.5}) {
                    Vector normal = Vector::Zero(), across = Vector::Zero();
                    normal[0] = static_cast<Real>(S::dimension == 1 ? 1 : std::cos(turn));
                    if constexpr (S::dimension > 1) {
                        normal[1] = static_cast<Real>(std::sin(turn));
                        across[0] = -normal[1];
                        across[1] = normal[0];
                    }
                    if constexpr (S::dimension == 3) {  // sliding in neither of two axes alone
                        across *= static_cast<Real>(0.6);
                        across[2] = static_cast<Real>(0.8);
                    }
                    points.push_back(contact_point<S>(
                        normal, static_cast<Real>(closing) * normal + static_cast<Real>(sliding) * across,
                        gap, 0.02, 1e-3));
                }
    return points;
}

template <class S>
class ContactChecks {
  public:
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    using Point = ContactPoint<S>;

    ContactChecks(const ContactLaw<S>& law, std::vector<Point> points)
        : law_(law), points_(std::move(points)), impulses_(of(points_)) {}

    void all() const {
        does_not_pull();
        keeps_apart();
        takes_energy();
        acts_against_sliding();
        turns_with_the_frame();
        is_the_same_one_by_one();
    }
    /// No impulse across an open gap, nor where bodies separate; where they press, none that draws them on.
    void does_not_pull() const {
        each([&](const Point& point, const Vector& impulse) {
            EXPECT_GE(point.normal.dot(impulse), -close(point)) << "the law pulls";
            if (point.pressing == 0) {
                EXPECT_LE(impulse.norm(), close(point)) << "the law acts where nothing presses";
            }
        });
    }
    void keeps_apart() const {
        each([&](const Point& point, const Vector& impulse) {
            if (point.pressing == 0) return;
            const Real closing = point.normal.dot(after(point, impulse)) * point.dt;
            EXPECT_GE(closing, -std::max(point.gap, Real(0)) - close(point) / point.mass * point.dt)
                << "bodies overlap at the end of the step";
        });
    }
    /// By the impulse's work over the step.
    void takes_energy() const {
        each([&](const Point& point, const Vector& impulse) {
            EXPECT_LE(impulse.dot(point.velocity + after(point, impulse)) / 2,
                      close(point) * (1 + point.velocity.norm()))
                << "the law gives energy";
        });
    }
    /// Across the normal: against the sliding, in its direction, and no more than stops it.
    void acts_against_sliding() const {
        each([&](const Point& point, const Vector& impulse) {
            const Vector across = impulse - point.normal * point.normal.dot(impulse);
            const Real size = point.sticking.norm();
            if (size == 0) {
                EXPECT_LE(across.norm(), close(point));
                return;
            }
            const Real along = across.dot(point.sticking) / size;
            EXPECT_GE(along, -close(point)) << "friction drives what slides";
            EXPECT_LE(along, size + close(point)) << "friction turns the sliding round";
            EXPECT_LE((across - along * point.sticking / size).norm(), close(point))
                << "friction is not in the direction of sliding";
        });
    }
    void turns_with_the_frame() const {
        if constexpr (S::dimension > 1) {
            Eigen::Matrix<Real, S::dimension, S::dimension> turn;
            const Real c = std::cos(Real(0.7)), s = std::sin(Real(0.7));
            turn.setIdentity();
            turn.template topLeftCorner<2, 2>() << c, -s, s, c;
            std::vector<Point> turned = points_;
            for (Point& point : turned) {
                point.normal = (turn * point.normal).eval();
                point.velocity = (turn * point.velocity).eval();
                point.sticking = (turn * point.sticking).eval();
            }
            const std::vector<Vector> impulses = of(turned);
            for (std::size_t k = 0; k < points_.size(); ++k)
                EXPECT_LE((impulses[k] - turn * impulses_[k]).norm(), close(points_[k]))
                    << "the impulse depends on the axes";
        }
    }
    void is_the_same_one_by_one() const {
        for (std::size_t k = 0; k < points_.size(); ++k) {
            Vector alone = Vector::Constant(Real(7));
            law_.impulses({&points_[k], 1}, {&alone, 1});
            EXPECT_EQ(alone, impulses_[k]) << "a point's impulse depends on the others of its batch";
        }
    }

  private:
    std::vector<Vector> of(const std::vector<Point>& points) const {
        std::vector<Vector> impulses(points.size(), Vector::Constant(Real(7)));
        law_.impulses(points, impulses);
        return impulses;
    }
    static Vector after(const Point& point, const Vector& impulse) {
        return point.velocity + impulse / point.mass;
    }
    /// Rounding of an impulse, N s.
    static Real close(const Point& point) {
        return 100 * std::numeric_limits<Real>::epsilon() * point.mass *
               (point.velocity.norm() + std::abs(point.gap) / point.dt);
    }
    template <class Check>
    void each(const Check& check) const {
        for (std::size_t k = 0; k < points_.size(); ++k) {
            SCOPED_TRACE("normal component " + std::to_string(points_[k].normal.dot(points_[k].velocity)) +
                         " m/s, gap " + std::to_string(points_[k].gap) + " m");
            EXPECT_TRUE(impulses_[k].allFinite());
            check(points_[k], impulses_[k]);
        }
    }

    const ContactLaw<S>& law_;
    std::vector<Point> points_;
    std::vector<Vector> impulses_;
};

/// Runs all checks in all spaces. `own`: the contact's object as in a resolved scene.
inline void check_contact(const Registry& registry, const Json& own) {
    each_failure_once([&] {
        in_every_space([&]<class S>(const std::string& space) {
            SCOPED_TRACE(own.dump() + ", " + space);
            const Parameters::Context context{SpaceId::of<S>(), ".", &registry, nullptr};
            const auto contact = registry.make<Contact<S>>("contact", own, context);
            ASSERT_NE(contact->law(), nullptr) << "no law between bodies: a tool has no kit of its own";
            ContactChecks<S>(*contact->law(), contact_points<S>()).all();
        });
    });
}

}  // namespace matpoint::conformance
