#pragma once

#include <matpoint/exact_solution.hpp>
#include <matpoint/shape_function.hpp>

#include <functional>

namespace matpoint {

/// What a load sees of a step: it adds forces to NodeField::external_force.
template <class S>
struct LoadContext {
    double time;      ///< at the start of the step, s
    Patch<S>& patch;  ///< all nodes, by their places
    std::span<Particles<S>> bodies;
    const ShapeFunction<S>& shape;
    const ExactSolution* exact_solution = nullptr;  ///< the scene's, or null
    /// By level, then by body: its layer of the nodes; empty: all share the patch.
    std::span<Patch<S>* const> layers = {};
    /// The level of the grid on which a body has nodes at a place; null: there is one.
    const std::function<int(std::size_t body, const typename S::Position&)>* level_at = nullptr;

    /// The nodes as a body's particle sees them at a place.
    Patch<S>& nodes_at(const Particles<S>& body, const typename S::Position& x) const {
        return nodes_of(body, level_of(body, x));
    }
    /// Adds the values of a body's sources, weighted by S, to a vector field of the nodes.
    void spread(const Particles<S>& body, std::span<const PointSource<S>> sources, NodeField field) const {
        while (!sources.empty()) {
            const int level = level_of(body, sources.front().position);
            std::size_t count = level_at ? 1 : sources.size();
            while (count < sources.size() && level_of(body, sources[count].position) == level) ++count;
            shape.spread(nodes_of(body, level), sources.first(count), field);
            sources = sources.subspan(count);
        }
    }

  private:
    std::size_t number_of(const Particles<S>& body) const {
        return static_cast<std::size_t>(&body - bodies.data());
    }
    int level_of(const Particles<S>& body, const typename S::Position& x) const {
        return level_at ? (*level_at)(number_of(body), x) : 0;
    }
    Patch<S>& nodes_of(const Particles<S>& body, int level) const {
        if (layers.empty()) return patch;
        return *layers[static_cast<std::size_t>(level) * bodies.size() + number_of(body)];
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
