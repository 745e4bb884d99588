#include "step/ordering.hpp"

#include <matpoint/parallel.hpp>

#include "step/splitting.hpp"

#include <algorithm>
#include <numeric>

namespace matpoint {

namespace {
constexpr Index chunk = 4096;  // particles handled per task and per call of base_nodes
}

template <class S>
std::vector<Stray> Ordering<S>::strays(const Patch<S>& patch, const std::vector<Particles<S>>& bodies) const {
    const Bounds<S> room = domain(patch);
    std::vector<Stray> found;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Index n = bodies[b].size();
        std::vector<std::vector<Stray>> by_chunk(static_cast<std::size_t>((n + chunk - 1) / chunk));
        parallel_for(static_cast<Index>(by_chunk.size()), n, [&](Index k) {
            const Index end = std::min(n, (k + 1) * chunk);
            for (int a = 0; a < S::dimension; ++a) {
                const auto* x = bodies[b].column(Field::position, a);
                const auto low = room.low[a], high = room.high[a];
                for (Index p = k * chunk; p < end; ++p)
                    if (!(x[p] >= low && x[p] <= high))
                        by_chunk[static_cast<std::size_t>(k)].push_back({b, p});
            }
        });
        for (const auto& part : by_chunk) found.insert(found.end(), part.begin(), part.end());
    }
    const auto less = [](const Stray& a, const Stray& b) {
        return a.body != b.body ? a.body < b.body : a.particle < b.particle;
    };
    std::sort(found.begin(), found.end(), less);
    found.erase(std::unique(found.begin(), found.end(),
                            [](const Stray& a, const Stray& b) {
                                return a.body == b.body && a.particle == b.particle;
                            }),
                found.end());
    return found;
}

template <class S>
bool Ordering<S>::update(const Levels<S>& levels, std::vector<Particles<S>>& bodies,
                         const ShapeFunction<S>& shape) {
    bool sorted = false;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Index covered = ranges_[b].empty() ? 0 : ranges_[b].back().end;
        if (covered == bodies[b].size() && !strayed(levels, bodies[b], b, shape)) continue;
        if (!sorted) levels.patch(0).set_blocks({});
        sort(levels, bodies[b], ranges_[b], shape);
        colour(levels, b);
        measure(bodies[b], b);
        sorted = true;
    }
    return sorted;
}

template <class S>
bool Ordering<S>::strayed(const Levels<S>& levels, const Particles<S>& particles, std::size_t body,
                          const ShapeFunction<S>& shape) const {
    for (std::size_t r = 0; r < ranges_[body].size(); ++r) {
        const Patch<S>& patch = levels.patch(ranges_[body][r].level);
        const Bounds<S>& bounds = bounds_[body][r];
        const auto block = patch.block_coordinates(ranges_[body][r].block);
        const auto base_of = [&](const typename S::Position& x) {
            return guarded(shape, "base_node", [&] { return shape.base_node(patch, particles, x); });
        };
        const auto low = base_of(lowest_position<S>(bounds.low));
        const auto high = base_of(highest_position<S>(bounds.high));
        for (std::size_t a = 0; a < S::dimension; ++a) {
            // Cells counted from the block's first, which stores node 4 block - 1.
            const int first = Patch<S>::block_edge * block[a] - 1;
            if (low[a] - first < -1 || high[a] - first > Patch<S>::block_edge) return true;
        }
        if (levels.count() > 1 && strayed_to_other_level(levels, particles, body, r)) return true;
    }
    return false;
}

template <class S>
bool Ordering<S>::strayed_to_other_level(const Levels<S>& levels, const Particles<S>& particles,
                                         std::size_t body, std::size_t range) const {
    const BlockRange& own = ranges_[body][range];
    const Bounds<S>& bounds = bounds_[body][range];
    if (levels.may_all_be(own.level, lowest_position<S>(bounds.low), highest_position<S>(bounds.high)))
        return false;
    for (Index p = own.begin; p < own.end; ++p)
        if (!levels.may_be(own.level, particles.position(p))) return true;
    return false;
}

template <class S>
void Ordering<S>::measure(const Particles<S>& particles, std::size_t body) {
    const Ranges& ranges = ranges_[body];
    bounds_[body].resize(ranges.size());
    parallel_for(static_cast<Index>(ranges.size()), particles.size(), [&](Index r) {
        const BlockRange& range = ranges[static_cast<std::size_t>(r)];
        for (int a = 0; a < S::dimension; ++a) {
            const auto* x = particles.column(Field::position, a);
            const auto [low, high] = std::minmax_element(x + range.begin, x + range.end);
            bounds_[body][static_cast<std::size_t>(r)].low[a] = *low;
            bounds_[body][static_cast<std::size_t>(r)].high[a] = *high;
        }
    });
}

template <class S>
void Ordering<S>::sort(const Levels<S>& levels, Particles<S>& particles, Ranges& ranges,
                       const ShapeFunction<S>& shape) {
    if (levels.count() > 1) split_arrived(levels, particles);
    const Column sorted = order(levels, particles, ranges, shape);
    particles.permute({sorted[0], static_cast<std::size_t>(sorted.size())});
}

/// By counting: the particles of each block, then of each cell in it, in their present order.
template <class S>
typename Ordering<S>::Column Ordering<S>::order(const Levels<S>& levels, const Particles<S>& particles,
                                                Ranges& ranges, const ShapeFunction<S>& shape) const {
    constexpr int nodes = Patch<S>::block_nodes;
    const Index n = particles.size();
    const auto count = static_cast<std::size_t>(n);
    Column blocks, order;
    blocks.resize(1, n);
    order.resize(1, n);
    std::uint32_t* const block = blocks[0];
    std::vector<unsigned char> cell(count);
    parallel_for((n + chunk - 1) / chunk, n, [&](Index k) {
        const Index stop = std::min(n, (k + 1) * chunk);
        std::vector<typename Patch<S>::Coordinates> base(static_cast<std::size_t>(stop - k * chunk));
        const auto level_at = [&](Index p) {
            return levels.count() > 1 ? levels.at(particles.position(p)) : 0;
        };
        for (Index begin = k * chunk, end; begin < stop; begin = end) {
            const int level = level_at(begin);
            end = levels.count() > 1 ? begin + 1 : stop;
            while (end < stop && level_at(end) == level) ++end;
            const Patch<S>& patch = levels.patch(level);
            guarded(shape, "base_nodes",
                    [&] { shape.base_nodes(patch, particles, begin, end, base.data()); });
            for (Index p = begin; p < end; ++p) {
                const auto& node = base[static_cast<std::size_t>(p - begin)];
                typename Patch<S>::Coordinates own;
                int local = 0;
                for (std::size_t a = S::dimension; a-- > 0;) {
                    own[a] = Patch<S>::block_of(node[a]);
                    local = local * Patch<S>::block_edge + ((node[a] + 1) & (Patch<S>::block_edge - 1));
                }
                block[p] = static_cast<std::uint32_t>(levels.number_of(level, patch.block_number(own)));
                cell[static_cast<std::size_t>(p)] = static_cast<unsigned char>(local);
            }
        }
    });

    std::vector<std::uint32_t> present;
    for (std::size_t p = 0; p < count; ++p)
        if (p == 0 || block[p] != block[p - 1]) present.push_back(block[p]);
    std::sort(present.begin(), present.end());
    present.erase(std::unique(present.begin(), present.end()), present.end());
    const auto bin = [&](std::size_t p, std::size_t& rank) {
        if (present[rank] != block[p])  // rarely: neighbours mostly share a block
            rank = static_cast<std::size_t>(std::lower_bound(present.begin(), present.end(), block[p]) -
                                            present.begin());
        return rank * nodes + cell[p];
    };

    std::vector<std::uint32_t> next(present.size() * nodes + 1, 0);
    for (std::size_t p = 0, rank = 0; p < count; ++p) ++next[bin(p, rank) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    ranges.clear();
    for (std::size_t r = 0; r < present.size(); ++r)
        ranges.push_back({levels.block_of(static_cast<int>(present[r])), next[r * nodes],
                          next[(r + 1) * nodes], levels.level_of(static_cast<int>(present[r]))});
    for (std::size_t p = 0, rank = 0; p < count; ++p)
        order[0][next[bin(p, rank)]++] = static_cast<std::uint32_t>(p);
    return order;
}

template <class S>
void Ordering<S>::colour(const Levels<S>& levels, std::size_t body) {
    // A stencil may reach a block on either side, so equal colours are three blocks apart, or of different
    // levels.
    constexpr std::size_t count = S::dimension == 1 ? 3 : S::dimension == 2 ? 9 : 27;
    colours_[body].assign(count, {});
    for (std::size_t r = 0; r < ranges_[body].size(); ++r) {
        const BlockRange& own = ranges_[body][r];
        const auto block = levels.patch(own.level).block_coordinates(own.block);
        std::size_t number = 0;
        for (std::size_t a = S::dimension; a-- > 0;)
            number = number * 3 + static_cast<std::size_t>(block[a] % 3);
        colours_[body][number].push_back(static_cast<Index>(r));
    }
}

template <class S>
void Ordering<S>::restore(const Levels<S>& levels, const std::vector<Particles<S>>& bodies, std::size_t body,
                          Ranges ranges) {
    ranges_[body] = std::move(ranges);
    colour(levels, body);
    measure(bodies[body], body);
}

template <class S>
std::vector<int> Ordering<S>::blocks(const Patch<S>& patch, std::span<const std::size_t> bodies) const {
    using Coordinates = typename Patch<S>::Coordinates;
    std::vector<int> numbers;
    for (const std::size_t body : bodies)
        for (const BlockRange& range : ranges_[body]) {
            if (range.level != patch.level()) continue;
            const Coordinates block = patch.block_coordinates(range.block);
            constexpr int neighbours = S::dimension == 1 ? 3 : S::dimension == 2 ? 9 : 27;
            for (int k = 0; k < neighbours; ++k) {
                Coordinates neighbour = block;
                bool exists = true;
                for (int a = 0, rest = k; a < S::dimension; ++a, rest /= 3) {
                    const auto i = static_cast<std::size_t>(a);
                    neighbour[i] += rest % 3 - 1;
                    exists = exists && neighbour[i] >= 0 && neighbour[i] < patch.blocks()[i];
                }
                if (exists) numbers.push_back(patch.block_number(neighbour));
            }
        }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

#define MATPOINT_INSTANTIATE(S) template class Ordering<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
