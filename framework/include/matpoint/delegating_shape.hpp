#pragma once

#include <matpoint/shape_function.hpp>

namespace matpoint {

/// A shape function that hands its work to another, chosen at run time: among kernels of different
/// widths, say, each of which has its loops compiled.
template <class S>
class DelegatingShape : public ShapeFunction<S> {
  public:
    using typename ShapeFunction<S>::Vector;
    using typename ShapeFunction<S>::Position;
    using typename ShapeFunction<S>::Coordinates;
    using typename ShapeFunction<S>::Stencil;

    void declare(Particles<S>& particles) const override { widest().declare(particles); }
    int width() const override { return widest().width(); }
    std::vector<double> refinement() const override { return widest().refinement(); }
    void base_nodes(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                    Coordinates* out) const override {
        shape_of(particles).base_nodes(patch, particles, begin, end, out);
    }
    Coordinates base_node(const Patch<S>& patch, const Particles<S>& particles,
                          const Position& position) const override {
        return shape_of(particles).base_node(patch, particles, position);
    }
    void scatter(Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                 const Scatter& what) const override {
        shape_of(particles).scatter(patch, particles, begin, end, what);
    }
    void gather(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                const Gather& what, GatherSink<S>& sink) const override {
        shape_of(particles).gather(patch, particles, begin, end, what, sink);
    }
    void spread(Patch<S>& patch, std::span<const PointSource<S>> sources, NodeField field) const override {
        widest().spread(patch, sources, field);
    }
    Stencil stencil(const Patch<S>& patch, const Position& position, const Vector& half_size) const override {
        return widest().stencil(patch, position, half_size);
    }

  protected:
    /// The shape of a body's particles.
    virtual const ShapeFunction<S>& shape_of(const Particles<S>& particles) const = 0;
    /// The widest of all bodies', used for points that belong to none.
    virtual const ShapeFunction<S>& widest() const = 0;
};

}  // namespace matpoint
