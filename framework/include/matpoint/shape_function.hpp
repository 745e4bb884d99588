#pragma once

#include <matpoint/grid.hpp>
#include <matpoint/particles.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace matpoint {

/// What the particles send to the nodes in one pass.
struct Scatter {
    bool mass = false;                    ///< m_i = sum S m
    std::optional<NodeField> momentum{};  ///< into this field: sum S m (v + A (x_i - x_p))
    int affine_slot = -1;                 ///< particle field that is A; -1: none
    bool internal_force = false;          ///< f_i -= sum sigma grad S V
    Field stress = Field::stress;         ///< that is sigma
    int velocity_slot = -1;               ///< particle field that is v; -1: Field::velocity
};

/// What the particles read from the nodes in one pass.
struct Gather {
    std::optional<NodeField> velocity{};  ///< sum S v of this field
    bool acceleration = false;            ///< sum S a
    std::optional<NodeField> gradient{};  ///< sum v (x) grad S of this field
    bool affine = false;                  ///< the affine velocity of NodeField::velocity
};

template <class S>
class GatherSink {
  public:
    /// Called once a batch, particles [begin, begin + count).
    virtual void receive(Index begin, int count, const Gathered<S>& gathered) = 0;

  protected:
    ~GatherSink() = default;
};

/// A point that sends a vector to the nodes of its stencil (a load on a surface, say).
template <class S>
struct PointSource {
    typename S::Position position;
    typename S::Vector half_size;  ///< of the domain it stands for; ignored by shapes without one
    typename S::Vector value;
};

/// Grid basis and particle domain: the weights S_ip = S_i(x_p) and their gradients. One virtual call
/// handles a range of particles; TensorProductShape supplies the loops for shapes given per axis.
template <class S>
class ShapeFunction : public Component {
  public:
    using Space = S;
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    using Position = typename S::Position;
    using Coordinates = typename Patch<S>::Coordinates;

    /// Asks for the particle fields that the shape reads.
    virtual void declare(Particles<S>&) const {}
    /// Most nodes along an axis that a particle reaches.
    virtual int width() const = 0;
    /// What makes a node's function of those on a lattice of half the cell size, N(x) = sum_k c_k N(2 x - k),
    /// k being apart by 1 and symmetric about 0: at nodes if there is an odd number of c, else at the middles
    /// of cells. Empty if it can't be made of them; there are no levels then.
    virtual std::vector<double> refinement() const { return {}; }
    /// Brings the particles' domains up to date; called once at the start of a step, so that the
    /// weights stay the same throughout it.
    virtual void start_step(const Patch<S>&, Particles<S>&) {}
    /// First node of the stencil of each particle in [begin, end).
    virtual void base_nodes(const Patch<S>&, const Particles<S>&, Index begin, Index end,
                            Coordinates* out) const = 0;
    /// The same for a particle of this body at `position`; never less for a greater coordinate.
    virtual Coordinates base_node(const Patch<S>&, const Particles<S>&, const Position& position) const = 0;
    virtual void scatter(Patch<S>&, const Particles<S>&, Index begin, Index end, const Scatter&) const = 0;
    virtual void gather(const Patch<S>&, const Particles<S>&, Index begin, Index end, const Gather&,
                        GatherSink<S>&) const = 0;
    /// Adds the sources' values, weighted by S, to a vector field of the nodes.
    virtual void spread(Patch<S>&, std::span<const PointSource<S>>, NodeField) const = 0;

    /// What ails the shape with a body in this state, and what helps; empty if nothing does. The health guard
    /// asks when a run breaks down, and at its end.
    virtual std::string trouble(const Particles<S>&) const { return {}; }

    /// One point's stencil, for tests and tools: nodes, S and grad S (1/m).
    struct Stencil {
        std::vector<Coordinates> nodes;
        std::vector<Real> weights;
        std::vector<Vector> gradients;
    };
    virtual Stencil stencil(const Patch<S>&, const Position& position, const Vector& half_size) const = 0;
};

}  // namespace matpoint
