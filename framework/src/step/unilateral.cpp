#include "step/unilateral.hpp"

#include <matpoint/domain_box.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace matpoint {

namespace {

/// Quadratic B-spline of the three nodes nearest to a place, in cells; `first` is the first of them.
struct EdgeWeights {
    int first;
    std::array<double, 3> weights;

    explicit EdgeWeights(double place) {
        const double middle = std::round(place), d = place - middle;
        first = static_cast<int>(middle) - 1;
        weights = {0.5 * (0.5 - d) * (0.5 - d), 0.75 - d * d, 0.5 * (0.5 + d) * (0.5 + d)};
    }
};

}  // namespace

template <class S>
UnilateralFaces<S>::UnilateralFaces(const std::vector<PlacedCondition<S>>& conditions) {
    for (int axis = 0; axis < S::dimension; ++axis)
        for (int side = 0; side < 2; ++side)
            for (std::size_t k = 0; k < conditions.size(); ++k)
                if (const auto friction = friction_of(conditions[k]);
                    friction && holds_on(conditions[k], axis, side))
                    faces_.push_back({axis, side, k, static_cast<Real>(*friction)});
}

template <class S>
void UnilateralFaces<S>::locate(std::span<Patch<S>* const> layers, const std::vector<char>& inside,
                                const std::vector<unsigned char>& prescribed) {
    prescribed_ = &prescribed;
    const Patch<S>& all = *layers.front();
    for (Face& face : faces_) {
        const auto axis = static_cast<std::size_t>(face.axis);
        face.nodes.clear();
        face.places.assign(static_cast<std::size_t>(all.node_count()), -1);
        for (int index = 0; index < static_cast<int>(all.node_count()); ++index) {
            if (inside[static_cast<std::size_t>(index)] == 0) continue;
            const Patch<S>& patch = *layers[all.layer_of(index)];
            if (all.node_coordinates(index)[axis] != (face.side == 0 ? 0 : patch.cells()[axis])) continue;
            face.places[static_cast<std::size_t>(index)] = static_cast<int>(face.nodes.size());
            face.nodes.push_back({.index = index, .cell = patch.cell_size()[face.axis]});
        }
    }
}

template <class S>
void UnilateralFaces<S>::measure(std::span<Patch<S>* const> nodes, const std::vector<Particles<S>>& bodies,
                                 Ordering<S>& ordering, double dt) {
    constexpr double reach = 2;  // cells, in which a particle may be whose edge is within one
    for (Face& face : faces_) {
        for (Node& node : face.nodes)
            node = {.index = node.index, .cell = node.cell, .least = std::numeric_limits<double>::infinity()};
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const Patch<S>& patch = *nodes[k];
            const double h = patch.cell_size()[face.axis];
            const auto distance = [&](double x) {
                return face.side == 0 ? x - face.place(patch) : face.place(patch) - x;
            };
            const std::size_t b = k % bodies.size();
            const auto& ranges = ordering.ranges(b);
            const auto& bounds = ordering.bounds(b);
            for (std::size_t r = 0; r < ranges.size(); ++r) {
                const auto& edge = face.side == 0 ? bounds[r].low : bounds[r].high;
                if (distance(static_cast<double>(edge[face.axis])) > reach * h) continue;
                for (Index p = ranges[r].begin; p < ranges[r].end; ++p) {
                    const double x = distance(bodies[b].value(Field::position, face.axis, p)) / h;
                    if (x < reach) add(patch, bodies[b], p, x, face);
                }
            }
        }
        for (Node& node : face.nodes) {
            node.near = node.volume > 0;
            if (!node.near) continue;
            const double gap = std::max((3 * node.moment / node.volume - 1) / 2, node.least);
            node.slowest = static_cast<Real>(-std::max(gap, 0.0) * node.cell / dt);
        }
    }
}

/// Adds a particle whose middle is x cells from the face.
template <class S>
void UnilateralFaces<S>::add(const Patch<S>& patch, const Particles<S>& particles, Index p, double x,
                             Face& face) const {
    const double half = domain_half_size(particles, p, face.axis) / patch.cell_size()[face.axis];
    const double near = x - half, far = std::min(x + half, 1.0);
    if (!(near < far)) return;
    // Means of 1 - x and (1 - x) x over what of the particle is within the cell.
    const double middle = (near + far) / 2, reach = (far - near) / 2;
    const double volume = static_cast<double>(particles.column(Field::volume)[p]) * reach / half;
    const double weight = volume * (1 - middle),
                 moment = volume * (middle - middle * middle - reach * reach / 3);

    typename Patch<S>::Coordinates node{};
    node[static_cast<std::size_t>(face.axis)] =
        face.side == 0 ? 0 : patch.cells()[static_cast<std::size_t>(face.axis)];
    const auto visit = [&](const auto& self, int axis, double share) -> void {
        if (axis == face.axis) return self(self, axis + 1, share);
        if (axis == S::dimension) {
            const int index = patch.node_index(node);
            const int place = index < 0 ? -1 : face.places[static_cast<std::size_t>(index)];
            if (place < 0 || share == 0) return;
            Node& own = face.nodes[static_cast<std::size_t>(place)];
            own.volume += share * weight;
            own.moment += share * moment;
            own.least = std::min(own.least, near);
            return;
        }
        const EdgeWeights spline((particles.value(Field::position, axis, p) - patch.min()[axis]) *
                                 patch.inverse_cell_size()[axis]);
        for (int k = 0; k < 3; ++k) {
            node[static_cast<std::size_t>(axis)] = spline.first + k;
            self(self, axis + 1, share * spline.weights[static_cast<std::size_t>(k)]);
        }
    };
    visit(visit, 0, 1);
}

template <class S>
void UnilateralFaces<S>::solve(Patch<S>& patch, NodeField field, Vector Node::*change) {
    const Real* const mass = patch.column(NodeField::mass);
    for (Face& face : faces_)
        for (Node& node : face.nodes) {
            (node.*change).setZero();
            node.sticks = false;
            if (!holds(face, node) || !(mass[node.index] > 0)) continue;
            Real& v = patch.column(field, face.axis)[node.index];
            const Real missing = node.slowest - face.inwards() * v;
            if (!(missing > 0)) continue;
            (node.*change)[face.axis] = face.inwards() * missing;
            v = face.inwards() * node.slowest;
        }
    for (Face& face : faces_)
        for (Node& node : face.nodes) {
            const Real most = face.friction * std::abs((node.*change)[face.axis]);
            if (!(most > 0)) continue;
            Vector along = Vector::Zero();
            for (int c = 0; c < S::dimension; ++c)
                if (c != face.axis && !prescribed(node.index, c))
                    along[c] = patch.column(field, c)[node.index];
            const Real speed = along.norm();
            node.sticks = speed <= most;
            if (!node.sticks) along *= most / speed;
            for (int c = 0; c < S::dimension; ++c) patch.column(field, c)[node.index] -= along[c];
            node.*change -= along;
        }
}

template <class S>
void UnilateralFaces<S>::push_ahead(Patch<S>& patch) {
    for (Face& face : faces_)
        for (Node& node : face.nodes)
            for (int c = 0; c < S::dimension; ++c)
                node.kept[c] = patch.column(NodeField::velocity, c)[node.index];
    solve(patch, NodeField::velocity, &Node::ahead);
    is_ahead_ = true;
}

template <class S>
void UnilateralFaces<S>::restore(Patch<S>& patch) {
    if (!is_ahead_) return;
    for (Face& face : faces_)
        for (Node& node : face.nodes)
            for (int c = 0; c < S::dimension; ++c)
                patch.column(NodeField::velocity, c)[node.index] = node.kept[c];
}

template <class S>
void UnilateralFaces<S>::push_again(Patch<S>& patch, Real dt) {
    if (!std::exchange(is_ahead_, false)) return;
    for (Face& face : faces_)
        for (Node& node : face.nodes)
            for (int c = 0; c < S::dimension; ++c)
                patch.column(NodeField::acceleration, c)[node.index] += node.ahead[c] / dt;
}

template <class S>
void UnilateralFaces<S>::push(Patch<S>& patch, Real dt) {
    solve(patch, NodeField::velocity, &Node::push);
    for (Face& face : faces_)
        for (Node& node : face.nodes)
            for (int c = 0; c < S::dimension; ++c)
                patch.column(NodeField::acceleration, c)[node.index] += node.push[c] / dt;
}

template <class S>
void UnilateralFaces<S>::hold(Patch<S>& patch, NodeField field) const {
    for (const Face& face : faces_)
        for (const Node& node : face.nodes) {
            if (!holds(face, node)) continue;
            Real& v = patch.column(field, face.axis)[node.index];
            if (face.inwards() * v < node.slowest) v = face.inwards() * node.slowest;
            for (int c = 0; c < S::dimension && node.sticks; ++c)
                if (c != face.axis && !prescribed(node.index, c)) patch.column(field, c)[node.index] = 0;
        }
}

template <class S>
double UnilateralFaces<S>::reaction(const Patch<S>& patch, Real dt,
                                    std::vector<typename Walls<S>::Sum>& sums) const {
    double nearer = 0;
    for (const Face& face : faces_) {
        auto& sum = sums[face.condition];
        for (const Node& node : face.nodes)
            for (int c = 0; c < S::dimension; ++c) {
                const auto mass = static_cast<double>(patch.column(NodeField::mass)[node.index]);
                const Real v = patch.column(NodeField::velocity, c)[node.index],
                           a = patch.column(NodeField::acceleration, c)[node.index];
                const double impulse = mass * static_cast<double>(node.ahead[c] + node.push[c]);
                sum.total[static_cast<std::size_t>(c)] += impulse;
                sum.power += impulse * static_cast<double>(v - a * dt / 2);
                nearer += mass * static_cast<double>(std::abs(a - node.push[c] / dt) - std::abs(a));
            }
    }
    return nearer;
}

#define MATPOINT_INSTANTIATE(S) template class UnilateralFaces<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
