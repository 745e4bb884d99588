#include "contact/meeting_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace matpoint {

namespace {
/// Shares of a node's mass below which a layer is not there: rounding. Densities may be 1e6 of each other.
constexpr double least_share = 1e-12;
/// Cells.
constexpr double largest_half_size = 2;
/// Nodes along an axis that a domain may reach.
constexpr int most_nodes = 9;
}  // namespace

template <class S>
MeetingNodes<S>::MeetingNodes(const Patch<S>& patch, const ShapeFunction<S>& shape)
    : spline_(spline_degree(patch, shape)) {}

template <class S>
void MeetingNodes<S>::locate(std::span<Patch<S>* const> layers, std::span<const std::size_t> layer,
                             std::vector<ParticlesOfBlock> particles) {
    const Patch<S>& patch = *layers.front();
    const int levels = layers.back()->level() + 1;
    layers_.assign(layers.begin(), layers.end());
    layers_of_level_ = layers.size() / static_cast<std::size_t>(levels);
    layer_.assign(layer.begin(), layer.end());
    blocks_.clear();
    entries_.clear();
    near_.clear();
    share_at_.assign(static_cast<std::size_t>(patch.node_count()), -1);
    const std::vector<int>& numbers = patch.blocks_by_place();
    const auto level_at = [&](std::size_t place) {
        return layers[patch.layer_of(static_cast<int>(place) * Patch<S>::block_nodes)]->level();
    };
    for (std::size_t begin = 0; begin < numbers.size();) {
        const int level = level_at(begin);
        std::size_t end = begin + 1;
        while (end < numbers.size() && numbers[end] == numbers[begin] && level_at(end) == level) ++end;
        if (end > begin + 1) {
            blocks_.push_back({level, numbers[begin], entries_.size(), entries_.size() + (end - begin)});
            for (std::size_t k = begin; k < end; ++k) {
                const int first = static_cast<int>(k) * Patch<S>::block_nodes;
                entries_.push_back({patch.layer_of(first) % layers_of_level_, first});
            }
        }
        begin = end;
    }
    for (const ParticlesOfBlock& own : particles)
        for (int level = 0; level < levels; ++level) {
            Near near{own, level, shared_in(around(own, level), level)};
            if (!near.blocks.empty()) near_.push_back(std::move(near));
        }
}

template <class S>
auto MeetingNodes<S>::around(const ParticlesOfBlock& particles, int level) const -> Box {
    const Patch<S>&from = layer_of(particles.level, 0), &to = layer_of(level, 0);
    const Coordinates block = from.block_coordinates(particles.block);
    Box box;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto axis = static_cast<Eigen::Index>(a);
        int low = block[a] - 1, high = block[a] + 1;
        if (level != particles.level) {
            // The particles are in the block or a cell beside it, and as far as domains and splines reach.
            const double reach = 4 * std::max(from.cell_size()[axis], to.cell_size()[axis]);
            const auto block_at = [&](int node, double beyond) {
                const double x = from.min()[axis] + node * from.cell_size()[axis] + beyond - to.min()[axis];
                return Patch<S>::block_of(static_cast<int>(std::floor(x * to.inverse_cell_size()[axis])));
            };
            low = block_at(block[a] * Patch<S>::block_edge - 1, -reach);
            high = block_at((block[a] + 1) * Patch<S>::block_edge, reach);
        }
        box.low[a] = std::max(low, 0);
        box.high[a] = std::min(high, to.blocks()[a] - 1);
    }
    return box;
}

template <class S>
std::vector<std::size_t> MeetingNodes<S>::shared_in(const Box& box, int level) const {
    std::vector<std::size_t> found;
    for (std::size_t a = 0; a < S::dimension; ++a)
        if (box.low[a] > box.high[a]) return found;
    const Patch<S>& patch = layer_of(level, 0);
    for (Coordinates block = box.low;;) {
        const std::pair wanted(level, patch.block_number(block));
        const auto key = [](const Block& own) { return std::pair(own.level, own.number); };
        const auto shared = std::ranges::lower_bound(blocks_, wanted, {}, key);
        if (shared != blocks_.end() && key(*shared) == wanted)
            found.push_back(static_cast<std::size_t>(shared - blocks_.begin()));
        std::size_t a = 0;
        while (a < S::dimension && block[a] == box.high[a]) block[a] = box.low[a], ++a;
        if (a == S::dimension) return found;
        ++block[a];
    }
}

template <class S>
void MeetingNodes<S>::find(std::span<const Particles<S>> bodies, const std::vector<char>& inside,
                           const std::array<std::array<bool, 2>, 3>& walls, bool neighbours) {
    const Patch<S>& patch = *layers_.front();
    for (const Share& share : shares_) share_at_[static_cast<std::size_t>(share.place)] = -1;
    walls_ = walls;
    lists_neighbours_ = neighbours;
    nodes_.clear();
    shares_.clear();
    unsorted_.clear();
    of_share_.clear();
    const auto* const mass = patch.column(NodeField::mass);
    boxes_.assign(blocks_.size(), {});
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        boxes_[b].low.fill(1);
        boxes_[b].high.fill(0);
        for (int local = 0; local < Patch<S>::block_nodes; ++local) {
            const std::size_t first = shares_.size();
            double whole = 0;
            for (std::size_t e = blocks_[b].begin; e < blocks_[b].end; ++e)
                whole += static_cast<double>(mass[entries_[e].first + local]);
            if (!(whole > 0) || !inside[static_cast<std::size_t>(entries_[blocks_[b].begin].first + local)])
                continue;
            for (std::size_t e = blocks_[b].begin; e < blocks_[b].end; ++e) {
                const int place = entries_[e].first + local;
                const auto own = static_cast<double>(mass[place]);
                if (own > least_share * whole)
                    shares_.push_back({.place = place, .layer = entries_[e].layer, .mass = own});
            }
            if (shares_.size() < first + 2) {
                shares_.resize(first);
                continue;
            }
            nodes_.push_back({first, shares_.size(), blocks_[b].level});
            for (std::size_t k = first; k < shares_.size(); ++k)
                share_at_[static_cast<std::size_t>(shares_[k].place)] = static_cast<int>(k);
            const Coordinates node = patch.node_coordinates(shares_[first].place);
            Box& box = boxes_[b];
            if (box.empty()) box = {node, node};
            for (std::size_t a = 0; a < S::dimension; ++a) {
                box.low[a] = std::min(box.low[a], node[a]);
                box.high[a] = std::max(box.high[a], node[a]);
            }
        }
    }
    if (nodes_.empty()) return;
    for (const Near& near : near_) {
        Box box;
        box.low.fill(1);
        box.high.fill(0);
        for (const std::size_t b : near.blocks) {
            const Box& own = boxes_[b];
            if (own.empty()) continue;
            if (box.empty()) box = own;
            for (std::size_t a = 0; a < S::dimension; ++a) {
                box.low[a] = std::min(box.low[a], own.low[a]);
                box.high[a] = std::max(box.high[a], own.high[a]);
            }
        }
        if (!box.empty()) measure(near, box, bodies[near.particles.body]);
    }
    if (lists_neighbours_) sort_neighbours();
}

template <class S>
void MeetingNodes<S>::measure(const Near& near, const Box& box, const Particles<S>& particles) {
    const Patch<S>& patch = layer_of(near.level, layer_[near.particles.body]);
    const double reach = spline_.reach() + largest_half_size;
    for (Index p = near.particles.begin; p < near.particles.end; ++p) {
        const Vector centre = (particles.position(p) - patch.min()).cwiseProduct(patch.inverse_cell_size());
        bool reaches = true;
        for (int a = 0; a < S::dimension; ++a) {
            const auto axis = static_cast<std::size_t>(a);
            reaches = reaches && centre[a] > box.low[axis] - reach && centre[a] < box.high[axis] + reach;
        }
        if (!reaches) continue;
        visit_images(
            patch, DomainBox<S>(patch, particles, p), 2 * spline_.reach(),
            [&](int axis, int side) {
                return walls_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(side)];
            },
            [&](const DomainBox<S>& own) { add(patch, box, own); });
    }
}

template <class S>
void MeetingNodes<S>::add(const Patch<S>& layer, const Box& box, const DomainBox<S>& own) {
    struct Weights {
        std::array<double, most_nodes> mass, moment;
    };
    std::array<Weights, S::dimension> weights;
    Coordinates low, high;
    for (int a = 0; a < S::dimension; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        const double reach = spline_.reach() + own.half_size[a];
        low[axis] = std::max(static_cast<int>(std::ceil(own.centre[a] - reach)), box.low[axis]);
        high[axis] = std::min({static_cast<int>(std::floor(own.centre[a] + reach)), box.high[axis],
                               low[axis] + most_nodes - 1});
        if (low[axis] > high[axis]) return;
    }
    hits_.clear();
    for (Coordinates node = low;;) {
        const int place = layer.node_index(node);
        const int found = place < 0 ? -1 : share_at_[static_cast<std::size_t>(place)];
        if (found >= 0) hits_.push_back({node, static_cast<std::size_t>(found)});
        std::size_t a = 0;
        while (a < S::dimension && node[a] == high[a]) node[a] = low[a], ++a;
        if (a == S::dimension) break;
        ++node[a];
    }
    if (hits_.empty()) return;

    for (int a = 0; a < S::dimension; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        for (int i = low[axis]; i <= high[axis]; ++i) {
            const double begin = own.centre[a] - own.half_size[a] - i, end = begin + 2 * own.half_size[a];
            const auto k = static_cast<std::size_t>(i - low[axis]);
            const double share = 1 / (2 * own.half_size[a]);
            const Spline::Values from = spline_.at(begin), to = spline_.at(end);
            weights[axis].mass[k] = share * (to.mass - from.mass);
            weights[axis].moment[k] = share * (to.moment - from.moment);
        }
    }
    const double volume = own.volume * layer.inverse_cell_size().prod();
    for (const Hit& hit : hits_) {
        Share& share = shares_[hit.share];
        const auto number = [&](std::size_t a) { return static_cast<std::size_t>(hit.node[a] - low[a]); };
        double mass = volume;
        for (std::size_t a = 0; a < S::dimension; ++a) mass *= weights[a].mass[number(a)];
        share.size += mass;
        for (std::size_t b = 0; b < S::dimension; ++b) {
            double moment = volume;
            for (std::size_t a = 0; a < S::dimension; ++a)
                moment *= a == b ? weights[a].moment[number(a)] : weights[a].mass[number(a)];
            const auto axis = static_cast<Eigen::Index>(b);
            share.moment[axis] += moment * layer.cell_size()[axis];
        }
        if (!lists_neighbours_) continue;
        Vector from;
        for (int a = 0; a < S::dimension; ++a)
            from[a] = own.centre[a] - hit.node[static_cast<std::size_t>(a)];
        unsorted_.push_back({from.cwiseProduct(layer.cell_size()),
                             own.half_size.cwiseProduct(layer.cell_size()), own.volume});
        of_share_.push_back(hit.share);
    }
}

template <class S>
void MeetingNodes<S>::sort_neighbours() {
    first_neighbour_.assign(shares_.size() + 1, 0);
    for (const std::size_t share : of_share_) ++first_neighbour_[share + 1];
    std::partial_sum(first_neighbour_.begin(), first_neighbour_.end(), first_neighbour_.begin());
    std::vector<std::size_t> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
    neighbours_.resize(unsorted_.size());
    for (std::size_t k = 0; k < unsorted_.size(); ++k) neighbours_[next[of_share_[k]]++] = unsorted_[k];
}

#define MATPOINT_INSTANTIATE(S) template class MeetingNodes<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
