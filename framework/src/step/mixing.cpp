#include "step/mixing.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <numeric>
#include <vector>

namespace matpoint {

namespace {

/// Sorting pays when there are this many times as many runs of particles with the same cell as there are
/// cells.
constexpr double most_runs_per_cell = 1.5;
constexpr Index sample = 32;

template <class S>
class BlockCells {
  public:
    /// Cells along an axis that a particle of the block's range may be in: the block's, and one on either
    /// side.
    static constexpr int edge = Patch<S>::block_edge + 2;
    static constexpr int count = S::dimension == 1   ? edge
                                 : S::dimension == 2 ? edge * edge
                                                     : edge * edge * edge;

    BlockCells(const Patch<S>& patch, const Particles<S>& particles, const ShapeFunction<S>& shape, int block)
        : patch_(patch), particles_(particles), shape_(shape), block_(patch.block_coordinates(block)) {}

    /// The cells of particles [begin, end).
    void find(Index begin, Index end, unsigned char* cells) const {
        std::array<typename Patch<S>::Coordinates, sample> bases;
        for (; begin < end; begin += sample) {
            const Index stop = std::min(begin + sample, end);
            shape_.base_nodes(patch_, particles_, begin, stop, bases.data());
            for (Index p = begin; p < stop; ++p)
                *cells++ = number(bases[static_cast<std::size_t>(p - begin)]);
        }
    }

  private:
    unsigned char number(const typename Patch<S>::Coordinates& base) const {
        int number = 0;
        for (std::size_t a = S::dimension; a-- > 0;)
            // The block's first cell begins at node `block_edge` times its coordinate, less the ghost.
            number = number * edge + std::clamp(base[a] + 2 - Patch<S>::block_edge * block_[a], 0, edge - 1);
        return static_cast<unsigned char>(number);
    }

    const Patch<S>& patch_;
    const Particles<S>& particles_;
    const ShapeFunction<S>& shape_;
    typename Patch<S>::Coordinates block_;
};

template <class S>
bool mixed(const BlockCells<S>& block, const BlockRange& range) {
    std::array<unsigned char, sample> cells;
    const Index count = std::min(sample, range.end - range.begin);
    const Index begin = range.begin + (range.end - range.begin - count) / 2;
    block.find(begin, begin + count, cells.data());
    std::bitset<BlockCells<S>::count> present;
    int runs = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        present.set(cells[i]);
        runs += i == 0 || cells[i] != cells[i - 1];
    }
    return runs > most_runs_per_cell * static_cast<double>(present.count());
}

/// What puts particles of one cell together, and cells in ascending order. Those that are in their cell's
/// part already stay: a few of them have changed cells since the last time.
const std::vector<Exchange>& exchanges(const std::vector<unsigned char>& cells, int count) {
    std::array<std::uint32_t, 257> begin{};
    for (const unsigned char cell : cells) ++begin[cell + 1U];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    auto next = begin;  // places of a cell from here on may hold particles of others
    thread_local std::vector<Exchange> moves;
    moves.clear();
    for (std::size_t cell = 0; cell < static_cast<std::size_t>(count); ++cell)
        for (std::uint32_t p = begin[cell]; p < begin[cell + 1]; ++p) {
            const unsigned char own = cells[p];
            if (own == cell) continue;
            while (cells[next[own]] == own) ++next[own];
            moves.push_back({p, next[own]++});
        }
    return moves;
}

}  // namespace

template <class S>
void sort_if_mixed(const Patch<S>& patch, Particles<S>& particles, const BlockRange& range,
                   const ShapeFunction<S>& shape) {
    const BlockCells<S> block(patch, particles, shape, range.block);
    if (!mixed(block, range)) return;

    const auto count = static_cast<std::size_t>(range.end - range.begin);
    thread_local std::vector<unsigned char> cells;
    cells.resize(count);
    block.find(range.begin, range.end, cells.data());
    particles.exchange(range.begin, exchanges(cells, BlockCells<S>::count));
}

#define MATPOINT_INSTANTIATE(S) \
    template void sort_if_mixed(const Patch<S>&, Particles<S>&, const BlockRange&, const ShapeFunction<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
