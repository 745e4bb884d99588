#pragma once

#include "step/level_borders.hpp"
#include "step/walls.hpp"

namespace matpoint {

/// What ties nodes to others, on the way from particles to nodes and back:
///
///     fold   what particles wrote goes to the nodes that move by themselves: ghosts beyond the grid's faces
///     give
///            it to the nodes within (Walls), nodes of a finer level at its border to their parents
///            (LevelBorders)
///     fill   those that don't move by themselves get what particles read
///
/// Each is linear, and fold is the transpose of fill, so that nothing of the mass, momentum and work is lost.
/// A finer level is folded before the coarser one, which gets what comes of that, and filled after it.
template <class S>
class Ties {
  public:
    Ties(int levels, const Walls<S>& walls, const LevelBorders<S>& borders)
        : levels_(levels), walls_(walls), borders_(borders) {}

    void fold_mass(Patch<S>& patch) const {
        fold(patch, NodeField::mass, [&](int level) { walls_.fold_mass(patch, level); });
    }
    /// Momentum, which holds mass times velocity at `mean`. Call after fold_mass.
    void fold_momentum(Patch<S>& patch, NodeField momentum, const PathMean& mean) const {
        fold(patch, momentum, [&](int level) { walls_.fold_momentum(patch, momentum, mean, level); });
    }
    void fold_force(Patch<S>& patch, NodeField force) const {
        fold(patch, force, [&](int level) { walls_.fold_force(patch, force, level); });
    }
    void fill_velocity(Patch<S>& patch, NodeField velocity, const PathMean& mean) const {
        fill(patch, velocity, [&](int level) { walls_.fill_velocity(patch, velocity, mean, level); });
    }
    void fill_acceleration(Patch<S>& patch, const PathMean& from, const PathMean& to, double dt) const {
        fill(patch, NodeField::acceleration,
             [&](int level) { walls_.fill_acceleration(patch, from, to, dt, level); });
    }

  private:
    template <class FoldWalls>
    void fold(Patch<S>& patch, NodeField field, const FoldWalls& fold_walls) const {
        for (int level = levels_ - 1; level > 0; --level) {
            fold_walls(level);
            borders_.fold(patch, field, level);
        }
        fold_walls(0);
    }
    template <class FillWalls>
    void fill(Patch<S>& patch, NodeField field, const FillWalls& fill_walls) const {
        fill_walls(0);
        for (int level = 1; level < levels_; ++level) {
            borders_.fill(patch, field, level);
            fill_walls(level);
        }
    }

    int levels_;
    const Walls<S>& walls_;
    const LevelBorders<S>& borders_;
};

}  // namespace matpoint
