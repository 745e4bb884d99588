#pragma once

#include <matpoint/particles.hpp>
#include <matpoint/registry.hpp>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace matpoint {

/// Node fields. Those after acceleration exist only if the integrator, a load or the transfer asks.
enum class NodeField {
    mass,                ///< kg
    velocity,            ///< momentum while it is being summed, then velocity, m/s
    force,               ///< internal force, then the sum of all forces, N
    acceleration,        ///< m/s^2
    remapped_velocity,   ///< velocity projected anew from the updated particles, m/s
    external_force,      ///< N
    lumped_velocity,     ///< momentum over mass, of which a transfer of higher order makes the velocity, m/s
    resampled_momentum,  ///< of particles that move with the nodes, kg m/s
    resampled_velocity,  ///< that over mass, m/s
    affine_momentum,     ///< sum S m A along an axis, at borders of levels, kg/s
};
inline constexpr int node_fields = static_cast<int>(NodeField::affine_momentum) + 1;
std::string_view node_field_name(NodeField field);

/// A rectangular lattice of cells whose nodes exist only in blocks near particles.
///
/// Nodes have lattice coordinates from 0 to cells, and one layer of ghosts at -1 and cells + 1 that
/// holds what stencils write past the grid's faces (the kernel folds it back).
///
/// Bodies in contact have velocity fields of their own: layers of one patch. A layer is a patch too, with
/// its own table of blocks onto the columns that it shares with all others: a block that k layers reach has k
/// places there. Loops over places of nodes see those of all layers; what asks for a node by its coordinates
/// asks the layer of a body.
///
/// Levels of a grid are layers too, on lattices of their own: refined() has cells of half the size. Their
/// nodes are those of the lattice, or the middles of its cells.
template <class S>
class Patch {
  public:
    using Real = typename S::Real;
    using Position = typename S::Position;
    using Coordinates = std::array<int, S::dimension>;
    /// Nodes along a block's edge, a power of two; a block has 64 nodes in every dimension.
    static constexpr int block_shift = S::dimension == 1 ? 6 : S::dimension == 2 ? 3 : 2;
    static constexpr int block_edge = 1 << block_shift;
    static constexpr int block_nodes = 64;

    /// `min`: lower corner, m; `cell_size` h per axis, m; `cells` per axis.
    Patch(const std::array<double, 3>& min, const std::array<double, 3>& cell_size, const Coordinates& cells);
    Patch(Patch&&) noexcept = default;
    Patch& operator=(Patch&&) noexcept = default;

    /// A patch that covers the same with cells of half the size, without blocks yet. `centred`: with nodes at
    /// the middles of those cells, half a cell from the grid's faces.
    Patch refined(bool centred) const;
    /// How often this one was refined.
    int level() const { return lattice_.level; }
    bool centred() const { return lattice_.centred; }

    /// Place of node 0.
    const Position& min() const { return lattice_.min; }
    const Position& cell_size() const { return lattice_.cell_size; }
    const Position& inverse_cell_size() const { return lattice_.inverse_cell_size; }
    /// Distances of nodes per axis: cells, one less if they are centred.
    const Coordinates& cells() const { return lattice_.cells; }
    Position node_position(const Coordinates& node) const { return lattice_.position(node); }

    /// Blocks per axis (ghosts included), and the number of a block in the full lattice of blocks.
    const Coordinates& blocks() const { return lattice_.blocks; }
    /// Of the full lattice.
    int block_count() const {
        int count = 1;
        for (const int along : lattice_.blocks) count *= along;
        return count;
    }
    static int block_of(int node) { return (node + 1) >> block_shift; }
    int block_number(const Coordinates& block) const {
        int number = 0;
        for (int a = S::dimension - 1; a >= 0; --a)
            number =
                number * lattice_.blocks[static_cast<std::size_t>(a)] + block[static_cast<std::size_t>(a)];
        return number;
    }
    Coordinates block_coordinates(int number) const { return lattice_.block(number); }

    /// Place of a node in the columns; -1 if its block does not exist.
    int node_index(const Coordinates& node) const {
        int number = 0, local = 0;
        for (int a = S::dimension - 1; a >= 0; --a) {
            const int stored = node[static_cast<std::size_t>(a)] + 1;
            number = number * lattice_.blocks[static_cast<std::size_t>(a)] + (stored >> block_shift);
            local = local * block_edge + (stored & (block_edge - 1));
        }
        const int slot = slot_of(number);
        return slot < 0 ? -1 : slot * block_nodes + local;
    }
    /// Place of a block's first node in the columns. The block must exist.
    Index block_place(const Coordinates& block) const {
        return Index{slot_of(block_number(block))} * block_nodes;
    }
    /// Makes exactly these blocks exist (numbers, ascending), all fields zero.
    void set_blocks(const std::vector<int>& numbers);
    const std::vector<int>& existing_blocks() const { return existing_; }
    /// Numbers of the blocks at all places, those of other layers included.
    const std::vector<int>& blocks_by_place() const { return nodes_->blocks; }
    /// Lattice coordinates, in its layer, of the node at a place in the columns (ghosts and padding
    /// included).
    Coordinates node_coordinates(int index) const;
    /// m
    Position position_at(int index) const {
        return nodes_->lattices[layer_of(index)].position(node_coordinates(index));
    }
    /// Whether a node is on or within the grid's faces (not a ghost or padding).
    bool inside(const Coordinates& node) const {
        for (std::size_t a = 0; a < S::dimension; ++a)
            if (node[a] < 0 || node[a] > lattice_.cells[a]) return false;
        return true;
    }

    /// A further layer, without blocks yet.
    Patch layer() const;
    /// Makes exactly these blocks exist, for each of the layers; all fields zero. This patch has no blocks
    /// of its own then, only places.
    void set_blocks(std::span<Patch* const> layers, std::span<const std::vector<int>> numbers);
    /// Which of those layers the node at a place belongs to.
    std::size_t layer_of(int index) const {
        return nodes_->layers[static_cast<std::size_t>(index / block_nodes)];
    }

    /// Asks for a field (before blocks exist).
    void require(NodeField field);
    bool has(NodeField field) const { return nodes_->first_column[static_cast<std::size_t>(field)] >= 0; }
    static constexpr int components(NodeField field) { return field == NodeField::mass ? 1 : S::dimension; }
    /// Of all layers.
    Index node_count() const { return static_cast<Index>(nodes_->blocks.size()) * block_nodes; }
    Real* column(NodeField field, int component = 0) { return nodes_->columns[place(field, component)]; }
    const Real* column(NodeField field, int component = 0) const {
        return nodes_->columns[place(field, component)];
    }
    void clear(NodeField field);
    /// Of all columns and this layer's table.
    std::size_t bytes() const;
    std::size_t table_bytes() const { return table_.size() * sizeof(Entry); }

  private:
    struct Lattice {
        Position min, cell_size, inverse_cell_size;
        Coordinates cells, blocks;
        int level = 0;
        bool centred = false;

        Position position(const Coordinates& node) const {
            Position x;
            for (int a = 0; a < S::dimension; ++a)
                x[a] = min[a] + node[static_cast<std::size_t>(a)] * cell_size[a];
            return x;
        }
        Coordinates block(int number) const {
            Coordinates block{};
            for (std::size_t a = 0; a < S::dimension; ++a) {
                block[a] = number % blocks[a];
                number /= blocks[a];
            }
            return block;
        }
    };
    /// What layers share.
    struct Nodes {
        std::array<int, node_fields> first_column;  ///< -1: nobody asked for the field
        int column_count = 0;
        Columns<Real> columns;
        std::vector<int> blocks;            ///< numbers, by their places
        std::vector<std::uint32_t> layers;  ///< by their places
        std::vector<Lattice> lattices;      ///< by layer
    };

    Patch(const Patch&) = default;
    std::size_t place(NodeField field, int component) const {
        const int place = nodes_->first_column[static_cast<std::size_t>(field)] + component;
        return static_cast<std::size_t>(place);
    }
    /// Makes the table of these blocks at these places (of blocks).
    void set_table(const std::vector<int>& numbers, const std::vector<int>& slots);

    /// Place of a block among the existing ones, -1 if it is not; from a hash table, so that the lattice may
    /// be as large as one likes.
    int slot_of(int number) const {
        for (std::uint32_t i = first_place(number);; ++i) {
            const Entry& entry = table_[i & (table_.size() - 1)];
            if (entry.number == number) return entry.slot;
            if (entry.number < 0) return -1;
        }
    }
    std::uint32_t first_place(int number) const {
        return (static_cast<std::uint32_t>(number) * 0x9e3779b1u) >> (32 - table_bits_);
    }

    struct Entry {
        int number = -1, slot = -1;
    };

    /// Counts the blocks of a lattice. Throws std::invalid_argument if there are too many.
    static void set_blocks_of(Lattice& lattice);

    Lattice lattice_;
    std::vector<int> existing_;
    std::vector<Entry> table_;
    int table_bits_ = 1;
    std::shared_ptr<Nodes> nodes_;
};

class Geometry;

/// Where cells of a grid are half as large as those of the next coarser level.
struct Refined {
    const Geometry* within;
    std::string follow{};  ///< the body or tool whose motion it goes with; empty: it stays
};

/// What a node that doesn't move by itself has of another one.
template <class Real>
struct NodePart {
    int node;
    Real weight;
};

/// A background grid: a patch, and where finer levels of it are.
template <class S>
class Grid : public Component {
  public:
    virtual Patch<S>& patch() = 0;
    /// Levels finer than the patch, each within the one before.
    virtual std::vector<Refined> refined() const { return {}; }
};

}  // namespace matpoint
