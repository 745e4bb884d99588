#include "step/level_borders.hpp"

#include <algorithm>
#include <stdexcept>

namespace matpoint {

namespace {

/// Whether a node of a finer level follows, where particles reach it.
template <class S>
bool follows(const Levels<S>& levels, const Patch<S>& patch, const typename Patch<S>::Coordinates& node) {
    return patch.inside(node) && !levels.free(patch.level(), node) && levels.reached(patch.level(), node);
}

/// Visits the block of a node and those around it.
template <class S, class Visit>
void for_neighbours(const Patch<S>& patch, const typename Patch<S>::Coordinates& node, const Visit& visit) {
    constexpr int count = S::dimension == 1 ? 3 : S::dimension == 2 ? 9 : 27;
    for (int k = 0; k < count; ++k) {
        typename Patch<S>::Coordinates block;
        bool exists = true;
        for (std::size_t a = 0, rest = static_cast<std::size_t>(k); a < S::dimension; ++a, rest /= 3) {
            block[a] = Patch<S>::block_of(node[a]) + static_cast<int>(rest % 3) - 1;
            exists = exists && block[a] >= 0 && block[a] < patch.blocks()[a];
        }
        if (exists) visit(patch.block_number(block));
    }
}

}  // namespace

template <class S>
void LevelBorders<S>::add_parents(const Levels<S>& levels, std::span<std::vector<int>> blocks) {
    using Coordinates = typename Patch<S>::Coordinates;
    const std::size_t layers = blocks.size() / static_cast<std::size_t>(levels.count());
    for (std::size_t k = blocks.size(); k-- > layers;) {
        const int level = static_cast<int>(k / layers);
        const Patch<S>&patch = levels.patch(level), &coarser = levels.patch(level - 1);
        std::vector<int>& parents = blocks[k - layers];
        for (const int number : blocks[k]) {
            const Coordinates block = patch.block_coordinates(number);
            for (int local = 0; local < Patch<S>::block_nodes; ++local) {
                Coordinates node;
                for (std::size_t a = 0, rest = static_cast<std::size_t>(local); a < S::dimension; ++a) {
                    constexpr int edge = Patch<S>::block_edge;
                    node[a] = block[a] * edge + static_cast<int>(rest % edge) - 1;
                    rest /= edge;
                }
                if (!follows(levels, patch, node)) continue;
                for (const auto& parent : levels.parents(level, node)) {
                    Coordinates own = parent.node;
                    for (int& along : own) along = Patch<S>::block_of(along);
                    const int found = coarser.block_number(own);
                    if (parents.empty() || parents.back() != found) parents.push_back(found);
                }
            }
        }
        std::ranges::sort(parents);
        const auto [first, last] = std::ranges::unique(parents);
        parents.erase(first, last);
    }
}

template <class S>
void LevelBorders<S>::locate(const Levels<S>& levels, std::span<Patch<S>* const> layers) {
    if (levels.count() == 1) return;
    const Patch<S>& all = *layers.front();
    const auto layers_of_level = layers.size() / static_cast<std::size_t>(levels.count());
    followers_of_.assign(static_cast<std::size_t>(levels.count()), {});
    parents_.clear();
    ways_.clear();
    blocks_of_.assign(followers_of_.size(), {});
    followers_.assign(static_cast<std::size_t>(all.node_count()), 0);
    parents_at_.assign(followers_.size(), {0, 0});
    left_.assign(followers_.size(), 1);
    for (int i = 0; i < static_cast<int>(all.node_count()); ++i) {
        const std::size_t layer = all.layer_of(i);
        const Patch<S>& patch = *layers[layer];
        const auto node = patch.node_coordinates(i);
        if (!patch.inside(node)) continue;
        left_[static_cast<std::size_t>(i)] = static_cast<float>(levels.left_of(patch.level(), node));
        if (patch.level() == 0 || !follows(levels, patch, node)) continue;
        Follower follower{i, static_cast<int>(parents_.size()), 0};
        for (const auto& parent : levels.parents(patch.level(), node)) {
            const int place = layers[layer - layers_of_level]->node_index(parent.node);
            if (place < 0) throw std::logic_error("a node of a finer level lacks a parent");
            parents_.push_back({place, static_cast<Real>(parent.weight)});
            ways_.push_back((all.position_at(place) - all.position_at(i)).template cast<Real>());
        }
        follower.end = static_cast<int>(parents_.size());
        followers_of_[static_cast<std::size_t>(patch.level())].push_back(follower);
        auto& blocks = blocks_of_[static_cast<std::size_t>(patch.level())];
        for_neighbours(patch, node, [&](int block) {
            if (blocks.empty() || blocks.back() != block) blocks.push_back(block);
        });
        followers_[static_cast<std::size_t>(i)] = 1;
        parents_at_[static_cast<std::size_t>(i)] = {follower.begin, follower.end};
    }
    for (std::vector<int>& blocks : blocks_of_) {
        std::ranges::sort(blocks);
        blocks.erase(std::ranges::unique(blocks).begin(), blocks.end());
    }
}

template <class S>
void LevelBorders<S>::extend(Patch<S>& patch, NodeField momentum, int level, int axis) const {
    for (int c = 0; c < S::dimension; ++c) {
        const Real* const along = patch.column(NodeField::affine_momentum, c);
        Real* const values = patch.column(momentum, c);
        for (const Follower& own : followers_of_[static_cast<std::size_t>(level)])
            for (int k = own.begin; k < own.end; ++k) {
                const auto place = static_cast<std::size_t>(k);
                values[parents_[place].node] += parents_[place].weight * along[own.node] * ways_[place][axis];
            }
    }
}

template <class S>
void LevelBorders<S>::fold(Patch<S>& patch, NodeField field, int level) const {
    for (int c = 0; c < Patch<S>::components(field); ++c) {
        Real* const values = patch.column(field, c);
        for (const Follower& own : followers_of_[static_cast<std::size_t>(level)]) {
            const Real value = std::exchange(values[own.node], Real(0));
            for (int k = own.begin; k < own.end; ++k) {
                const NodePart<Real>& parent = parents_[static_cast<std::size_t>(k)];
                values[parent.node] += parent.weight * value;
            }
        }
    }
}

template <class S>
void LevelBorders<S>::fill(Patch<S>& patch, NodeField field, int level) const {
    for (int c = 0; c < Patch<S>::components(field); ++c) {
        Real* const values = patch.column(field, c);
        for (const Follower& own : followers_of_[static_cast<std::size_t>(level)]) {
            Real value = 0;
            for (int k = own.begin; k < own.end; ++k) {
                const NodePart<Real>& parent = parents_[static_cast<std::size_t>(k)];
                value += parent.weight * values[parent.node];
            }
            values[own.node] = value;
        }
    }
}

#define MATPOINT_INSTANTIATE(S) template class LevelBorders<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
