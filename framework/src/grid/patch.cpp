#include <matpoint/grid.hpp>
#include <matpoint/parallel.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

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
                                                                 "resampled_velocity",
                                                                 "affine_momentum"};
    return names[static_cast<std::size_t>(field)];
}

template <class S>
Patch<S>::Patch(const std::array<double, 3>& min, const std::array<double, 3>& cell_size,
                const Coordinates& cells)
    : nodes_(std::make_shared<Nodes>()) {
    lattice_.cells = cells;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        lattice_.min[i] = min[a];
        lattice_.cell_size[i] = cell_size[a];
        lattice_.inverse_cell_size[i] = 1 / cell_size[a];
    }
    set_blocks_of(lattice_);
    nodes_->first_column.fill(-1);
    table_.resize(2);
    for (const NodeField field :
         {NodeField::mass, NodeField::velocity, NodeField::force, NodeField::acceleration})
        require(field);
}

template <class S>
void Patch<S>::set_blocks_of(Lattice& lattice) {
    double count = 1;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        lattice.blocks[a] = block_of(lattice.cells[a] + 1) + 1;
        count *= lattice.blocks[a];
    }
    if (count > std::numeric_limits<int>::max())
        throw std::invalid_argument("the grid has too many cells to be numbered: at most " +
                                    std::to_string(std::numeric_limits<int>::max()) + " blocks of " +
                                    std::to_string(block_nodes) + " nodes");
}

template <class S>
Patch<S> Patch<S>::refined(bool centred) const {
    Patch finer = layer();
    Lattice& own = finer.lattice_;
    ++own.level;
    own.centred = centred;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        const int cells = lattice_.cells[a] + (lattice_.centred ? 1 : 0);
        own.cells[a] = 2 * cells - (centred ? 1 : 0);
        own.cell_size[i] = lattice_.cell_size[i] / 2;
        own.inverse_cell_size[i] = 2 * lattice_.inverse_cell_size[i];
        const double face = lattice_.min[i] - (lattice_.centred ? lattice_.cell_size[i] / 2 : 0);
        own.min[i] = face + (centred ? own.cell_size[i] / 2 : 0);
    }
    set_blocks_of(own);
    return finer;
}

template <class S>
void Patch<S>::require(NodeField field) {
    int& first = nodes_->first_column[static_cast<std::size_t>(field)];
    if (first >= 0) return;
    first = nodes_->column_count;
    nodes_->column_count += components(field);
    nodes_->columns.resize(nodes_->column_count, nodes_->columns.size());
}

template <class S>
Patch<S> Patch<S>::layer() const {
    Patch other(*this);
    other.set_table({}, {});
    return other;
}

template <class S>
void Patch<S>::set_blocks(const std::vector<int>& numbers) {
    Patch* const self = this;
    set_blocks({&self, 1}, {&numbers, 1});
}

template <class S>
void Patch<S>::set_blocks(std::span<Patch* const> layers, std::span<const std::vector<int>> numbers) {
    std::vector<std::tuple<int, int, std::size_t>> all;  // of a block, its layers one after the other
    nodes_->lattices.clear();
    for (std::size_t k = 0; k < layers.size(); ++k) {
        nodes_->lattices.push_back(layers[k]->lattice_);
        for (const int number : numbers[k]) all.emplace_back(layers[k]->level(), number, k);
    }
    if (layers.size() > 1) std::sort(all.begin(), all.end());
    std::vector<std::vector<int>> slots(layers.size());
    nodes_->blocks.clear();
    nodes_->layers.clear();
    for (const auto& [level, number, k] : all) {
        slots[k].push_back(static_cast<int>(nodes_->blocks.size()));
        nodes_->blocks.push_back(number);
        nodes_->layers.push_back(static_cast<std::uint32_t>(k));
    }
    set_table({}, {});
    for (std::size_t k = 0; k < layers.size(); ++k) layers[k]->set_table(numbers[k], slots[k]);
    nodes_->columns.resize(0, 0);
    nodes_->columns.resize(nodes_->column_count, node_count());
}

template <class S>
void Patch<S>::set_table(const std::vector<int>& numbers, const std::vector<int>& slots) {
    existing_ = numbers;
    table_bits_ = static_cast<int>(std::bit_width(2 * existing_.size() + 1));
    table_.assign(std::size_t{1} << table_bits_, {});
    for (std::size_t k = 0; k < existing_.size(); ++k) {
        std::uint32_t i = first_place(existing_[k]);
        while (table_[i & (table_.size() - 1)].number >= 0) ++i;
        table_[i & (table_.size() - 1)] = {existing_[k], slots[k]};
    }
}

template <class S>
typename Patch<S>::Coordinates Patch<S>::node_coordinates(int index) const {
    Coordinates node = nodes_->lattices[layer_of(index)].block(
        nodes_->blocks[static_cast<std::size_t>(index / block_nodes)]);
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
    const Index items = components(field) * static_cast<Index>(nodes_->blocks.size());
    parallel_for((node_count() + chunk - 1) / chunk, items, [&](Index k) {
        for (int c = 0; c < components(field); ++c) {
            Real* const values = column(field, c);
            std::fill(values + k * chunk, values + std::min(node_count(), (k + 1) * chunk), Real(0));
        }
    });
}

template <class S>
std::size_t Patch<S>::bytes() const {
    return nodes_->columns.bytes() + table_bytes();
}

#define MATPOINT_INSTANTIATE(S) template class Patch<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
