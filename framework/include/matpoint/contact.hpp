#pragma once

#include <matpoint/contact_report.hpp>
#include <matpoint/geometry.hpp>
#include <matpoint/registry.hpp>
#include <matpoint/shape_function.hpp>

#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace matpoint {

template <class S>
class ContactLaw;
template <class S>
class Tool;

/// What lets bodies meet without sharing a velocity: a law between them, or a tool that acts on them. Each is
/// told at most once a step, after all other forces (docs/theory.md, "Contact").
template <class S>
class Contact : public Component {
  public:
    using Space = S;
    using Real = typename S::Real;
    using Vector = typename S::Vector;

    /// Asks for fields of the particles of a body that it holds for, before they are seeded.
    virtual void declare(Particles<S>&) const {}
    /// One of both is not null.
    virtual const ContactLaw<S>* law() const { return nullptr; }
    virtual Tool<S>* tool() { return nullptr; }
};

/// A node at which two bodies have mass, as they would move without contact. Of relative velocities and
/// impulses, only those components count that no boundary condition prescribes.
template <class S>
struct ContactPoint {
    using Real = typename S::Real;
    using Vector = typename S::Vector;

    Vector normal;    ///< from the first body to the second, of length 1
    Real gap;         ///< between their surfaces, m; below 0 they overlap
    Real mass;        ///< m_1 m_2 / (m_1 + m_2), kg
    Vector velocity;  ///< of the second body less that of the first, m/s
    /// N s, along the normal: the least that keeps them from overlapping at the end of the step; 0 if nothing
    /// is needed.
    Real pressing;
    Vector sticking;  ///< N s, across the normal: after it they don't slide
    Real dt;          ///< s
};

void declare_contact_pair(Schema& schema);

/// A law between bodies. The kernel finds where they meet, the normal and the gap (declare()), and gives the
/// impulses, equal and opposite, to both.
template <class S>
class ContactLaw : public Contact<S> {
  public:
    using typename Contact<S>::Vector;

    /// The parameters `between`, `normal` and `gap`, which every law has.
    static void declare_pair(Schema& schema) { declare_contact_pair(schema); }

    const ContactLaw* law() const final { return this; }
    /// Impulse on the second body of each point, N s; the first has the opposite one. One call for all points
    /// of a step at which only two bodies meet; where more do, one by one until they agree.
    virtual void impulses(std::span<const ContactPoint<S>> points, std::span<Vector> out) const = 0;
};

/// What a tool sees of a step.
template <class S>
struct ToolContext {
    using Real = typename S::Real;
    using Vector = typename S::Vector;

    double time;  ///< s, at the start of the step
    double dt;    ///< s
    std::span<Particles<S>> bodies;
    std::span<Patch<S>* const> nodes;  ///< by level, then by body, as it sees them
    const ShapeFunction<S>& shape;
    std::span<const unsigned char> prescribed;  ///< by node: a bit for each component that is
    std::span<const char> inside;  ///< by node: on or within the grid's faces, and moves by itself
    struct Push {
        int node;
        Vector impulse;  ///< N s
    };
    std::vector<Push>& pushes;  ///< so far, by all tools
    /// The level of the grid on which a body has nodes at a place; null: there is one.
    const std::function<int(std::size_t body, const typename S::Position&)>* level_at = nullptr;
    /// What a node follows from, by its place; empty if it moves by itself.
    const std::function<std::span<const NodePart<Real>>(int)>* parents = nullptr;

    int levels() const { return static_cast<int>(nodes.size() / bodies.size()); }
    Patch<S>& nodes_of(std::size_t body, int level) const {
        return *nodes[static_cast<std::size_t>(level) * bodies.size() + body];
    }
    Patch<S>& nodes_at(std::size_t body, const typename S::Position& x) const {
        return nodes_of(body, level_at ? (*level_at)(body, x) : 0);
    }

    /// Velocity of a body's node at the end of the step, as far as is known, m/s.
    Vector velocity(std::size_t body, int node) const {
        Vector v;
        for (int c = 0; c < S::dimension; ++c)
            v[c] = nodes[body]->column(NodeField::velocity, c)[node] +
                   nodes[body]->column(NodeField::acceleration, c)[node] * static_cast<Real>(dt);
        return v;
    }
    /// Gives a node of a body an impulse (N s); boundary conditions take it along the components that they
    /// prescribe.
    void push(std::size_t body, int node, const Vector& amount) {
        const Real mass = nodes[body]->column(NodeField::mass)[node], step = static_cast<Real>(dt);
        if (!(mass > 0)) return;
        for (int c = 0; c < S::dimension; ++c) {
            if ((prescribed[static_cast<std::size_t>(node)] >> c & 1) == 0)
                nodes[body]->column(NodeField::acceleration, c)[node] += amount[c] / (mass * step);
            nodes[body]->column(NodeField::force, c)[node] += amount[c] / step;
        }
        pushes.push_back({node, amount});
    }
};

/// A rigid body that is no particles: it pushes the nodes of the bodies that it meets.
template <class S>
class Tool : public Contact<S> {
  public:
    Tool* tool() final { return this; }
    /// Gives its impulses to the nodes, once a step, and moves.
    virtual void act(ToolContext<S>& context) = 0;
    virtual ContactReport report() const = 0;
    /// Distance from its surface, where it is now. Called from several threads.
    virtual SignedDistance signed_distance(const Eigen::Vector3d& point) const = 0;
    /// From when on it moves as it will to the end, at rest, s; infinity: it may never be.
    virtual double settled_at() const { return 0; }
    /// Its numbers for checkpoints, by name: saved, and set again.
    virtual std::map<std::string, double> state() const { return {}; }
    virtual void restore(const std::map<std::string, double>&) {}
    /// Called once after seeding (not at a restart). Throws std::invalid_argument if it can't begin with
    /// these bodies; what it returns are warnings.
    virtual std::vector<std::string> start(const Patch<S>&, std::span<Particles<S>>) { return {}; }
};

}  // namespace matpoint
