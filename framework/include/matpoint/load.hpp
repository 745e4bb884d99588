#pragma once

#include <matpoint/exact_solution.hpp>
#include <matpoint/shape_function.hpp>

namespace matpoint {

/// What a load sees of a step: it adds forces to NodeField::external_force.
template <class S>
struct LoadContext {
    double time;  ///< at the start of the step, s
    Patch<S>& patch;
    std::span<Particles<S>> bodies;
    const ShapeFunction<S>& shape;
    const ExactSolution* exact_solution = nullptr;  ///< the scene's, or null
    std::span<Patch<S>* const> layers = {};  ///< by body: its layer of the nodes; empty: all share them

    /// The nodes as a body's particles see them.
    Patch<S>& nodes_of(const Particles<S>& body) const {
        const auto place = static_cast<std::size_t>(&body - bodies.data());
        return layers.empty() ? patch : *layers[place];
    }
};

/// A force that acts from outside: on the nodes' mass, on particles, on a surface.
template <class S>
class Load : public Component {
  public:
    using Space = S;
    using Real = typename S::Real;
    using Vector = typename S::Vector;

    /// Asks for fields of a body's particles, before they are seeded.
    virtual void declare(Particles<S>&) {}
    /// Called once after seeding (not at a restart), to mark the particles it acts on.
    virtual void start(const Patch<S>&, std::span<Particles<S>>) {}
    virtual void apply(LoadContext<S>& context) const = 0;
    /// Time (s) from which on the load stays as it is; infinite if it never does. A scene does not end at
    /// rest before.
    virtual double settled_at() const { return 0; }
};

}  // namespace matpoint
