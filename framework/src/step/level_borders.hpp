#pragma once

#include "grid/levels.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace matpoint {

/// Nodes of a finer level that follow from their parents of the next coarser one, v_j = sum_i P_ji v_i
/// (Levels). fold() gives the parents what particles wrote to them, by the transpose of P, and leaves nothing
/// behind: no sum over nodes counts it twice. fill() gives them what particles read.
template <class S>
class LevelBorders {
  public:
    using Real = typename S::Real;

    /// Adds the blocks of parents to those of each level and layer that particles reach (numbers, ascending;
    /// of one level the layers after each other).
    static void add_parents(const Levels<S>& levels, std::span<std::vector<int>> blocks);
    /// Finds them among the nodes that exist.
    void locate(const Levels<S>& levels, std::span<Patch<S>* const> layers);

    /// Of a level, to the next coarser one.
    void fold(Patch<S>& patch, NodeField field, int level) const;
    /// Of a level, from the next coarser one.
    void fill(Patch<S>& patch, NodeField field, int level) const;

    /// Whether a block of particles of a level writes to nodes that follow.
    bool borders(int level, int block) const {
        return std::ranges::binary_search(blocks_of_[static_cast<std::size_t>(level)], block);
    }
    /// Of a level: adds what the velocity of its followers' momentum changes by from there to the parents
    /// along an axis, for NodeField::affine_momentum along it: sum_j P_ji (sum_p S_jp m_p A_p) (x_i - x_j),
    /// so that linear velocities are linear at parents too. Of all parents of a node that is nothing.
    void extend(Patch<S>& patch, NodeField momentum, int level, int axis) const;

    /// By node: whether it follows from others. Empty if none does.
    const std::vector<char>& followers() const { return followers_; }
    /// Of a node that follows; none of others.
    std::span<const NodePart<Real>> parents(int node) const {
        const auto [begin, end] = parents_at_[static_cast<std::size_t>(node)];
        return {parents_.data() + begin, parents_.data() + end};
    }
    /// By node: what part of its function finer levels leave. Empty if that is all of each.
    const std::vector<float>& left() const { return left_; }

  private:
    struct Follower {
        int node;
        int begin, end;  ///< of its parents
    };
    std::vector<std::vector<Follower>> followers_of_;  ///< by level
    std::vector<NodePart<Real>> parents_;
    std::vector<std::array<int, 2>> parents_at_;  ///< by node: begin and end of its parents
    std::vector<typename S::Vector> ways_;        ///< by parent: to it from the node that follows, m
    std::vector<std::vector<int>>
        blocks_of_;  ///< by level, ascending: those with followers in or beside them
    std::vector<char> followers_;
    std::vector<float> left_;
};

}  // namespace matpoint
