#pragma once

#include <matpoint/grid.hpp>

#include <optional>
#include <span>
#include <vector>

namespace matpoint {

/// Nodes that a body's edge just reaches follow their heavier neighbours. The mass of such a node goes with a
/// higher power of how far the edge reaches beyond it than the force on it and what particles read of it: its
/// own acceleration would strain them, and let loads do work, by as much as that of a full node, however
/// light it is (docs/theory.md, "Light nodes").
///
///     u_i = sum_j E_ij u_j
///
/// is a constraint on each light node i; E extrapolates linearly along lines of other nodes. It is obeyed by
/// an exchange of momentum,
///
///     lambda_i = (1 - s_i) (v_i - sum_j E_ij v_j) / (1 / m_i + sum_j |E_ij| / m_j sum_k |E_kj|)
///     m_i u_i = m_i v_i - lambda_i, m_j u_j = m_j v_j + sum_i E_ij lambda_i
///
/// which keeps momentum and, as sum_j E_ij x_j = x_i, angular momentum. Where constraints have no node in
/// common that is the velocity nearest to v, in kinetic energy, that obeys; elsewhere it comes near it. It is
/// self-adjoint and never adds energy. s_i goes from 0 to 1 as m_i goes from half of `share` of a full node's
/// mass to all of it.
template <class S>
class LightNodes {
  public:
    using Real = typename S::Real;

    /// `share` of a full node's mass below which nodes are light; `density` of the lightest body, kg/m^3.
    LightNodes(double share, double density);

    /// Finds them in each of the layers by the present mass of the nodes, with that of ghosts folded.
    /// `inside`, by node: on or within the grid's faces; `prescribed`, by node: a bit for each component that
    /// a boundary condition sets; `left`, by node: what part of its function finer levels leave, empty if
    /// all; `loaded`: whether NodeField::external_force exists.
    void locate(std::span<Patch<S>* const> layers, const std::vector<char>& inside,
                const std::vector<unsigned char>& prescribed, const std::vector<float>& left, bool loaded);
    bool empty() const { return links_.empty(); }

    /// Makes a velocity field one that particles may read. What goes to prescribed components is added,
    /// `share` times, to `given`, unless that is 0.
    void follow_velocity(Patch<S>& patch, NodeField velocity, Real share = 0,
                         NodeField given = NodeField::force);
    /// Nodes' own velocities, which accelerations are added to, before they follow, and back.
    void keep_velocity(const Patch<S>& patch);
    void restore_velocity(Patch<S>& patch);
    /// The same for the acceleration by the force. What goes to prescribed components is added to the force.
    void follow_acceleration(Patch<S>& patch);

  private:
    using Coordinates = typename Patch<S>::Coordinates;
    /// A node, `steps` times `direction` away, and the next one.
    struct Line {
        Coordinates direction;
        int steps;
    };
    struct Lead {
        int node;
        Real factor;          ///< E
        Real by_mass = 0;     ///< E / m
        Real reluctance = 0;  ///< |E| / m sum_k |E_k|, its part of the denominator
    };
    struct Link {
        int node;
        Real part;                     ///< 1 - s
        int begin, end;                ///< of its leads
        unsigned char prescribed = 0;  ///< a bit for each component that is, of any of them
        Real reluctance = 0;
    };
    struct Found {
        const Line* line;
        int near, far;  ///< -1: none
    };
    enum class State : char { none, firm, follows };
    struct Heaviest {
        int node = -1;
        double mass = 0;
    };

    double full_mass(const Patch<S>& patch, int node) const;
    int firm_node(const Patch<S>& patch, const Coordinates& from, const Coordinates& direction,
                  int steps) const;
    bool mirrored(const Patch<S>& patch, const Coordinates& node, const Coordinates& direction) const;
    /// `part`: of the mass from which a node is firm.
    Link link_of(int node, double part, std::size_t begin) const;
    std::optional<Link> along_lines(const Patch<S>& patch, int node);
    Heaviest heaviest_neighbour(const Patch<S>& patch, const Coordinates& node) const;
    std::optional<Link> beside_heavier(const Patch<S>& patch, int node);
    void weigh(const Patch<S>& patch);
    std::span<const Lead> leads(const Link& link) const {
        return {leads_.data() + link.begin, leads_.data() + link.end};
    }
    template <class Impulse>
    void follow(const Patch<S>& patch, int component, Real* values, Real* force, Real share,
                const Impulse& impulse);
    template <class Visit>
    void visit_nodes(const Visit& visit) const;

    double share_, density_;
    std::vector<std::vector<Line>> lines_;  ///< by distance, the nearest first
    std::vector<Link> links_;               ///< of their nodes none leads another
    std::vector<Lead> leads_;
    std::vector<State> states_;  ///< by node
    std::span<const unsigned char> prescribed_;
    std::span<const float> left_;
    std::vector<int> light_;
    std::vector<float> shared_;  ///< by node: sum_k |E_kj|
    std::vector<Found> found_;
    std::vector<Real> lambda_;  ///< by link
    std::vector<Real> kept_;    ///< by component; of links, then of leads
};

}  // namespace matpoint
