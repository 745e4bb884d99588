#pragma once

#include <matpoint/domain_box.hpp>
#include <matpoint/grid.hpp>
#include <matpoint/particles.hpp>
#include <matpoint/shape_function.hpp>
#include <matpoint/spline.hpp>

#include <array>
#include <span>
#include <vector>

namespace matpoint {

/// Consecutive particles of a body whose stencils begin in one block of a level.
struct ParticlesOfBlock {
    std::size_t body;
    int block;
    Index begin, end;
    int level = 0;
};

/// The nodes where layers meet: more than one has mass there. What each layer's material is around such a
/// node is measured by sums over its particles' domains, exact for contiguous boxes, whatever the shape
/// function:
///
///     O = sum_p int_p N_i, M = sum_p int_p N_i (x - x_i)
///
/// with the spline N that reaches as far as the shape function does, on the level of the node; the particles
/// may be of any.
template <class S>
class MeetingNodes {
  public:
    using Vector = typename S::Position;

    /// What a layer has at a node.
    struct Share {
        int place;  ///< of the node in the columns
        std::size_t layer;
        double mass;      ///< kg
        double size = 0;  ///< O, in cells
        Vector moment =
            Vector::Zero();  ///< M, m: M / O is the centroid of what is around the node, from there
    };
    struct Node {
        std::size_t begin, end;  ///< of its shares, by ascending layer
        int level;
    };
    /// A particle near a node, as seen from there, m.
    struct Neighbour {
        Vector position, half_size;
        double volume;
    };

    MeetingNodes(const Patch<S>& patch, const ShapeFunction<S>& shape);

    /// After blocks of nodes have been made: finds those that layers share, and the particles near them.
    /// `layers`, by level, then by layer; `layer`, by body.
    void locate(std::span<Patch<S>* const> layers, std::span<const std::size_t> layer,
                std::vector<ParticlesOfBlock> particles);
    /// Finds the nodes by their mass. `inside`, by node: on or within the grid's faces. `walls`, by axis and
    /// side: whether the grid's face mirrors what is within. `neighbours`: whether they are listed.
    void find(std::span<const Particles<S>> bodies, const std::vector<char>& inside,
              const std::array<std::array<bool, 2>, 3>& walls, bool neighbours);

    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<Share>& shares() const { return shares_; }
    std::span<const Neighbour> neighbours(std::size_t share) const {
        return {neighbours_.data() + first_neighbour_[share],
                neighbours_.data() + first_neighbour_[share + 1]};
    }
    const Spline& spline() const { return spline_; }

  private:
    using Coordinates = typename Patch<S>::Coordinates;
    /// A block that layers share: its places in their columns.
    struct Block {
        int level, number;
        std::size_t begin, end;  ///< of its entries
    };
    struct Entry {
        std::size_t layer;
        int first;  ///< place of its first node
    };
    /// Nodes from low to high.
    struct Box {
        Coordinates low, high;
        bool empty() const { return low[0] > high[0]; }
    };
    struct Near {
        ParticlesOfBlock particles;
        int level;                        ///< of the blocks
        std::vector<std::size_t> blocks;  ///< shared ones in its neighbourhood
    };
    struct Hit {
        Coordinates node;
        std::size_t share;
    };
    const Patch<S>& layer_of(int level, std::size_t layer) const {
        return *layers_[static_cast<std::size_t>(level) * layers_of_level_ + layer];
    }
    /// Blocks of a level that a block's particles are in or beside.
    Box around(const ParticlesOfBlock& particles, int level) const;
    std::vector<std::size_t> shared_in(const Box& box, int level) const;
    void measure(const Near& near, const Box& box, const Particles<S>& particles);
    void add(const Patch<S>& layer, const Box& box, const DomainBox<S>& own);
    void sort_neighbours();

    Spline spline_;
    std::vector<Block> blocks_;
    std::vector<Entry> entries_;
    std::vector<Near> near_;
    std::vector<Patch<S>*> layers_;
    std::size_t layers_of_level_ = 1;
    std::vector<std::size_t> layer_;  ///< by body

    std::array<std::array<bool, 2>, 3> walls_{};
    bool lists_neighbours_ = false;
    std::vector<Box> boxes_;  ///< by shared block: its nodes where layers meet
    std::vector<Node> nodes_;
    std::vector<Share> shares_;
    std::vector<Hit> hits_;      ///< of one particle
    std::vector<int> share_at_;  ///< by place; -1: none
    std::vector<Neighbour> neighbours_, unsorted_;
    std::vector<std::size_t> first_neighbour_, of_share_;
};

}  // namespace matpoint
