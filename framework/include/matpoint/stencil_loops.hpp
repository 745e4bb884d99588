#pragma once

#include <matpoint/pack.hpp>
#include <matpoint/particles.hpp>
#include <matpoint/tile.hpp>

#include <array>
#include <utility>

namespace matpoint {

/// The sums between particles and the nodes of a tile, for weights that are products over the axes. A row of
/// nodes along the first axis shares the product of all others.
///
/// Particles to nodes: one particle after the other, its lanes are the components of what it sends. So
/// nothing is summed over lanes, and particles may lie in any order. Nodes to particles: a lane is a
/// particle, all with the same stencil.
template <class S, int Width>
struct StencilLoops {
    using Real = typename S::Real;
    static constexpr int D = S::dimension, W = Width;
    static constexpr int rows = D == 1 ? 1 : D == 2 ? W : W * W;
    static constexpr int N = rows * W;

    using Lanes = Pack<Real>;
    using LaneVector = std::array<Lanes, D>;
    /// One number for each node along each axis.
    template <class T>
    using Axes = std::array<std::array<T, W>, D>;

    /// Product of a row's weights over all axes but the first, with those of axis b from `slopes`.
    template <class T>
    static T row_product(const Axes<T>& weights, const Axes<T>& slopes, int b, int row) {
        T product(1);
        for (int a = 1; a < D; ++a, row /= W) product *= (a == b ? slopes : weights)[a][row % W];
        return product;
    }
    /// Place of a row's first node, from the stencil's first.
    static constexpr int row_place(int row) {
        int place = 0;
        for (int a = 1; a < D; ++a, row /= W) place += row % W * Tile<S>::stride(a);
        return place;
    }

    // --- Particles to nodes ---------------------------------------------------------------------

    /// Components of what a particle sends to a node: momentum, mass, force; each half is four numbers.
    static constexpr int record = 8, mass_place = 3, force_place = 4;
    /// Packs of a record, and the half that a pack belongs to.
    static constexpr int parts = record / Lanes::lanes;
    static constexpr int half_of(int part) { return part * Lanes::lanes / force_place; }
    /// Whether a part has numbers that go with S itself: of force, the hoop stress alone does.
    static constexpr bool has_value(int part) { return half_of(part) == 0 || S::axisymmetric; }

    /// What is sent in a pass; motion: mass and momentum.
    struct Sent {
        bool motion, affine, force;

        bool uses(int part) const { return parts == 1 || (half_of(part) == 0 ? motion : force); }
        /// Whether anything is multiplied by slopes in a part.
        bool uses_flux(int part) const { return parts == 1 ? affine || force : half_of(part) == 1 || affine; }
        /// Whether the derivatives must be there: where one pack holds both halves, 0 must not meet a NaN.
        bool uses_derivatives() const { return force || (parts == 1 && affine); }
    };
    /// Which slopes the lanes of a pack are multiplied by: none, those of its own half, or those of force.
    enum class Slopes { none, own, force };

    /// A pack of particles ready to be sent. Slopes take the weights' place on axis a in what flux[a] is
    /// multiplied by: of momentum (0) the moments S (x_i - x_p), of force (1) the derivatives.
    struct alignas(64) Senders {  // what crosses a cache line is slow to read soon after it was written
        using Numbers = std::array<Real, Lanes::lanes>;  ///< one a particle
        std::array<Numbers, W> weight;                   ///< on the first axis
        std::array<Numbers, rows> product;               ///< of weights on the others
        std::array<std::array<Numbers, W>, 2> slope;
        std::array<std::array<std::array<Numbers, rows>, D>, 2> slope_product;
        std::array<std::array<Real, record>, Lanes::lanes> value;                ///< times S
        std::array<std::array<std::array<Real, record>, Lanes::lanes>, D> flux;  ///< times S with slopes

        void set_weights(const Axes<Lanes>& weights) {
            for (int x = 0; x < W; ++x) weights[0][x].store(weight[x].data());
            for (int row = 0; row < rows; ++row)
                row_product(weights, weights, 0, row).store(product[row].data());
        }
        void set_slopes(int half, const Axes<Lanes>& weights, const Axes<Lanes>& slopes) {
            for (int x = 0; x < W; ++x) slopes[0][x].store(slope[half][x].data());
            for (int a = 1; a < D; ++a)
                for (int row = 0; row < rows; ++row)
                    row_product(weights, slopes, a, row).store(slope_product[half][a][row].data());
        }
        /// The numbers of a particle that the lanes of a part are multiplied by.
        template <int part, Slopes slopes>
        static Lanes of_part(Real motion, Real force) {
            if constexpr (slopes == Slopes::force) return Lanes(force);
            if constexpr (parts > 1) return Lanes(motion);
            return head(Lanes(motion), force_place, Lanes(force));
        }
    };
    using Columns = std::array<Lanes, record>;  ///< of records, a particle a lane
    MATPOINT_INLINE static void clear(Columns& columns) {
#pragma GCC unroll 8  // or it becomes a call of memset's kind, which takes longer
        for (Lanes& column : columns) column = Lanes(0);
    }
    static void transpose_records(Sent sent, Columns& value, std::array<Columns, D>& flux, Senders& to) {
        const auto transpose = [](int part, Columns& columns, auto& records) {
            Lanes* const own = columns.data() + part * Lanes::lanes;
            Lanes::transpose(own);
            for (int i = 0; i < Lanes::lanes; ++i) own[i].store(records[i].data() + part * Lanes::lanes);
        };
        for (int part = 0; part < parts; ++part) {
            if (!sent.uses(part)) continue;
            if (has_value(part)) transpose(part, value, to.value);
            if (sent.uses_flux(part))
                for (int a = 0; a < D; ++a) transpose(part, flux[a], to.flux[a]);
        }
    }

    /// node += S value + sum_a (S with slopes on axis a) flux_a, of the i-th particle and the next, `count`
    /// in all with the same stencil, for all its nodes, which begin at `nodes`.
    template <int count>
    static void send(Sent sent, const Senders& from, int i, Real* nodes) {
        send_parts<count>(sent, from, i, nodes, std::make_integer_sequence<int, parts>());
    }
    template <int count, int... part>
    static void send_parts(Sent sent, const Senders& from, int i, Real* nodes,
                           std::integer_sequence<int, part...>) {
        (send_part<part, count>(sent, from, i, nodes), ...);
    }
    template <int part, int count>
    static void send_part(Sent sent, const Senders& from, int i, Real* nodes) {
        if (!sent.uses(part)) return;
        if constexpr (half_of(part) == 1) {
            add_part<part, Slopes::force, count>(from, i, nodes);
        } else {
            if (sent.affine) return add_part<part, Slopes::own, count>(from, i, nodes);
            if constexpr (parts == 1)
                if (sent.force) return add_part<part, Slopes::force, count>(from, i, nodes);
            add_part<part, Slopes::none, count>(from, i, nodes);
        }
    }

    /// The same for the lanes of one part. A node is read and written once for all `count` particles.
    template <int part, Slopes slopes, int count>
    static void add_part(const Senders& from, int i, Real* nodes) {
        constexpr bool flux = slopes != Slopes::none;
        const auto load = [&](const auto& records, int p) {
            return Lanes::load(records[i + p].data() + part * Lanes::lanes);
        };
#pragma GCC unroll 16
        for (int row = 0; row < rows; ++row) {
            Real* const first = nodes + row_place(row) * record + part * Lanes::lanes;
            std::array<Lanes, count> along, across;
#pragma GCC unroll 2
            for (int p = 0; p < count; ++p) {
                const Lanes product(from.product[row][i + p]);
                along[p] = has_value(part) ? product * load(from.value, p) : Lanes(0);
                if constexpr (!flux) continue;
#pragma GCC unroll 2
                for (int a = 1; a < D; ++a)
                    along[p] = multiply_add(
                        Senders::template of_part<part, slopes>(from.slope_product[0][a][row][i + p],
                                                                from.slope_product[1][a][row][i + p]),
                        load(from.flux[a], p), along[p]);
                across[p] = product * load(from.flux[0], p);
            }
#pragma GCC unroll 4
            for (int x = 0; x < W; ++x) {
                Lanes sum = Lanes::load(first + x * record);
#pragma GCC unroll 2
                for (int p = 0; p < count; ++p) {
                    sum = multiply_add(Lanes(from.weight[x][i + p]), along[p], sum);
                    if constexpr (flux)
                        sum = multiply_add(Senders::template of_part<part, slopes>(from.slope[0][x][i + p],
                                                                                   from.slope[1][x][i + p]),
                                           across[p], sum);
                }
                sum.store(first + x * record);
            }
        }
    }

    /// Sets the records of four nodes in a row to 0.
    static void clear_records(Real* records) {
#pragma GCC unroll 16
        for (int i = 0; i < 4 * record; i += Lanes::lanes) Lanes(0).store(records + i);
    }
    /// Adds the records of four nodes in a row to the columns of their components, from `start` on; a column
    /// that is null is not asked for.
    static void add_records(const Real* records, const std::array<Real*, record>& columns, Index start) {
        using Nodes = Pack<Real, 4>;
        for (int half = 0; half < record; half += force_place) {
            if (columns[half] == nullptr && columns[half + mass_place] == nullptr) continue;
            std::array<Nodes, 4> own;
            for (int i = 0; i < 4; ++i) own[i] = Nodes::load(records + i * record + half);
            Nodes::transpose(own.data());
            for (int c = 0; c < 4; ++c) {
                Real* const column = columns[half + c];
                if (column) (Nodes::load(column + start) + own[c]).store(column + start);
            }
        }
    }

    // --- Nodes to particles ---------------------------------------------------------------------

    /// Copies the numbers of nodes in a row, a multiple of four.
    static void copy_row(const Real* from, int count, Real* to) {
        using Nodes = Pack<Real, 4>;
        for (int i = 0; i < count; i += 4) Nodes::load(from + i).store(to + i);
    }

    /// Weights of particles with one stencil, and their products over all axes but the first; slopes as
    /// above.
    struct Reader {
        Axes<Lanes> weight, slope;
        std::array<Lanes, rows> product;                       ///< of weights
        std::array<std::array<Lanes, rows>, D> slope_product;  ///< with the slopes of axis a

        void multiply() {
            for (int row = 0; row < rows; ++row) product[row] = row_product(weight, weight, 0, row);
            multiply_slopes();
        }
        void multiply_slopes() {
            for (int a = 1; a < D; ++a)
                for (int row = 0; row < rows; ++row)
                    slope_product[a][row] = row_product(weight, slope, a, row);
        }
    };

    /// sum_i S_i f_i; `nodes`: the component at the stencil's first node.
    static Lanes interpolate(const Reader& to, const Real* nodes) {
        Lanes value(0);
#pragma GCC unroll 16
        for (int row = 0; row < rows; ++row) {
            const Real* const first = nodes + row_place(row);
            Lanes along = to.weight[0][0] * Lanes(first[0]);
            for (int x = 1; x < W; ++x) along = multiply_add(to.weight[0][x], Lanes(first[x]), along);
            value = multiply_add(to.product[row], along, value);
        }
        return value;
    }

    /// The same, and sum_i f_i (S_i with the slopes of axis a) for each axis.
    static Lanes differentiate(const Reader& to, const Real* nodes, LaneVector& gradient) {
        Lanes value(0);
        for (int a = 0; a < D; ++a) gradient[a] = Lanes(0);
#pragma GCC unroll 16
        for (int row = 0; row < rows; ++row) {
            const Real* const first = nodes + row_place(row);
            Lanes along = to.weight[0][0] * Lanes(first[0]), slope = to.slope[0][0] * Lanes(first[0]);
            for (int x = 1; x < W; ++x) {
                along = multiply_add(to.weight[0][x], Lanes(first[x]), along);
                slope = multiply_add(to.slope[0][x], Lanes(first[x]), slope);
            }
            value = multiply_add(to.product[row], along, value);
            gradient[0] = multiply_add(to.product[row], slope, gradient[0]);
            for (int a = 1; a < D; ++a)
                gradient[a] = multiply_add(to.slope_product[a][row], along, gradient[a]);
        }
        return value;
    }
};

}  // namespace matpoint
