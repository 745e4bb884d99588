#pragma once

#include <matpoint/shape_function.hpp>
#include <matpoint/stencil_loops.hpp>

#include <algorithm>

namespace matpoint {

/// The whole of a shape function whose weights are products over the axes, from a few lines:
///
///     struct Kernel {
///         static constexpr int width = 2;           // nodes that a particle reaches along an axis
///         static constexpr bool sized = false;      // whether it reads Field::half_size
///         template <class Real>                     // first of these nodes; xi = (x - min) / h
///         static int base(Real xi);
///         template <class T>                        // for numbers and for Packs; s = xi - base, l / h
///         static void evaluate(T s, T half_size, T* weights, T* derivatives);  // per cell
///     };
///
/// A particle within the grid must stay within one node of it: base >= -1 and
/// base + width <= cells + 2. Weights are recomputed whenever they are needed, which is cheaper than
/// to load them. The loops treat runs of particles with the same stencil, one particle a lane; nodes
/// are read, summed over lanes and written once a run.
template <class S, class Kernel>
class TensorProductShape : public ShapeFunction<S> {
  public:
    using typename ShapeFunction<S>::Real;
    using typename ShapeFunction<S>::Vector;
    using typename ShapeFunction<S>::Coordinates;
    using typename ShapeFunction<S>::Stencil;

    void declare(Particles<S>& particles) const override {
        if constexpr (Kernel::sized) particles.require(Field::half_size);
    }
    int width() const override { return W; }

    void base_nodes(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                    Coordinates* out) const override {
        Bases bases;
        for (Index first = begin; first < end; first += batch_size) {
            const int count = static_cast<int>(std::min<Index>(batch_size, end - first));
            find_bases(patch, particles, first, count, bases);
            for (int i = 0; i < count; ++i) *out++ = base_of(bases, i);
        }
    }

    void scatter(Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                 const Scatter& what) const override {
        for (Index p = begin; p < end;)
            p = visit_runs(patch, particles, p, end,
                           [&](const Run& run) { scatter_run(patch, particles, run, what); });
    }

    void gather(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                const Gather& what, GatherSink<S>& sink) const override {
        Gathered<S> gathered;
        for (Index p = begin; p < end;) {
            const Index next = visit_runs(patch, particles, p, end, [&](const Run& run) {
                gather_run(patch, particles, run, what, gathered, static_cast<int>(run.first - p));
            });
            sink.receive(p, static_cast<int>(next - p), gathered);
            p = next;
        }
    }

    void spread(Patch<S>& patch, std::span<const PointSource<S>> sources, NodeField field) const override {
        int nodes[N];
        Axes<Real> weights, derivatives;
        for (const PointSource<S>& source : sources) {
            patch.template stencil<W>(
                evaluate_at(patch, source.position, source.half_size, weights, derivatives), nodes);
            for (int k = 0; k < N; ++k) {
                const Real weight = weights[0][k % W] * Loops::row_product(weights, weights, 0, k / W);
                for (int c = 0; c < D; ++c) patch.column(field, c)[nodes[k]] += weight * source.value[c];
            }
        }
    }

    Stencil stencil(const Patch<S>& patch, const Vector& position, const Vector& half_size) const override {
        Axes<Real> weights, derivatives;
        const Coordinates base = evaluate_at(patch, position, half_size, weights, derivatives);
        Stencil stencil;
        for (int k = 0; k < N; ++k) {
            Coordinates node = base;
            for (int a = 0, rest = k; a < D; ++a, rest /= W) node[a] += rest % W;
            stencil.nodes.push_back(node);
            stencil.weights.push_back(weights[0][k % W] * Loops::row_product(weights, weights, 0, k / W));
            Vector gradient;
            for (int a = 0; a < D; ++a)
                gradient[a] = (a == 0 ? derivatives : weights)[0][k % W] *
                              Loops::row_product(weights, derivatives, a, k / W);
            stencil.gradients.push_back(gradient);
        }
        return stencil;
    }

  private:
    using Loops = StencilLoops<Real, S::dimension, Kernel::width>;
    static constexpr int D = Loops::D, W = Loops::W, N = Loops::N;
    using Lanes = typename Loops::Lanes;
    using LaneVector = typename Loops::LaneVector;
    using LaneMatrix = typename Loops::LaneMatrix;
    using Weights = typename Loops::Weights;
    using Nodal = typename Loops::Nodal;
    template <class T>
    using Axes = typename Loops::template Axes<T>;
    /// Most packs in a run.
    static constexpr int max_packs = batch_size / Lanes::lanes;
    using Bases = std::array<std::array<int, batch_size>, D>;

    /// Particles of a run that are treated at once.
    struct Slice {
        Index first;
        int count;      ///< lanes in use; the others repeat the first particle
        bool readable;  ///< whether a whole Pack can be read from the columns

        Lanes load(const Real* column) const {
            Lanes a;
            if (readable) {
                a = Lanes::load(column + first);
            } else {
                for (int i = 0; i < Lanes::lanes; ++i) a.set(i, column[first + std::min(i, count - 1)]);
            }
            return head(a, count, Lanes(a[0]));
        }
        /// 0 in lanes that are not in use.
        Lanes load_or_zero(const Real* column) const { return head(load(column), count, Lanes(0)); }
    };

    /// Consecutive particles, at least one, with the same stencil.
    struct Run {
        Index first;
        int count;
        Index end;  ///< of the particles that may be read: others may be changing in another thread
        Coordinates base;

        int packs() const { return (count - 1) / Lanes::lanes + 1; }
        Slice slice(int k) const {
            const Index begin = first + k * Lanes::lanes;
            return {begin, std::min(Lanes::lanes, count - k * Lanes::lanes), begin + Lanes::lanes <= end};
        }
    };

    static void find_bases(const Patch<S>& patch, const Particles<S>& particles, Index begin, int count,
                           Bases& bases) {
        for (int a = 0; a < D; ++a) {
            const Real* x = particles.column(Field::position, a) + begin;
            const Real min = patch.min()[a], scale = patch.inverse_cell_size()[a];
            const int last = patch.cells()[a] + 2 - W;
            for (int i = 0; i < count; ++i)
                bases[a][i] = std::min(std::max(Kernel::base((x[i] - min) * scale), -1), last);
        }
    }
    static Coordinates base_of(const Bases& bases, int i) {
        Coordinates base;
        for (int a = 0; a < D; ++a) base[a] = bases[a][i];
        return base;
    }

    /// Calls visit(run) for each run from `begin` to the last one that ends within a batch; returns
    /// where the next begins.
    template <class Visit>
    static Index visit_runs(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                            const Visit& visit) {
        const int count = static_cast<int>(std::min<Index>(batch_size, end - begin));
        Bases bases;
        find_bases(patch, particles, begin, count, bases);
        int first = 0;
        while (first < count) {
            const Coordinates base = base_of(bases, first);
            int last = first + 1;
            while (last < count && base_of(bases, last) == base) ++last;
            // It may go on past the batch: the next one has it whole.
            if (last == count && first > 0 && begin + count < end) break;
            visit(Run{begin + first, last - first, end, base});
            first = last;
        }
        return begin + first;
    }

    static void weigh(const Patch<S>& patch, const Particles<S>& particles, const Slice& slice,
                      const Coordinates& base, Weights& weights) {
        for (int a = 0; a < D; ++a) {
            const Lanes scale(patch.inverse_cell_size()[a]);
            const Lanes xi =
                (slice.load(particles.column(Field::position, a)) - Lanes(patch.min()[a])) * scale;
            Lanes half_size(0);
            if constexpr (Kernel::sized)
                half_size = slice.load(particles.column(Field::half_size, a)) * scale;
            weights.s[a] = xi - Lanes(base[a]);
            Kernel::evaluate(weights.s[a], half_size, weights.value[a].data(), weights.derivative[a].data());
            for (Lanes& derivative : weights.derivative[a]) derivative *= scale;
        }
    }

    static Coordinates evaluate_at(const Patch<S>& patch, const Vector& position, const Vector& half_size,
                                   Axes<Real>& weights, Axes<Real>& derivatives) {
        Coordinates base;
        for (int a = 0; a < D; ++a) {
            const Real scale = patch.inverse_cell_size()[a], xi = (position[a] - patch.min()[a]) * scale;
            base[a] = std::min(std::max(Kernel::base(xi), -1), patch.cells()[a] + 2 - W);
            Kernel::evaluate(xi - static_cast<Real>(base[a]), half_size[a] * scale, weights[a].data(),
                             derivatives[a].data());
            for (Real& derivative : derivatives[a]) derivative *= scale;
        }
        return base;
    }

    /// (x_i - x_p)_a S along axis a: takes the derivative's place in what is affine in x_i - x_p.
    static void find_moments(const Patch<S>& patch, const Weights& weights, Axes<Lanes>& moments) {
        for (int a = 0; a < D; ++a)
            for (int k = 0; k < W; ++k)
                moments[a][k] = weights.value[a][k] * (Lanes(k) - weights.s[a]) * Lanes(patch.cell_size()[a]);
    }

    // --- Particles to nodes ---------------------------------------------------------------------

    static void scatter_run(Patch<S>& patch, const Particles<S>& particles, const Run& run,
                            const Scatter& what) {
        const int packs = run.packs();
        if (packs < 1) __builtin_unreachable();
        std::array<Weights, max_packs> weights;
        for (int k = 0; k < packs; ++k) weigh(patch, particles, run.slice(k), run.base, weights[k]);
        int nodes[N];
        patch.template stencil<W>(run.base, nodes);

        std::array<std::array<Lanes, 1>, max_packs> mass;
        for (int k = 0; k < packs; ++k) mass[k][0] = run.slice(k).load_or_zero(particles.column(Field::mass));
        if (what.mass)
            Loops::template add_values<1>(weights.data(), mass.data(), packs, nodes,
                                          {patch.column(NodeField::mass)});
        if (what.momentum) {
            std::array<LaneVector, max_packs> momentum;
            for (int k = 0; k < packs; ++k)
                for (int c = 0; c < D; ++c)
                    momentum[k][c] = mass[k][0] * run.slice(k).load(particles.column(Field::velocity, c));
            Loops::template add_values<D>(weights.data(), momentum.data(), packs, nodes,
                                          columns(patch, *what.momentum));
        }
        if (what.momentum && what.affine_slot >= 0) {
            std::array<Axes<Lanes>, max_packs> moments;
            std::array<LaneMatrix, max_packs> affine;
            for (int k = 0; k < packs; ++k) {
                find_moments(patch, weights[k], moments[k]);
                for (int c = 0; c < D; ++c)
                    for (int a = 0; a < D; ++a)
                        affine[k][c][a] =
                            mass[k][0] * run.slice(k).load(particles.column(what.affine_slot, c + D * a));
            }
            Loops::add_gradients(
                weights.data(), [&](int k) -> const Axes<Lanes>& { return moments[k]; }, affine.data(), packs,
                nodes, columns(patch, *what.momentum));
        }
        if (what.internal_force) scatter_force(patch, particles, run, weights.data(), nodes);
    }

    /// f_i -= sum sigma grad S V [Wallstedt & Guilkey 2008, eq. 14]; axisymmetric: and, radially,
    /// S V sigma_hoop / r.
    static void scatter_force(Patch<S>& patch, const Particles<S>& particles, const Run& run,
                              const Weights* weights, const int* nodes) {
        constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
        std::array<LaneMatrix, max_packs> flux;
        std::array<std::array<Lanes, 1>, max_packs> hoop;
        for (int k = 0; k < run.packs(); ++k) {
            const Slice slice = run.slice(k);
            const auto load = [&](Field field, int c) { return slice.load(particles.column(field, c)); };
            const Lanes volume = -slice.load_or_zero(particles.column(Field::volume));
            for (int c = 0; c < D; ++c)
                for (int a = 0; a < D; ++a) flux[k][c][a] = volume * load(Field::stress, component[c][a]);
            if constexpr (S::axisymmetric)
                hoop[k][0] = volume * load(Field::stress, 2) / load(Field::position, 0);
        }
        Loops::add_gradients(
            weights, [&](int k) -> const Axes<Lanes>& { return weights[k].derivative; }, flux.data(),
            run.packs(), nodes, columns(patch, NodeField::force));
        if constexpr (S::axisymmetric)
            Loops::template add_values<1>(weights, hoop.data(), run.packs(), nodes,
                                          {patch.column(NodeField::force, 0)});
    }

    static std::array<Real*, D> columns(Patch<S>& patch, NodeField field) {
        std::array<Real*, D> columns;
        for (int c = 0; c < D; ++c) columns[c] = patch.column(field, c);
        return columns;
    }

    // --- Nodes to particles ---------------------------------------------------------------------

    /// Fills the columns of `gathered` from place `at` on.
    static void gather_run(const Patch<S>& patch, const Particles<S>& particles, const Run& run,
                           const Gather& what, Gathered<S>& gathered, int at) {
        int nodes[N];
        patch.template stencil<W>(run.base, nodes);
        Nodal velocity, acceleration, gradient, affine;
        if (what.velocity) load(patch, *what.velocity, nodes, velocity);
        if (what.acceleration) load(patch, NodeField::acceleration, nodes, acceleration);
        if (what.gradient) load(patch, *what.gradient, nodes, gradient);
        if (what.affine) load(patch, NodeField::velocity, nodes, affine);

        for (int k = 0; k < run.packs(); ++k, at += Lanes::lanes) {
            const Slice particle = run.slice(k);
            Weights weights;
            weigh(patch, particles, particle, run.base, weights);
            if (what.velocity)
                store(Loops::interpolate(weights.value, velocity), gathered.velocity, at, particle.count);
            if (what.acceleration)
                store(Loops::interpolate(weights.value, acceleration), gathered.acceleration, at,
                      particle.count);
            if (what.gradient) {
                LaneVector value;
                const LaneMatrix l = Loops::differentiate(weights.value, weights.derivative, gradient, value);
                store(l, gathered.velocity_gradient, at, particle.count);
                if constexpr (S::axisymmetric)
                    store(value[0] / particle.load(particles.column(Field::position, 0)),
                          gathered.velocity_gradient[D * D], at, particle.count);
            }
            if (what.affine) {
                Axes<Lanes> moments;
                find_moments(patch, weights, moments);
                invert_inertia(patch, weights, moments);
                LaneVector value;
                store(Loops::differentiate(weights.value, moments, affine, value), gathered.affine, at,
                      particle.count);
            }
        }
    }

    /// Divides the moments of each axis by D_a = sum S (x_i - x_p)_a^2: B D^-1 of the affine transfer.
    static void invert_inertia(const Patch<S>& patch, const Weights& weights, Axes<Lanes>& moments) {
        for (int a = 0; a < D; ++a) {
            Lanes inertia(0);
            for (int k = 0; k < W; ++k)
                inertia += moments[a][k] * (Lanes(k) - weights.s[a]) * Lanes(patch.cell_size()[a]);
            for (Lanes& moment : moments[a]) moment *= inverse_or_zero(inertia);
        }
    }

    static void load(const Patch<S>& patch, NodeField field, const int* nodes, Nodal& values) {
        for (int c = 0; c < D; ++c) {
            const Real* column = patch.column(field, c);
            for (int k = 0; k < N; ++k) values[c][k] = column[nodes[k]];
        }
    }

    static void store(Lanes values, std::array<Real, batch_size>& column, int at, int count) {
        if (at + Lanes::lanes <= batch_size) {
            values.store(column.data() + at);  // what is too much, the next pack overwrites
        } else {
            for (int i = 0; i < count; ++i) column[at + i] = values[i];
        }
    }
    template <std::size_t Components>
    static void store(const LaneVector& values, std::array<std::array<Real, batch_size>, Components>& columns,
                      int at, int count) {
        for (int c = 0; c < D; ++c) store(values[c], columns[c], at, count);
    }
    template <std::size_t Components>
    static void store(const LaneMatrix& values, std::array<std::array<Real, batch_size>, Components>& columns,
                      int at, int count) {
        for (int c = 0; c < D; ++c)
            for (int a = 0; a < D; ++a) store(values[c][a], columns[c + D * a], at, count);
    }
};

}  // namespace matpoint
