#pragma once

#include "step/ordering.hpp"
#include "step/walls.hpp"

#include <span>
#include <vector>

namespace matpoint {

/// Parts of bodies that carry a condition with them: it holds nodes that get `least_share` of their mass or
/// more from the part's particles. At a flat edge that are those up to about half a cell beyond it (1/8 to
/// 1/5 of the mass there, by the shape function), so that what is held ends at the edge in the mean, wherever
/// it lies between nodes.
template <class S>
class HeldParts {
  public:
    using Real = typename S::Real;

    explicit HeldParts(const std::vector<PlacedCondition<S>>& conditions);

    /// Lets go of all nodes and holds those that the parts are at. Nodes' mass must be there as the particles
    /// gave it, not yet folded; NodeField::acceleration is overwritten. `nodes`, by level, then by body: its
    /// layer of them; `inside`, by node: whether it can be held.
    void hold(std::span<Patch<S>* const> nodes, const std::vector<char>& inside,
              const std::vector<Particles<S>>& bodies, const Ordering<S>& ordering,
              const ShapeFunction<S>& shape, Walls<S>& walls) const;

    static constexpr double least_share = 0.15;

  private:
    struct Part {
        std::size_t condition, body;
        int slot;
    };
    std::vector<Part> parts_;
};

}  // namespace matpoint
