#pragma once

#include "particles/cell_lattice.hpp"
#include "particles/filling.hpp"
#include "particles/line_rule.hpp"

#include <array>
#include <functional>
#include <vector>

namespace matpoint {

/// What a place's particle stands for.
enum class Seeding {
    filled,   ///< all of the region in the place's part of its cell
    centres,  ///< the whole part, if its middle is in the region
};

/// Whether a cell of the grid is to be filled; none: all are.
using Wanted = std::function<bool(const CellLattice::Place& cell)>;

/// The places of a lattice that get a particle, in the lattice's order: those whose middle a region contains.
/// If `filled`, a particle stands for what the region fills of its place's part of the cell. What it fills of
/// the parts of other places is given to the nearest of the neighbours that have one, so that no matter is
/// lost and none becomes a particle of next to no mass; where there is no such neighbour, as in a body
/// thinner than the distance of places, the place gets a particle nevertheless.
///
/// Of parts that are whole, a bit is kept; fillings are kept of the others only.
class FilledPlaces {
  public:
    FilledPlaces(CellLattice lattice, const Geometry& region, Seeding seeding, Wanted wanted = {});

    Index size() const { return begins_.back(); }
    Index pieces() const { return lattice_.pieces(); }
    /// Number of a piece's first particle.
    Index begin(Index piece) const { return begins_[static_cast<std::size_t>(piece)]; }
    /// Calls `take` with middle and edges of each particle's box, and its length, area or volume.
    template <class Take>
    void for_each(Index piece, const Take& take) const;

  private:
    using Place = CellLattice::Place;
    struct Part {
        Index number;  ///< of the place
        Filling filling;
        bool particle;
    };

    struct Gift {
        Index from;
        std::vector<Index> to;
    };
    using LineRules = std::array<LineRule, 3>;

    void take_whole(Index piece, const Geometry& region);
    void fill(const Geometry& region);
    std::vector<Part> fill_piece(Index piece, const Geometry& region, const LineRules& rules);
    void give_to_neighbours();
    std::vector<Index> receivers(const Part& part) const;
    void make_parts(const std::vector<Gift>& gifts);
    bool is_whole(Index number) const;
    std::size_t first_part(Index number) const;
    void count();

    bool is_wanted(const Place& place) const { return !wanted_ || wanted_(lattice_.cell(place)); }

    CellLattice lattice_;
    Wanted wanted_;
    std::vector<std::vector<bool>> whole_;  ///< by piece; empty if nothing is
    std::vector<Part> parts_;               ///< by number
    std::vector<Index> begins_;             ///< by piece, number of its first particle; then that of all
};

template <class Take>
void FilledPlaces::for_each(Index piece, const Take& take) const {
    if (begin(piece + 1) == begin(piece)) return;
    const std::vector<bool>& whole = whole_[static_cast<std::size_t>(piece)];
    std::size_t part = first_part(lattice_.begin(piece)), i = 0;
    lattice_.for_each(piece, [&](const Eigen::Vector3d& middle) {
        const Index number = lattice_.begin(piece) + static_cast<Index>(i);
        if (!whole.empty() && whole[i]) take(middle, lattice_.edges(), lattice_.area());
        ++i;
        if (part == parts_.size() || parts_[part].number != number) return;
        const Filling& filling = parts_[part++].filling;
        take(middle + filling.centroid().cwiseProduct(lattice_.edges()),
             filling.edges(lattice_.dimension()).cwiseProduct(lattice_.edges()),
             filling.volume * lattice_.area());
    });
}

}  // namespace matpoint
