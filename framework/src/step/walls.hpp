#pragma once

#include <matpoint/boundary_condition.hpp>
#include <matpoint/geometry.hpp>
#include <matpoint/grid.hpp>

#include "step/ordering.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace matpoint {

/// Particles of a body that carry a condition with them.
struct BodyPart {
    std::size_t body;                  ///< its number
    std::shared_ptr<Geometry> within;  ///< at the start; null: the whole body
    int slot = -1;                     ///< of the particle field that is 1 there
};

/// A boundary condition and where it holds.
template <class S>
struct PlacedCondition {
    std::string name;
    std::shared_ptr<BoundaryCondition<S>> condition;
    std::vector<std::string> faces;  ///< "x_min", …; empty if it holds elsewhere
    std::shared_ptr<Geometry> region;
    std::optional<BodyPart> part{};
};

/// What a prescribed velocity is asked for: the mean over the path of the material at a node, as the field at
/// `time` carries it, within `span` from now, or if that is negative until now; with 0 the field at the node.
/// Material that moves with the velocity of a place leaves its path along the chord: it would spiral out of a
/// rotation.
struct PathMean {
    double time;      ///< s
    double span = 0;  ///< s
};

/// What scenes call the grid's face normal to `axis`; side 0 is the lower one.
inline std::string face_name(int axis, int side) {
    return std::string(1, "xyz"[axis]) + (side == 0 ? "_min" : "_max");
}

template <class S>
bool holds_on(const PlacedCondition<S>& placed, int axis, int side) {
    return std::ranges::find(placed.faces, face_name(axis, side)) != placed.faces.end();
}
/// Of a condition on faces that push and rub but do not pull.
template <class S>
std::optional<double> friction_of(const PlacedCondition<S>& placed) {
    return guarded(*placed.condition, "friction", [&] { return placed.condition->friction(); });
}
/// How a particle that is beyond a face of the grid got there.
struct Exit {
    std::string face;  ///< "x_min", …
    double distance;   ///< beyond it, in cells
    enum class Through { open, outflow, closed } through;
};

/// What happens to the nodes at and beyond the grid's faces, and in regions with prescribed velocity.
///
/// Stencils write to a layer of ghost nodes beyond the faces. fold() brings those sums back to the
/// nodes within, fill() gives ghosts the values that particles read:
/// - a wall (a face with a boundary condition) mirrors: prescribed components of velocity are odd
///   about the prescribed velocity, the others even, as if a mirrored body lay behind;
/// - an open face, and one that is unilateral, extrapolates, v_-1 = 2 v_0 - v_1, which turns any basis into
/// one that is
///   interpolatory at the face and still reproduces linear functions.
/// fold() is the transpose of fill(), so momentum and energy balance to rounding.
template <class S>
class Walls {
  public:
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    using Position = typename S::Position;

    explicit Walls(std::vector<PlacedCondition<S>> conditions);

    /// Finds the nodes concerned among those that exist, in each of the layers. `followers`, by node: whether
    /// it follows from others of a coarser level, so that none is prescribed; empty: none does.
    void locate(std::span<Patch<S>* const> layers, const std::vector<char>& followers);
    /// Holds a node, with what a condition prescribes away from faces, beside what holds there already; until
    /// all nodes held so are let go.
    void hold_node(const Patch<S>& patch, int node, std::size_t condition);
    void let_go();

    /// Of the ghosts of a level.
    void fold_mass(Patch<S>& patch, int level) const;
    /// Folds momentum, which holds mass times velocity at `mean`. Call after fold_mass.
    void fold_momentum(Patch<S>& patch, NodeField momentum, const PathMean& mean, int level) const;
    void fold_force(Patch<S>& patch, NodeField force, int level) const;

    /// Sets prescribed components of a velocity field to their values at `mean`.
    void constrain(Patch<S>& patch, NodeField velocity, const PathMean& mean) const;
    /// Sets prescribed components of the acceleration to what changes their velocity from its value
    /// at `from` to that at `to` within dt.
    void constrain_acceleration(Patch<S>& patch, const PathMean& from, const PathMean& to, double dt) const;
    void fill_velocity(Patch<S>& patch, NodeField velocity, const PathMean& mean, int level) const;
    void fill_acceleration(Patch<S>& patch, const PathMean& from, const PathMean& to, double dt,
                           int level) const;

    /// Adds to sums[k] what condition k puts into prescribed components: at a node and its ghosts
    /// `share` of (mass value - source), source being force or momentum, value acceleration or
    /// velocity; and the power against the prescribed velocity to `power`.
    struct Sum {
        std::array<double, 3> total{};
        double power = 0;
        bool held = false;  ///< whether a node with mass obeyed the condition
    };
    void reaction(const Patch<S>& patch, NodeField source, NodeField value, const PathMean& mean,
                  std::vector<Sum>& sums) const;

    /// Before velocities change within.
    void keep_ghosts(const Patch<S>& patch, NodeField velocity);
    /// After that: adds `share` times what those of prescribed components change by, as the images of nodes
    /// within, to the force that reaction() reads.
    void add_change_of_ghosts(Patch<S>& patch, NodeField velocity, const PathMean& mean, Real share) const;

    /// The face that a particle at `x` is beyond, if there is one. It is closed where its condition
    /// prescribes the normal velocity, and none that carries particles out, at `time`.
    std::optional<Exit> exit(const Patch<S>& patch, const Position& x, double time) const;
    /// Puts a particle that is beyond closed faces by hardly more than nothing onto them: velocities vanish
    /// there, but rounding and nodes with hardly any mass push on. Whether it is on the grid then.
    bool hold(const Patch<S>& patch, Particles<S>& particles, Index particle, double time) const;

    /// By axis and side: whether the grid's face is a wall that mirrors motion along the axis.
    std::array<std::array<bool, 2>, 3> mirrors() const;
    /// By node: a bit for each component that a condition sets.
    const std::vector<unsigned char>& prescribed_components() const { return prescribed_components_; }
    const std::vector<PlacedCondition<S>>& conditions() const { return conditions_; }

  private:
    struct Link {
        int ghost, edge, inner;  ///< places of nodes -1, 0 and, its image beyond a wall, 1; counted inwards
        Position position;       ///< of the face before the ghost
    };
    struct Face {
        int axis;
        int side;                                 ///< 0: lower, 1: upper
        std::array<int, S::dimension> condition;  ///< index into conditions_ by component; -1: free
        bool wall = false;
        bool unilateral = false;               ///< open, but closed to particles
        std::vector<std::vector<Link>> links;  ///< by level
        template <class Visit>
        void for_links(const Visit& visit) const {
            for (const auto& own : links) std::ranges::for_each(own, visit);
        }
        /// Where particles stop, along the axis.
        double place(const Patch<S>& patch) const {
            const Bounds<S> room = domain(patch);
            return static_cast<double>(side == 0 ? room.low[axis] : room.high[axis]);
        }
    };
    struct Prescribed {
        int node;
        int component;
        int condition;
        Position position;
    };

    class Velocities;

    std::optional<Exit> exit(const Face& face, const Patch<S>& patch, const Position& x, double time) const;
    template <class Value>
    void fill(Patch<S>& patch, NodeField field, const Value& prescribed, int level) const;
    std::optional<Link> link_of(const Patch<S>& patch, int ghost, const Face& face) const;
    Vector velocity(int condition, const Position& position, const PathMean& mean) const;
    Vector along_path(int condition, const Position& position, const PathMean& mean) const;
    std::array<bool, 3> prescribed(std::size_t condition, int axis) const;
    void carry(std::size_t condition, const std::array<bool, 3>& prescribes);

    std::vector<PlacedCondition<S>> conditions_;
    std::vector<Vector> carries_;  ///< by condition: 1 for components that it prescribes, 0 for the others
    std::vector<Face> faces_;      ///< by axis, lower before upper
    std::vector<Prescribed> prescribed_;
    std::size_t located_ = 0;  ///< how many of them stay where they are on the grid
    std::vector<unsigned char> prescribed_components_;
    std::vector<Real> kept_ghosts_;  ///< of prescribed components, face by face
};

}  // namespace matpoint
