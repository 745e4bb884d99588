#pragma once

#include <matpoint/geometry.hpp>
#include <matpoint/grid.hpp>

#include <deque>
#include <span>
#include <vector>

namespace matpoint {

/// Nested levels of a grid: level l has cells of the size h_0 2^-l in a region of whole cells of level l - 1.
///
/// Particles belong to the finest level whose region is within a cell (of the next coarser level) of them,
/// and talk to nodes of that level only. A node of a finer level whose function does not end within the
/// region is no degree of freedom but follows from its parents, the nodes of the next coarser level that its
/// function is a part of (ShapeFunction::refinement). That is the truncated hierarchical basis: its functions
/// are not negative, add up to 1 and have linear functions among them, so nothing is lost or added at a
/// border.
template <class S>
class Levels {
  public:
    using Position = typename S::Position;
    using Coordinates = typename Patch<S>::Coordinates;

    /// `regions`: of level 1, 2, …; each is grown to whole cells, and so that the next one lies well within
    /// it. Throws std::invalid_argument that names the level whose region is too small to have a node.
    Levels(Patch<S>& coarsest, std::vector<const Geometry*> regions, std::vector<double> refinement);
    /// Moves the regions, by level from 1 on, m from where they were at the start. What leaves the grid is
    /// empty from then on.
    void move(std::span<const Eigen::Vector3d> shifts);

    int count() const { return static_cast<int>(patches_.size()); }
    /// The lattice of a level.
    Patch<S>& patch(int level) const { return *patches_[static_cast<std::size_t>(level)]; }
    const Patch<S>& finest() const { return *patches_.back(); }

    /// That particles at a place belong to.
    int at(const Position& x) const;
    /// Whether a particle of a level may be at a place until particles are next sorted: half a cell beyond
    /// where it belongs, borders being those of the finer and of its own level.
    bool may_be(int level, const Position& x) const;

    /// Whether particles in a cell of the level belong to it.
    bool belongs(int level, const Coordinates& cell) const;
    /// What of a box such cells may be in.
    Geometry::Bounds bounds(int level, Geometry::Bounds box) const;
    /// Of the whole grid, per axis.
    Coordinates cells_along(int level) const;
    /// Whether particles of a level may be anywhere in a box, so far as a look at it as a whole tells.
    bool may_all_be(int level, const Position& low, const Position& high) const;

    /// Whether the node of a level is a degree of freedom, where particles of the level reach it.
    bool free(int level, const Coordinates& node) const;
    /// Whether particles of a level may reach a node.
    bool reached(int level, const Coordinates& node) const;
    struct Parent {
        Coordinates node;
        double weight;
    };
    /// Of a node of a level from 1 on.
    std::vector<Parent> parents(int level, const Coordinates& node) const;
    /// What part of a node's function is left where finer nodes are degrees of freedom.
    double left_of(int level, const Coordinates& node) const;

    /// Cells that are of a level and no finer one; and those that particles of a finer level may be in at
    /// first.
    long cells(int level) const;
    long cells_with_border(int level) const;

    /// A number that a block shares with no other of any level, and back.
    int number_of(int level, int block) const {
        return first_block_[static_cast<std::size_t>(level)] + block;
    }
    int level_of(int number) const;
    int block_of(int number) const {
        return number - first_block_[static_cast<std::size_t>(level_of(number))];
    }

  private:
    /// Cells of a level, in a box of them.
    class Cells {
      public:
        Cells() = default;
        Cells(const Coordinates& low, const Coordinates& high);
        bool operator()(const Coordinates& cell) const;
        void add(const Coordinates& cell);
        bool empty() const;
        const Coordinates& low() const { return low_; }
        const Coordinates& high() const { return high_; }  ///< beyond the last
        template <class Visit>
        void for_each(const Visit& visit) const;

      private:
        std::size_t place(const Coordinates& cell) const;
        Coordinates low_{}, high_{};
        std::vector<bool> has_;
    };
    struct Range {
        int low, high;  ///< beyond the last
    };

    void place_regions(std::span<const Eigen::Vector3d> shifts, bool must_exist);
    void expect_node(int level) const;
    Cells touched(int level, const Geometry& region, const Eigen::Vector3d& shift) const;
    Cells grown(const Cells& cells, int by, int level) const;
    static Cells coarsened(const Cells& cells);
    static void add(Cells& to, const Cells& more);
    Coordinates cell_at(int level, const Position& x) const;
    /// Of the level's cells that a node's function reaches.
    Range support(int level, int node) const;
    template <class Visit>
    bool any_corner(int level, const Position& x, const Visit& visit) const;
    /// Where the function of a coarser node is in the refinement of a node's line.
    int shift(int level) const;
    int mirrored(int level, std::size_t axis, int node) const;

    std::vector<const Geometry*> geometries_;
    std::vector<double> refinement_;
    std::deque<Patch<S>> finer_;
    std::vector<Patch<S>*> patches_;
    std::vector<int> first_block_;
    /// By level, in cells of the next coarser level: the region, and that with one and two cells more around
    /// it.
    std::vector<Cells> region_, zone_, reach_;
};

}  // namespace matpoint
