#pragma once

#include "contact/layers.hpp"
#include "contact/meeting_nodes.hpp"
#include "contact/placed_contact.hpp"

#include <span>
#include <vector>

namespace matpoint {

/// Resolves the contacts between bodies: at each node where layers meet, impulses that are equal and
/// opposite.
template <class S>
class ContactPairs {
  public:
    using Vector = typename S::Position;

    ContactPairs(std::vector<PlacedContact<S>> contacts, ContactLayers layers, const Patch<S>& patch,
                 const ShapeFunction<S>& shape);

    /// Whether bodies have velocities of their own.
    bool any() const { return layers_.count > 1; }
    const ContactLayers& layers() const { return layers_; }
    MeetingNodes<S>& nodes() { return nodes_; }
    bool meet() const { return !nodes_.nodes().empty(); }
    /// Whether a normal or a gap needs the particles near a node.
    bool needs_neighbours() const { return needs_neighbours_; }
    /// Normals and gaps at the nodes that were found.
    void orient();

    /// What contact does to a share of a node. Boundary conditions take the impulse along the components that
    /// they prescribe.
    struct Change {
        Vector velocity;  ///< m/s
        Vector impulse;   ///< N s
    };
    /// By share of a node (MeetingNodes::shares): what contact does to `velocity`, m/s, within a step of dt
    /// (s). `prescribed`, by node: a bit for each component that is.
    void resolve(std::span<const Vector> velocity, std::span<const unsigned char> prescribed, double dt,
                 std::vector<Change>& change);
    /// Adds what the last resolve() did to the reports of a step of dt (s), at whose start nodes had the
    /// velocity `start`.
    void report(std::span<const Vector> start, double dt);

    const std::vector<PlacedContact<S>>& contacts() const { return contacts_; }
    const ContactReport& report_of(std::size_t contact) const { return reports_[contact]; }
    std::vector<ContactReport>& reports() { return reports_; }

  private:
    using Point = ContactPoint<S>;
    /// Two layers at a node.
    struct Pair {
        std::size_t first, second;  ///< shares
        std::size_t law;
        Vector normal;
        double gap;                       ///< m
        double cell;                      ///< m, the smallest edge of those around
        Vector impulse = Vector::Zero();  ///< on the second, N s
        bool alone;                       ///< whether no third layer is there
    };

    Vector inverse_mass(std::size_t share) const;
    Point point_of(const Pair& pair, double dt) const;
    void apply(const Pair& pair, double sign);
    void resolve_alone(double dt);
    void resolve_together(double dt);

    std::vector<PlacedContact<S>> contacts_;
    ContactLayers layers_;
    MeetingNodes<S> nodes_;
    Vector cell_size_;  ///< of the coarsest level, m
    bool needs_neighbours_ = false;
    std::vector<Pair> pairs_;       ///< by node
    std::vector<Vector> velocity_;  ///< by share
    std::span<const unsigned char> prescribed_;
    std::vector<std::size_t> alone_;  ///< pairs of one law
    std::vector<Point> points_;
    std::vector<typename S::Vector> impulses_;
    std::vector<ContactReport> reports_;
};

}  // namespace matpoint
