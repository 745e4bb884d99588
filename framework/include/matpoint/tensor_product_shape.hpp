#pragma once

#include <matpoint/shape_function.hpp>
#include <matpoint/shape_kernel.hpp>
#include <matpoint/stencil_loops.hpp>

#include <algorithm>

namespace matpoint {

/// The whole of a shape function whose weights are products over the axes, from a few lines:
///
///     struct Kernel {
///         static constexpr int width = 2;           // nodes that a particle reaches along an axis
///         static constexpr bool sized = false;      // whether it reads Field::half_size
///         template <class T>                        // first of these nodes; both in cells from any node
///         static T base(T xi);
///         template <class T>                        // s = xi - base, l / h
///         static void evaluate(T s, T half_size, T* weights, T* derivatives);  // per cell
///         static constexpr double refinement[] = {0.5, 1, 0.5};  // if there is one:
///         ShapeFunction::refinement
///     };
///
/// T is a number, or a Pack of them. A particle within the grid must stay within one node of it: base >= -1
/// and base + width <= cells + 2. Weights are recomputed whenever they are needed, which is cheaper than to
/// load them. docs/hot_loops.md explains the loops.
template <class S, class Kernel>
class TensorProductShape : public ShapeFunction<S> {
  public:
    using typename ShapeFunction<S>::Real;
    using typename ShapeFunction<S>::Vector;
    using typename ShapeFunction<S>::Position;
    using typename ShapeFunction<S>::Coordinates;
    using typename ShapeFunction<S>::Stencil;

    static consteval bool is_complete() { return is_kernel<Kernel, Real>(); }

    void declare(Particles<S>& particles) const override {
        if constexpr (Kernel::sized) particles.require(Field::half_size);
    }
    int width() const override { return W; }
    std::vector<double> refinement() const override {
        if constexpr (requires { Kernel::refinement; })
            return {std::begin(Kernel::refinement), std::end(Kernel::refinement)};
        return {};
    }

    void base_nodes(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                    Coordinates* out) const override {
        for (Index p = begin; p < end; ++p) *out++ = base_at(patch, particles.position(p));
    }

    Coordinates base_node(const Patch<S>& patch, const Particles<S>&,
                          const Position& position) const override {
        return base_at(patch, position);
    }

    void scatter(Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                 const Scatter& what) const override {
        visit_tiles(patch, particles, begin, end, [&](const Tile<S>& tile, Index first, Index last) {
            scatter_tile(patch, tile, particles, first, last, end, what);
        });
    }

    void gather(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                const Gather& what, GatherSink<S>& sink) const override {
        visit_tiles(patch, particles, begin, end, [&](const Tile<S>& tile, Index first, Index last) {
            gather_tile(patch, tile, particles, first, last, end, what, sink);
        });
    }

    void spread(Patch<S>& patch, std::span<const PointSource<S>> sources, NodeField field) const override {
        Axes<Real> weights, derivatives;
        for (const PointSource<S>& source : sources) {
            const Coordinates base =
                evaluate_at(patch, source.position, source.half_size, weights, derivatives);
            for (int k = 0; k < N; ++k) {
                const Real weight = weights[0][k % W] * Loops::row_product(weights, weights, 0, k / W);
                const int node = patch.node_index(node_of(base, k));
                for (int c = 0; c < D; ++c) patch.column(field, c)[node] += weight * source.value[c];
            }
        }
    }

    Stencil stencil(const Patch<S>& patch, const Position& position, const Vector& half_size) const override {
        Axes<Real> weights, derivatives;
        const Coordinates base = evaluate_at(patch, position, half_size, weights, derivatives);
        Stencil stencil;
        for (int k = 0; k < N; ++k) {
            stencil.nodes.push_back(node_of(base, k));
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
    using Loops = StencilLoops<S, kernel_width<Kernel>>;
    static constexpr int D = Loops::D, W = Loops::W, N = Loops::N;
    using Lanes = typename Loops::Lanes;
    using LaneVector = typename Loops::LaneVector;
    using Sent = typename Loops::Sent;
    using Reader = typename Loops::Reader;
    template <class T>
    using Axes = typename Loops::template Axes<T>;
    static constexpr int row_length = Patch<S>::block_edge;

    /// Particles of a run that are treated at once.
    struct Slice {
        Index first;
        int count;      ///< lanes in use; the others hold anything
        bool readable;  ///< whether a whole Pack can be read from the columns

        Lanes load(const Real* column) const {
            if (readable) return Lanes::load(column + first);
            Lanes a;
            for (int i = 0; i < Lanes::lanes; ++i) a.set(i, column[first + std::min(i, count - 1)]);
            return a;
        }
    };

    /// Those of `count` particles from p on that fit; columns end at `end` at the earliest.
    static Slice slice_of(Index p, int count, Index end) {
        return {p, std::min(count, Lanes::lanes), p + Lanes::lanes <= end};
    }

    /// The k-th node of a stencil, first axis fastest.
    static Coordinates node_of(Coordinates base, int k) {
        for (int a = 0; a < D; ++a, k /= W) base[a] += k % W;
        return base;
    }
    static int clamped_base(const Patch<S>& patch, int axis, double xi) {
        const double last = patch.cells()[axis] + 2 - W;
        return static_cast<int>(std::min(std::max(-1.0, Kernel::base(xi)), last));
    }
    static Coordinates base_at(const Patch<S>& patch, const Position& position) {
        Coordinates base;
        for (int a = 0; a < D; ++a)
            base[a] = clamped_base(patch, a, (position[a] - patch.min()[a]) * patch.inverse_cell_size()[a]);
        return base;
    }

    /// Calls visit(tile, first, last) for pieces of the range whose stencils one tile holds: all of it when
    /// particles are in the order of blocks.
    template <class Visit>
    static void visit_tiles(const Patch<S>& patch, const Particles<S>& particles, Index begin, Index end,
                            const Visit& visit) {
        for (Index first = begin, last; first < end; first = last) {
            Tile<S> tile(patch, base_at(patch, particles.position(first)), W);
            for (Index batch = last = first; last == batch && last < end;) {
                batch = std::min(end, last + batch_size);
                last = include(tile, patch, particles, last, batch);
            }
            visit(tile, first, last);
        }
    }
    /// Takes as many of the particles as the tile holds, and returns the first that it does not.
    static Index include(Tile<S>& tile, const Patch<S>& patch, const Particles<S>& particles, Index begin,
                         Index end) {
        Vector low, high;
        for (int a = 0; a < D; ++a) {
            const Real* const x = particles.column(Field::position, a);
            Lanes least(x[begin]), greatest = least;
            Index p = begin;
            for (; p + Lanes::lanes <= end; p += Lanes::lanes) {
                least = min(Lanes::load(x + p), least);
                greatest = max(Lanes::load(x + p), greatest);
            }
            for (; p < end; ++p) {
                least = min(Lanes(x[p]), least);
                greatest = max(Lanes(x[p]), greatest);
            }
            low[a] = -largest(-least);
            high[a] = largest(greatest);
        }
        const Coordinates lowest = base_at(patch, lowest_position<S>(low));
        const Coordinates highest = base_at(patch, highest_position<S>(high));
        if (tile.holds(lowest) && tile.holds(highest)) {
            tile.include(lowest);
            tile.include(highest);
            return end;
        }
        for (Index p = begin; p < end; ++p) {
            const Coordinates base = base_at(patch, particles.position(p));
            if (!tile.holds(base)) return p;
            tile.include(base);
        }
        return end;
    }

    /// Where particles are in a tile. In single precision they are counted from a node of the tile, whose
    /// distance is exact however far away the grid's first node is.
    class Locator {
      public:
        Locator(const Patch<S>& patch, const Tile<S>& tile) {
            const Coordinates zero = S::single ? tile.lowest() : Coordinates{};
            const Position from = patch.node_position(zero);
            for (int a = 0; a < D; ++a) {
                const auto rounded = static_cast<Real>(from[a]);
                from_[a] = Lanes(rounded);
                from_remainder_[a] = Lanes(from[a] - static_cast<double>(rounded));
                scale_[a] = Lanes(patch.inverse_cell_size()[a]);
                origin_[a] = Lanes(tile.origin()[a] - zero[a]);
                lowest_[a] = Lanes(tile.lowest()[a] - zero[a]);
                highest_[a] = Lanes(tile.highest()[a] - zero[a]);
            }
        }
        /// Places in the tile of the first nodes of stencils, and positions from there, in cells.
        void locate(const Particles<S>& particles, const Slice& slice, int* places, LaneVector& s) const {
            Lanes place(0);
            for (int a = D - 1; a >= 0; --a) {
                Lanes distance = slice.load(particles.column(Field::position, a)) - from_[a];
                if constexpr (S::single)
                    distance +=
                        slice.load(particles.column(Field::position_remainder, a)) - from_remainder_[a];
                const Lanes xi = distance * scale_[a];
                const Lanes base = min(max(Kernel::base(xi), lowest_[a]), highest_[a]);
                s[a] = xi - base;
                place = multiply_add(place, Lanes(Tile<S>::edge), base - origin_[a]);
            }
            place.store(places);
        }

      private:
        LaneVector from_, from_remainder_, scale_, origin_, lowest_, highest_;
    };

    /// Weights and derivatives (1/m) of the slice.
    static void weigh(const Patch<S>& patch, const Particles<S>& particles, const Slice& slice,
                      const LaneVector& s, Axes<Lanes>& weights, Axes<Lanes>& derivatives) {
        for (int a = 0; a < D; ++a) {
            const Lanes scale(patch.inverse_cell_size()[a]);
            Lanes half_size(0);
            if constexpr (Kernel::sized)
                half_size = slice.load(particles.column(Field::half_size, a)) * scale;
            Kernel::evaluate(s[a], half_size, weights[a].data(), derivatives[a].data());
            for (Lanes& derivative : derivatives[a]) derivative *= scale;
        }
    }

    static Coordinates evaluate_at(const Patch<S>& patch, const Position& position, const Vector& half_size,
                                   Axes<Real>& weights, Axes<Real>& derivatives) {
        Coordinates base;
        for (int a = 0; a < D; ++a) {
            const double xi = (position[a] - patch.min()[a]) * patch.inverse_cell_size()[a];
            const auto scale = static_cast<Real>(patch.inverse_cell_size()[a]);
            base[a] = clamped_base(patch, a, xi);
            Kernel::evaluate(static_cast<Real>(xi - base[a]), half_size[a] * scale, weights[a].data(),
                             derivatives[a].data());
            for (Real& derivative : derivatives[a]) derivative *= scale;
        }
        return base;
    }

    /// (x_i - x_p)_a S along axis a: takes the derivative's place in what is affine in x_i - x_p.
    static void find_moments(const Patch<S>& patch, const Axes<Lanes>& weights, const LaneVector& s,
                             Axes<Lanes>& moments) {
        for (int a = 0; a < D; ++a)
            for (int k = 0; k < W; ++k)
                moments[a][k] = weights[a][k] * (Lanes(k) - s[a]) * Lanes(patch.cell_size()[a]);
    }

    // --- Particles to nodes ---------------------------------------------------------------------

    static constexpr int record = Loops::record;
    MATPOINT_FLATTEN static void scatter_tile(Patch<S>& patch, const Tile<S>& tile,
                                              const Particles<S>& particles, Index first, Index last,
                                              Index end, const Scatter& what) {
        const Sent sent{.motion = what.mass || what.momentum,
                        .affine = what.momentum && what.affine_slot >= 0,
                        .force = what.internal_force};
        alignas(64) std::array<Real, Tile<S>::nodes * record> nodes;
        tile.visit_rows([&](int place, Index) {
            for (int i = 0; i < row_length; i += 4) Loops::clear_records(nodes.data() + (place + i) * record);
        });
        const Locator locator(patch, tile);
        for (Index p = first; p < last; p += Lanes::lanes) {
            const Slice slice = slice_of(p, static_cast<int>(std::min<Index>(last - p, Lanes::lanes)), end);
            LaneVector s;
            std::array<int, Lanes::lanes> places;
            locator.locate(particles, slice, places.data(), s);
            typename Loops::Senders from;
            prepare(sent, patch, particles, slice, s, what, from);
            for (int k = 0; k < slice.count;) {
                Real* const to = nodes.data() + places[k] * record;
                if (k + 1 < slice.count && places[k + 1] == places[k]) {
                    Loops::template send<2>(sent, from, k, to);
                    k += 2;
                } else {
                    Loops::template send<1>(sent, from, k, to);
                    k += 1;
                }
            }
        }
        // By the places of components in a record.
        std::array<Real*, record> columns{};
        for (int c = 0; c < D; ++c) {
            if (what.momentum) columns[c] = patch.column(*what.momentum, c);
            if (what.internal_force) columns[Loops::force_place + c] = patch.column(NodeField::force, c);
        }
        if (what.mass) columns[Loops::mass_place] = patch.column(NodeField::mass);
        tile.visit_rows([&](int place, Index start) {
            for (int i = 0; i < row_length; i += 4)
                Loops::add_records(nodes.data() + (place + i) * record, columns, start + i);
        });
    }

    static void prepare(Sent sent, const Patch<S>& patch, const Particles<S>& particles, const Slice& slice,
                        const LaneVector& s, const Scatter& what, typename Loops::Senders& to) {
        Axes<Lanes> weights, derivatives, moments;
        weigh(patch, particles, slice, s, weights, derivatives);
        to.set_weights(weights);
        if (sent.uses_derivatives()) to.set_slopes(1, weights, derivatives);
        if (sent.affine) {
            find_moments(patch, weights, s, moments);
            to.set_slopes(0, weights, moments);
        }

        typename Loops::Columns value;
        std::array<typename Loops::Columns, D> flux;
        Loops::clear(value);
        for (auto& own : flux) Loops::clear(own);
        if (sent.motion) {
            const Lanes mass = slice.load(particles.column(Field::mass));
            Real* const* const velocity = what.velocity_slot < 0 ? particles.columns(Field::velocity)
                                                                 : particles.columns(what.velocity_slot);
            value[Loops::mass_place] = mass;
            for (int c = 0; c < D; ++c) {
                value[c] = mass * slice.load(velocity[c]);
                if (sent.affine)
                    for (int a = 0; a < D; ++a)
                        flux[a][c] = mass * slice.load(particles.column(what.affine_slot, c + D * a));
            }
        }
        if (sent.force) {
            // f_i -= sum sigma grad S V [Wallstedt & Guilkey 2008, eq. 14]; axisymmetric: and, radially,
            // S V sigma_hoop / r.
            constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
            Real* const* const stress = particles.columns(what.stress);
            const Lanes volume = -slice.load(particles.column(Field::volume));
            for (int a = 0; a < D; ++a)
                for (int c = 0; c < D; ++c)
                    flux[a][Loops::force_place + c] = volume * slice.load(stress[component[c][a]]);
            if constexpr (S::axisymmetric)
                value[Loops::force_place] =
                    volume * slice.load(stress[2]) / slice.load(particles.column(Field::position, 0));
        }
        Loops::transpose_records(sent, value, flux, to);
    }

    // --- Nodes to particles ---------------------------------------------------------------------

    /// Copies of the tile's node fields that are read, one component after the other; null: not asked for.
    struct Copies {
        alignas(64) std::array<Real, 3 * D * Tile<S>::nodes> numbers;
        const Real *velocity = nullptr, *acceleration = nullptr, *gradient = nullptr, *affine = nullptr;

        Copies(const Patch<S>& patch, const Tile<S>& tile, const Gather& what) {
            std::array<NodeField, 3> fields;
            int count = 0;
            const auto copy = [&](NodeField field) -> const Real* {
                int k = 0;
                while (k < count && fields[k] != field) ++k;
                Real* const to = numbers.data() + k * D * Tile<S>::nodes;
                if (k < count) return to;
                fields[count++] = field;
                std::array<const Real*, D> from;
                for (int c = 0; c < D; ++c) from[c] = patch.column(field, c);
                tile.visit_rows([&](int place, Index start) {
                    for (int c = 0; c < D; ++c)
                        Loops::copy_row(from[c] + start, row_length, to + c * Tile<S>::nodes + place);
                });
                return to;
            };
            if (what.velocity) velocity = copy(*what.velocity);
            if (what.acceleration) acceleration = copy(NodeField::acceleration);
            if (what.gradient) gradient = copy(*what.gradient);
            if (what.affine) affine = copy(NodeField::velocity);
        }
    };

    MATPOINT_FLATTEN static void gather_tile(const Patch<S>& patch, const Tile<S>& tile,
                                             const Particles<S>& particles, Index begin, Index last,
                                             Index end, const Gather& what, GatherSink<S>& sink) {
        const Copies nodes(patch, tile, what);
        Gathered<S> gathered;
        const Locator locator(patch, tile);
        std::array<int, batch_size + Lanes::lanes> places;
        std::array<std::array<Real, batch_size + Lanes::lanes>, D> offsets;  // in cells from there
        int ready = 0;  // particles from p on that are gathered already
        for (Index p = begin; p < last;) {
            const int count = static_cast<int>(std::min<Index>(batch_size, last - p));
            for (int i = ready; i < count; i += Lanes::lanes) {
                LaneVector s;
                locator.locate(particles, slice_of(p + i, count - i, end), places.data() + i, s);
                for (int a = 0; a < D; ++a) s[a].store(offsets[a].data() + i);
            }
            int first = ready;
            while (first < count) {
                int next = first + 1;
                while (next < count && places[next] == places[first]) ++next;
                // More of them may lie beyond the batch: the next one has them all.
                if (next == count && first > ready && p + count < last) break;
                for (int i = first; i < next; i += Lanes::lanes) {
                    LaneVector s;
                    for (int a = 0; a < D; ++a) s[a] = Lanes::load(offsets[a].data() + i);
                    gather_slice(patch, particles, places[first], s, slice_of(p + i, next - i, end), nodes,
                                 gathered, i);
                }
                first = next;
            }
            const int whole = p + first < last ? first - first % batch_multiple : first;
            ready = first - whole;
            if (whole > 0) {
                sink.receive(p, whole, gathered);
                if (ready > 0) gathered.keep_from(whole);
                p += whole;
            }
        }
    }

    /// Fills the columns of `gathered` from place `at` on; all particles of the slice have the same base.
    static void gather_slice(const Patch<S>& patch, const Particles<S>& particles, int place,
                             const LaneVector& s, const Slice& slice, const Copies& nodes,
                             Gathered<S>& gathered, int at) {
        constexpr int component = Tile<S>::nodes;
        Reader to;
        weigh(patch, particles, slice, s, to.weight, to.slope);
        to.multiply();

        if (nodes.gradient) {
            for (int c = 0; c < D; ++c) {
                LaneVector gradient;
                const Lanes value =
                    Loops::differentiate(to, nodes.gradient + c * component + place, gradient);
                for (int a = 0; a < D; ++a)
                    store(gradient[a], gathered.velocity_gradient[c + D * a], at, slice.count);
                if (nodes.gradient == nodes.velocity) store(value, gathered.velocity[c], at, slice.count);
                if (S::axisymmetric && c == 0)
                    store(value / slice.load(particles.column(Field::position, 0)),
                          gathered.velocity_gradient[S::deformation_size - 1], at, slice.count);
            }
        }
        const auto interpolate = [&](const Real* from, auto& columns) {
            for (int c = 0; c < D; ++c)
                store(Loops::interpolate(to, from + c * component + place), columns[c], at, slice.count);
        };
        if (nodes.velocity && nodes.gradient != nodes.velocity)
            interpolate(nodes.velocity, gathered.velocity);
        if (nodes.acceleration) interpolate(nodes.acceleration, gathered.acceleration);
        if (nodes.affine) {
            find_moments(patch, to.weight, s, to.slope);
            invert_inertia(patch, to, s);
            to.multiply_slopes();
            for (int c = 0; c < D; ++c) {
                LaneVector affine;
                Loops::differentiate(to, nodes.affine + c * component + place, affine);
                for (int a = 0; a < D; ++a) store(affine[a], gathered.affine[c + D * a], at, slice.count);
            }
        }
    }

    /// Divides the moments of each axis by D_a = sum S (x_i - x_p)_a^2: B D^-1 of the affine transfer.
    static void invert_inertia(const Patch<S>& patch, Reader& to, const LaneVector& s) {
        for (int a = 0; a < D; ++a) {
            Lanes inertia(0);
            for (int k = 0; k < W; ++k)
                inertia += to.slope[a][k] * (Lanes(k) - s[a]) * Lanes(patch.cell_size()[a]);
            // A particle on a node has none, but for rounding.
            const Lanes least(Real(1e-12) * patch.cell_size()[a] * patch.cell_size()[a]);
            inertia = select(inertia > least, inertia, Lanes(0));
            for (Lanes& moment : to.slope[a]) moment *= inverse_or_zero(inertia);
        }
    }

    static void store(Lanes values, std::array<Real, batch_size>& column, int at, int count) {
        if (at + Lanes::lanes <= batch_size) {
            values.store(column.data() + at);  // what is too much, the next pack overwrites
        } else {
            for (int i = 0; i < std::min(count, batch_size - at); ++i) column[at + i] = values[i];
        }
    }
};

}  // namespace matpoint
