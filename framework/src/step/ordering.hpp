#pragma once

#include <matpoint/shape_function.hpp>

#include "grid/levels.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace matpoint {

/// Consecutive particles of one level whose stencils began in one block of it when they were last sorted.
struct BlockRange {
    int block;
    Index begin, end;
    int level = 0;
};

/// A particle that is off the grid, or whose position is not finite.
struct Stray {
    std::size_t body;
    Index particle;
};

/// The box that the particles of a range lie in.
template <class S>
struct Bounds {
    typename S::Vector low, high;
};

/// Where particles may be: within the grid's faces and, axisymmetric, off the axis, where v_r / r is lost to
/// rounding.
template <class S>
Bounds<S> domain(const Patch<S>& patch) {
    using Real = typename S::Real;
    Bounds<S> room{patch.min().template cast<Real>(),  // rounded as the columns of positions are
                   patch.node_position(patch.cells()).template cast<Real>()};
    if constexpr (S::axisymmetric)
        room.low[0] = std::max(room.low[0], std::sqrt(std::numeric_limits<Real>::epsilon()) *
                                                static_cast<Real>(patch.cell_size()[0]));
    return room;
}

/// Keeps every body's particles in the order of the levels that they belong to and of the blocks that their
/// stencils begin in. One that arrives in a finer level is split first (splitting.hpp).
///
/// Between sorts a particle may stray by one cell from the block it was sorted into: stencils (up
/// to four nodes an axis) then reach the neighbouring blocks at most. So the blocks that must exist
/// change only when particles are sorted, and two blocks three apart never write to the same node.
template <class S>
class Ordering {
  public:
    using Ranges = std::vector<BlockRange>;

    explicit Ordering(std::size_t bodies) : ranges_(bodies), colours_(bodies), bounds_(bodies) {}

    /// Particles outside the grid's faces.
    std::vector<Stray> strays(const Patch<S>& patch, const std::vector<Particles<S>>& bodies) const;
    /// Sorts the bodies if a particle has strayed too far, or never was sorted; true if it did. The grid has
    /// no blocks then: what they took serves for sorting.
    bool update(const Levels<S>& levels, std::vector<Particles<S>>& bodies, const ShapeFunction<S>& shape);
    /// Blocks of a level that must exist for these bodies: those with particles and all their neighbours,
    /// ascending.
    std::vector<int> blocks(const Patch<S>& level, std::span<const std::size_t> bodies) const;

    const Ranges& ranges(std::size_t body) const { return ranges_[body]; }
    /// Range numbers of a body by colour: stencils of ranges of one colour never overlap, and each
    /// node receives its sums in the order of colours, whatever the number of threads.
    const std::vector<std::vector<Index>>& colours(std::size_t body) const { return colours_[body]; }
    /// Where the particles of each range of a body are. Whoever moves them keeps it up to date, or has it
    /// measured anew.
    std::vector<Bounds<S>>& bounds(std::size_t body) { return bounds_[body]; }
    void measure(const Particles<S>& particles, std::size_t body);

    /// Continues with the ranges of a checkpoint.
    void restore(const Levels<S>& levels, const std::vector<Particles<S>>& bodies, std::size_t body,
                 Ranges ranges);
    /// Sorts at the next update, whatever has moved.
    void forget(std::size_t body) {
        ranges_[body].clear();
        colours_[body].clear();
    }

  private:
    using Column = Columns<std::uint32_t>;

    bool strayed(const Levels<S>& levels, const Particles<S>& particles, std::size_t body,
                 const ShapeFunction<S>& shape) const;
    bool strayed_to_other_level(const Levels<S>& levels, const Particles<S>& particles, std::size_t body,
                                std::size_t range) const;
    void colour(const Levels<S>& levels, std::size_t body);
    void sort(const Levels<S>& levels, Particles<S>& particles, Ranges& ranges,
              const ShapeFunction<S>& shape);
    Column order(const Levels<S>& levels, const Particles<S>& particles, Ranges& ranges,
                 const ShapeFunction<S>& shape) const;

    std::vector<Ranges> ranges_;
    std::vector<std::vector<std::vector<Index>>> colours_;
    std::vector<std::vector<Bounds<S>>> bounds_;
};

}  // namespace matpoint
