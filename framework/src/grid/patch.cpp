#include <matpoint/grid.hpp>

#include <algorithm>
#include <stdexcept>

namespace matpoint {

std::string_view node_field_name(NodeField field) {
    constexpr std::array<std::string_view, node_fields> names = {
        "mass", "velocity", "force", "acceleration", "remapped_velocity", "external_force"};
    return names[static_cast<std::size_t>(field)];
}

template <class S>
Patch<S>::Patch(const std::array<double, 3>& min, const std::array<double, 3>& cell_size,
                const Coordinates& cells)
    : cells_(cells) {
    std::size_t count = 1;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        min_[i] = static_cast<Real>(min[a]);
        cell_size_[i] = static_cast<Real>(cell_size[a]);
        inverse_cell_size_[i] = static_cast<Real>(1 / cell_size[a]);
        blocks_[a] = block_of(cells_[a] + 1) + 1;
        count *= static_cast<std::size_t>(blocks_[a]);
    }
    slots_.assign(count, -1);
    for (const NodeField field :
         {NodeField::mass, NodeField::velocity, NodeField::force, NodeField::acceleration})
        require(field);
}

template <class S>
void Patch<S>::set_blocks(const std::vector<int>& numbers) {
    for (const int number : existing_) slots_[static_cast<std::size_t>(number)] = -1;
    existing_ = numbers;
    for (std::size_t slot = 0; slot < existing_.size(); ++slot)
        slots_[static_cast<std::size_t>(existing_[slot])] = static_cast<int>(slot);
    for (int f = 0; f < node_fields; ++f)
        if (const auto field = static_cast<NodeField>(f); has(field)) clear(field);
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
    for (int c = 0; c < components(field); ++c)
        columns_[static_cast<std::size_t>(field)][static_cast<std::size_t>(c)].assign(
            static_cast<std::size_t>(node_count()), Real(0));
}

template <class S>
std::size_t Patch<S>::bytes() const {
    std::size_t values = 0;
    for (const auto& field : columns_)
        for (const auto& column : field) values += column.capacity();
    return values * sizeof(Real) + slots_.size() * sizeof(int);
}

#define MATPOINT_INSTANTIATE(S) template class Patch<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
