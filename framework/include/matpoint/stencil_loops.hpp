#pragma once

#include <matpoint/pack.hpp>

#include <algorithm>
#include <array>

namespace matpoint {

/// Sums between packs of particles that share a stencil of Width^Dimension nodes and these nodes.
/// Weights are products over the axes, so a row of nodes along the first axis shares the product of
/// all others.
template <class Real, int Dimension, int Width>
struct StencilLoops {
    static constexpr int D = Dimension, W = Width;
    static constexpr int rows = D == 1 ? 1 : D == 2 ? W : W * W;
    static constexpr int N = rows * W;

    using Lanes = Pack<Real>;
    using LaneVector = std::array<Lanes, D>;
    using LaneMatrix = std::array<LaneVector, D>;
    /// One number for each node along each axis.
    template <class T>
    using Axes = std::array<std::array<T, W>, D>;
    /// Columns of C components of the nodes.
    template <int C>
    using Columns = std::array<Real*, C>;
    /// A vector at each node of a stencil, by component.
    using Nodal = std::array<std::array<Real, N>, D>;

    struct Weights {
        Axes<Lanes> value, derivative;  ///< derivatives in 1/m
        LaneVector s;                   ///< position in cells from the stencil's first node
    };

    /// Product of a row's weights over all axes but the first, with those of axis b from `slopes`.
    template <class T>
    static T row_product(const Axes<T>& weights, const Axes<T>& slopes, int b, int row) {
        T product(1);
        for (int a = 1; a < D; ++a, row /= W) product *= (a == b ? slopes : weights)[a][row % W];
        return product;
    }

    /// Sums for C components at the nodes of a stencil, one share a lane.
    template <int C>
    struct NodeSums {
        static constexpr int size = (C * N + Lanes::lanes - 1) / Lanes::lanes * Lanes::lanes;
        std::array<Lanes, size> lanes;

        NodeSums() { std::fill(lanes.begin() + C * N, lanes.end(), Lanes(0)); }
        void add_to(const Columns<C>& columns, const int* nodes) const {
            std::array<Real, size> sums;
            for (int j = 0; j < size; j += Lanes::lanes) Lanes::sums(&lanes[j]).store(&sums[j]);
            for (int i = 0; i < N; ++i)
                for (int c = 0; c < C; ++c) columns[c][nodes[i]] += sums[c * N + i];
        }
    };

    /// column_c at node i += sum_p S_ip value_c.
    template <int C>
    static void add_values(const Weights* weights, const std::array<Lanes, C>* values, int packs,
                           const int* nodes, const Columns<C>& columns) {
        NodeSums<C> node_sums;
        for (int row = 0; row < rows; ++row) {
            Lanes sums[C][W];
            for (int c = 0; c < C; ++c)
                for (int i = 0; i < W; ++i) sums[c][i] = Lanes(0);
            for (int k = 0; k < packs; ++k) {
                const Axes<Lanes>& weight = weights[k].value;
                const Lanes product = row_product(weight, weight, 0, row);
                for (int c = 0; c < C; ++c) {
                    const Lanes value = product * values[k][c];
                    for (int i = 0; i < W; ++i) sums[c][i] += weight[0][i] * value;
                }
            }
            for (int c = 0; c < C; ++c)
                for (int i = 0; i < W; ++i) node_sums.lanes[c * N + row * W + i] = sums[c][i];
        }
        node_sums.add_to(columns, nodes);
    }

    /// column_c at node i += sum_p sum_a G_a matrix_ca, where G_a is S_ip with `slopes` for the weights
    /// of axis a: grad S if they are derivatives, S (x_i - x_p) if they are moments.
    template <class Slopes>
    static void add_gradients(const Weights* weights, const Slopes& slopes, const LaneMatrix* matrix,
                              int packs, const int* nodes, const Columns<D>& columns) {
        NodeSums<D> node_sums;
        for (int row = 0; row < rows; ++row) {
            Lanes sums[D][W];
            for (int c = 0; c < D; ++c)
                for (int i = 0; i < W; ++i) sums[c][i] = Lanes(0);
            for (int k = 0; k < packs; ++k) {
                const Axes<Lanes>&weight = weights[k].value, &slope = slopes(k);
                LaneVector product;
                for (int a = 0; a < D; ++a) product[a] = row_product(weight, slope, a, row);
                for (int c = 0; c < D; ++c) {
                    const Lanes along = product[0] * matrix[k][c][0];
                    Lanes across(0);
                    for (int a = 1; a < D; ++a) across += product[a] * matrix[k][c][a];
                    for (int i = 0; i < W; ++i) {
                        sums[c][i] += slope[0][i] * along;
                        sums[c][i] += weight[0][i] * across;
                    }
                }
            }
            for (int c = 0; c < D; ++c)
                for (int i = 0; i < W; ++i) node_sums.lanes[c * N + row * W + i] = sums[c][i];
        }
        node_sums.add_to(columns, nodes);
    }

    /// sum_i S_ip f_i.
    static LaneVector interpolate(const Axes<Lanes>& weights, const Nodal& f) {
        LaneVector value;
        for (int c = 0; c < D; ++c) value[c] = Lanes(0);
        for (int row = 0; row < rows; ++row) {
            const Lanes product = row_product(weights, weights, 0, row);
            for (int c = 0; c < D; ++c) {
                Lanes along(0);
                for (int i = 0; i < W; ++i) along += weights[0][i] * Lanes(f[c][row * W + i]);
                value[c] += product * along;
            }
        }
        return value;
    }

    /// [c][a]: sum_i f_c G_a, with G_a as in add_gradients; and sum_i S_ip f_i.
    static LaneMatrix differentiate(const Axes<Lanes>& weights, const Axes<Lanes>& slopes, const Nodal& f,
                                    LaneVector& value) {
        LaneMatrix gradient;
        for (int c = 0; c < D; ++c) {
            value[c] = Lanes(0);
            for (int a = 0; a < D; ++a) gradient[c][a] = Lanes(0);
        }
        for (int row = 0; row < rows; ++row) {
            LaneVector product;
            for (int a = 0; a < D; ++a) product[a] = row_product(weights, slopes, a, row);
            for (int c = 0; c < D; ++c) {
                Lanes along(0), slope(0);
                for (int i = 0; i < W; ++i) {
                    along += weights[0][i] * Lanes(f[c][row * W + i]);
                    slope += slopes[0][i] * Lanes(f[c][row * W + i]);
                }
                value[c] += product[0] * along;
                gradient[c][0] += product[0] * slope;
                for (int a = 1; a < D; ++a) gradient[c][a] += product[a] * along;
            }
        }
        return gradient;
    }
};

}  // namespace matpoint
