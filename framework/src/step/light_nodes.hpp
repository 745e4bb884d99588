#pragma once

#include <matpoint/grid.hpp>

#include <vector>

namespace matpoint {

/// Nodes that a body's edge just reaches follow their heavier neighbours. The mass of such a node goes with a
/// higher power of how far the edge reaches beyond it than the force on it and what particles read of it: its
/// own acceleration would strain them, and let loads do work, by as much as that of a full node, however
/// light it is (docs/theory.md, "Light nodes").
///
///     u_i = s_i v_i + (1 - s_i) sum_j E_ij u_j        s_i = 2 m_i / (share of a full node's mass) - 1, from
///     0 to 1
///
/// where v are a node's own velocity (or acceleration), u what particles read, and E extrapolates linearly
/// from heavier nodes along the axes. Mass, momentum and force fold by the transpose, so momentum and work
/// are kept as if the shape functions were sum_i S_i (s_i delta_ij + (1 - s_i) E_ij), which sum to 1 as well.
template <class S>
class LightNodes {
  public:
    using Real = typename S::Real;

    /// `share` of a full node's mass below which nodes are light; `density` of the lightest body, kg/m^3.
    LightNodes(double share, double density) : share_(share), density_(density) {}

    /// Finds them by the present mass of the nodes. `inside`, by node: on or within the grid's faces;
    /// `prescribed`, by node: a bit for each component that a boundary condition sets; `loaded`: whether
    /// NodeField::external_force exists.
    void locate(const Patch<S>& patch, const std::vector<char>& inside,
                const std::vector<unsigned char>& prescribed, bool loaded);
    /// Own values to those of all others that they are made of.
    void fold(Patch<S>& patch, NodeField field) const;
    /// What particles read, from the nodes' own values, which can be had back once.
    void fill(Patch<S>& patch, NodeField field);
    void restore(Patch<S>& patch, NodeField field) const;
    bool empty() const { return links_.empty(); }

  private:
    using Coordinates = typename Patch<S>::Coordinates;
    struct Link {
        int node;
        Real own;   ///< s
        int begin;  ///< of its terms
        int end;
    };
    struct Term {
        int node;
        Real weight;  ///< (1 - s) E
    };

    double full_mass(const Patch<S>& patch, const Coordinates& node) const;
    bool link(const Patch<S>& patch, int node, const std::vector<char>& inside,
              const std::vector<unsigned char>& prescribed);

    double share_, density_;
    std::vector<Link> links_;  ///< those that others are made of before these
    std::vector<Term> terms_;
    std::vector<char> state_;  ///< by node
    std::vector<int> pending_;
    std::vector<Real> own_;  ///< values before fill(), by link and component
};

}  // namespace matpoint
