#pragma once

#include "step/ordering.hpp"
#include "step/walls.hpp"

#include <span>
#include <vector>

namespace matpoint {

/// Faces of the grid that push and rub but do not pull. Nodes on them are those of an open face, as of a free
/// surface, whose velocity v obeys, with the normal n into the grid and the gap g to the body's surface,
///
///     v.n >= -g / dt
///
/// by an impulse J_n >= 0 along n, and against the motion along the face one of at most friction J_n. No
/// impulse adds energy.
///
/// g is told by moments of the body over the cell beside the face, with the weight w = (1 - x/h) times a
/// spline along the face: where V fills x > g it is h (3 sum w V x / (h sum w V) - 1) / 2. So that a thin
/// body isn't told as near, it is no less than the smallest distance of a particle's edge.
template <class S>
class UnilateralFaces {
  public:
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    using Position = typename S::Position;

    explicit UnilateralFaces(const std::vector<PlacedCondition<S>>& conditions);

    bool empty() const { return faces_.empty(); }
    /// Finds the nodes on the faces among those that exist and move by themselves (`inside`), in all layers.
    /// `prescribed`, by node: a bit for each component that is.
    void locate(std::span<Patch<S>* const> layers, const std::vector<char>& inside,
                const std::vector<unsigned char>& prescribed);
    /// Measures gaps with the particles where they are, for a step of length dt (s). `nodes`, by level, then
    /// by body: its layer of them.
    void measure(std::span<Patch<S>* const> nodes, const std::vector<Particles<S>>& bodies,
                 Ordering<S>& ordering, double dt);

    /// Makes the velocity obey that is to be read before the forces change it.
    void push_ahead(Patch<S>& patch);
    /// Gives nodes back what they had before.
    void restore(Patch<S>& patch);
    /// Gives that push to the acceleration of a step of length dt (s).
    void push_again(Patch<S>& patch, Real dt);
    /// Makes NodeField::velocity obey, and changes the acceleration of the step by as much.
    void push(Patch<S>& patch, Real dt);
    /// Makes a field obey without impulse, after push().
    void hold(Patch<S>& patch, NodeField field) const;

    /// Adds to sums[k] what the faces of condition k gave in the step, N s and J. Returns by how much the
    /// last push brought the nodes' forces nearer to balance, N.
    double reaction(const Patch<S>& patch, Real dt, std::vector<typename Walls<S>::Sum>& sums) const;

  private:
    struct Node {
        int index;
        double cell;                    ///< its edge along the normal, m
        double volume = 0, moment = 0;  ///< sum w V, and sum w V x / h
        double least = 0;               ///< distance of a particle's edge, in cells
        bool near = false;              ///< whether there is a gap to tell
        bool sticks = false;
        Real slowest = 0;  ///< velocity along the normal, m/s
        Vector kept = Vector::Zero();
        Vector ahead = Vector::Zero(), push = Vector::Zero();  ///< changes of velocity, m/s
    };
    struct Face {
        int axis;
        int side;  ///< 0: lower, 1: upper
        std::size_t condition;
        Real friction;
        std::vector<Node> nodes{};
        std::vector<int> places{};  ///< in `nodes`, by node of the patch; -1: none

        Real inwards() const { return side == 0 ? Real(1) : Real(-1); }
        double place(const Patch<S>& patch) const {
            return patch.node_position(side == 0 ? typename Patch<S>::Coordinates{} : patch.cells())[axis];
        }
    };

    void add(const Patch<S>& patch, const Particles<S>& particles, Index p, double x, Face& face) const;
    /// Makes a field obey, and tells the change of each node.
    void solve(Patch<S>& patch, NodeField field, Vector Node::*change);
    bool prescribed(int node, int axis) const {
        return ((*prescribed_)[static_cast<std::size_t>(node)] >> axis & 1) != 0;
    }
    bool holds(const Face& face, const Node& node) const {
        return node.near && !prescribed(node.index, face.axis);
    }

    std::vector<Face> faces_;
    const std::vector<unsigned char>* prescribed_ = nullptr;
    bool is_ahead_ = false;
};

}  // namespace matpoint
