#include <matpoint/grid.hpp>
#include <matpoint/parallel.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <string>

namespace matpoint {

std::string_view node_field_name(NodeField field) {
    constexpr std::array<std::string_view, node_fields> names = {"mass",
                                                                 "velocity",
                                                                 "force",
                                                                 "acceleration",
                                                                 "remapped_velocity",
                                                                 "external_force",
                                                                 "lumped_velocity",
                                                                 "resampled_momentum",
                                                                 "resampled_velocity"};
    return names[static_cast<std::size_t>(field)];
}

template <class S>
Patch<S>::Patch(const std::array<double, 3>& min, const std::array<double, 3>& cell_size,
                const Coordinates& cells)
    : cells_(cells) {
    double count = 1;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        min_[i] = min[a];
        cell_size_[i] = cell_size[a];
        inverse_cell_size_[i] = 1 / cell_size[a];
        blocks_[a] = block_of(cells_[a] + 1) + 1;
        count *= blocks_[a];
    }
    if (count > std::numeric_limits<int>::max())
        throw std::invalid_argument("the grid has too many cells to be numbered: at most " +
                                    std::to_string(std::numeric_limits<int>::max()) + " blocks of " +
                                    std::to_string(block_nodes) + " nodes");
    first_column_.fill(-1);
    table_.resize(2);
    for (const NodeField field :
         {NodeField::mass, NodeField::velocity, NodeField::force, NodeField::acceleration})
        require(field);
}

template <class S>
void Patch<S>::require(NodeField field) {
    int& first = first_column_[static_cast<std::size_t>(field)];
    if (first >= 0) return;
    first = column_count_;
    column_count_ += components(field);
    columns_.resize(column_count_, columns_.size());
}

template <class S>
void Patch<S>::set_blocks(const std::vector<int>& numbers) {
    existing_ = numbers;
    table_bits_ = static_cast<int>(std::bit_width(2 * existing_.size() + 1));
    table_.assign(std::size_t{1} << table_bits_, {});
    for (std::size_t slot = 0; slot < existing_.size(); ++slot) {
        std::uint32_t i = first_place(existing_[slot]);
        while (table_[i & (table_.size() - 1)].number >= 0) ++i;
        table_[i & (table_.size() - 1)] = {existing_[slot], static_cast<int>(slot)};
    }
    columns_.resize(0, 0);
    columns_.resize(column_count_, node_count());
}

template <class S>
typename Patch<S>::Coordinates Patch<S>::node_coordinates(int index) const {
    Coordinates node = block_coordinates(existing_[static_cast<std::size_t>(index / block_nodes)]);
    int local = index % block_nodes;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        node[a] = node[a] * block_edge + local % block_edge - 1;
        local /= block_edge;
    }
    return node;
}

template <class S>
void Patch<S>::clear(NodeField field) {
    constexpr Index chunk = 8192;
    const Index items = components(field) * static_cast<Index>(existing_.size());
    parallel_for((node_count() + chunk - 1) / chunk, items, [&](Index k) {
        for (int c = 0; c < components(field); ++c) {
            Real* const values = column(field, c);
            std::fill(values + k * chunk, values + std::min(node_count(), (k + 1) * chunk), Real(0));
        }
    });
}

template <class S>
std::size_t Patch<S>::bytes() const {
    return columns_.bytes() + table_.size() * sizeof(Entry);
}

#define MATPOINT_INSTANTIATE(S) template class Patch<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
