#include "grid/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace matpoint {

namespace {

/// Visits every point of a lattice from low to high, which is beyond the last; first axis fastest.
template <std::size_t D, class Visit>
void for_box(const std::array<int, D>& low, const std::array<int, D>& high, const Visit& visit) {
    for (std::size_t a = 0; a < D; ++a)
        if (low[a] >= high[a]) return;
    for (std::array<int, D> at = low;;) {
        visit(at);
        std::size_t a = 0;
        while (a < D && at[a] == high[a] - 1) at[a] = low[a], ++a;
        if (a == D) return;
        ++at[a];
    }
}

/// Places of a cell, per axis, of which one within a region makes the cell part of it.
constexpr int samples = 4;

}  // namespace

template <class S>
Levels<S>::Cells::Cells(const Coordinates& low, const Coordinates& high) : low_(low), high_(high) {
    std::size_t count = 1;
    for (std::size_t a = 0; a < S::dimension; ++a)
        count *= static_cast<std::size_t>(std::max(0, high_[a] - low_[a]));
    has_.resize(count);
}

template <class S>
std::size_t Levels<S>::Cells::place(const Coordinates& cell) const {
    std::size_t place = 0;
    for (std::size_t a = S::dimension; a-- > 0;)
        place = place * static_cast<std::size_t>(high_[a] - low_[a]) +
                static_cast<std::size_t>(cell[a] - low_[a]);
    return place;
}

template <class S>
bool Levels<S>::Cells::operator()(const Coordinates& cell) const {
    for (std::size_t a = 0; a < S::dimension; ++a)
        if (cell[a] < low_[a] || cell[a] >= high_[a]) return false;
    return has_[place(cell)];
}

template <class S>
void Levels<S>::Cells::add(const Coordinates& cell) {
    has_[place(cell)] = true;
}

template <class S>
bool Levels<S>::Cells::empty() const {
    return std::ranges::find(has_, true) == has_.end();
}

template <class S>
template <class Visit>
void Levels<S>::Cells::for_each(const Visit& visit) const {
    for_box(low_, high_, [&](const Coordinates& cell) {
        if (has_[place(cell)]) visit(cell);
    });
}

template <class S>
Levels<S>::Levels(Patch<S>& coarsest, std::vector<const Geometry*> regions, std::vector<double> refinement)
    : geometries_(std::move(regions)),
      refinement_(std::move(refinement)),
      patches_{&coarsest},
      first_block_{0},
      region_(geometries_.size() + 1),
      zone_(region_.size()),
      reach_(region_.size()) {
    const bool centred = refinement_.size() % 2 == 0;
    double blocks = coarsest.block_count();
    for (std::size_t k = 0; k < geometries_.size(); ++k) {
        first_block_.push_back(static_cast<int>(blocks));
        finer_.push_back(patches_.back()->refined(centred));
        patches_.push_back(&finer_.back());
        blocks += finer_.back().block_count();
        if (blocks > std::numeric_limits<int>::max())
            throw std::invalid_argument(
                fmt::format("level {} has too many cells to be numbered: take larger ones", k + 1));
    }
    place_regions(std::vector<Eigen::Vector3d>(geometries_.size(), Eigen::Vector3d::Zero()), true);
}

template <class S>
void Levels<S>::move(std::span<const Eigen::Vector3d> shifts) {
    place_regions(shifts, false);
}

template <class S>
void Levels<S>::place_regions(std::span<const Eigen::Vector3d> shifts, bool must_exist) {
    // The functions of a level end before those of the next begin, and so do the parents of its border.
    const int between = static_cast<int>(refinement_.size()) + 2;
    for (int level = count() - 1; level > 0; --level) {
        const auto l = static_cast<std::size_t>(level);
        Cells own = touched(level, *geometries_[l - 1], shifts[l - 1]);
        if (own.empty() && must_exist)
            throw std::invalid_argument(
                fmt::format("no cell of the grid is in the region of level {}", level));
        if (level + 1 < count() && !region_[l + 1].empty())
            add(own, coarsened(grown(region_[l + 1], between, level)));
        region_[l] = std::move(own);
        zone_[l] = grown(region_[l], 1, level - 1);
        reach_[l] = grown(region_[l], 2, level - 1);
        if (must_exist) expect_node(level);
    }
}

template <class S>
void Levels<S>::expect_node(int level) const {
    bool any = false;
    region_[static_cast<std::size_t>(level)].for_each([&](const Coordinates& cell) {
        Coordinates low, high;
        for (std::size_t a = 0; a < S::dimension; ++a) low[a] = 2 * cell[a] - 1, high[a] = 2 * cell[a] + 3;
        for_box(low, high, [&](const Coordinates& node) {
            any = any || (patch(level).inside(node) && free(level, node));
        });
    });
    if (!any)
        throw std::invalid_argument(
            fmt::format("the region of level {} is too thin for the shape function: it must hold {} cells of "
                        "level {} along "
                        "every axis",
                        level, refinement_.size() / 2, level - 1));
}

template <class S>
typename Levels<S>::Coordinates Levels<S>::cells_along(int level) const {
    Coordinates size = patch(level).cells();
    for (int& along : size) along += patch(level).centred() ? 1 : 0;
    return size;
}

/// Cells of the next coarser level.
template <class S>
typename Levels<S>::Cells Levels<S>::touched(int level, const Geometry& region,
                                             const Eigen::Vector3d& shift) const {
    const Coordinates size = cells_along(level - 1);
    const Geometry::Bounds bounds = region.bounds();
    const Position h = patch(level - 1).cell_size(), from = patch(0).min();
    Coordinates low, high;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        const auto cell = [&](double x) {
            return static_cast<int>(std::clamp(std::floor((x - from[i]) / h[i]), -1.0, double(size[a])));
        };
        low[a] = std::max(0, cell(bounds.min[i] + shift[i]));
        high[a] = std::min(size[a], cell(bounds.max[i] + shift[i]) + 1);
    }
    Cells cells(low, high);
    Coordinates first{}, last;
    last.fill(samples);
    std::vector<Eigen::Vector3d> places;
    for_box(low, high, [&](const Coordinates& cell) {
        places.clear();
        for_box(first, last, [&](const Coordinates& part) {
            Eigen::Vector3d x = Eigen::Vector3d::Zero();
            for (std::size_t a = 0; a < S::dimension; ++a) {
                const auto i = static_cast<Eigen::Index>(a);
                x[i] = from[i] + (cell[a] + (part[a] + 0.5) / samples) * h[i];
            }
            places.push_back(x - shift);
        });
        if (std::ranges::any_of(region.contains(places), [](char in) { return in != 0; })) cells.add(cell);
    });
    return cells;
}

/// By so many cells on every side, within the grid.
template <class S>
typename Levels<S>::Cells Levels<S>::grown(const Cells& cells, int by, int level) const {
    const Coordinates size = cells_along(level);
    const auto around = [&](const Coordinates& first, const Coordinates& beyond) {
        std::pair<Coordinates, Coordinates> box;
        for (std::size_t a = 0; a < S::dimension; ++a) {
            box.first[a] = std::max(0, first[a] - by);
            box.second[a] = std::min(size[a], beyond[a] + by);
        }
        return box;
    };
    const auto [low, high] = around(cells.low(), cells.high());
    Cells all(low, high);
    cells.for_each([&](const Coordinates& cell) {
        Coordinates next = cell;
        for (int& c : next) ++c;
        const auto [begin, end] = around(cell, next);
        for_box(begin, end, [&](const Coordinates& near) { all.add(near); });
    });
    return all;
}

/// Cells of the next coarser level that these are in.
template <class S>
typename Levels<S>::Cells Levels<S>::coarsened(const Cells& cells) {
    Coordinates low, high;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        low[a] = cells.low()[a] / 2;
        high[a] = (cells.high()[a] + 1) / 2;
    }
    Cells coarse(low, high);
    cells.for_each([&](Coordinates cell) {
        for (int& c : cell) c /= 2;
        coarse.add(cell);
    });
    return coarse;
}

template <class S>
void Levels<S>::add(Cells& to, const Cells& more) {
    Coordinates low, high;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        low[a] = std::min(to.low()[a], more.low()[a]);
        high[a] = std::max(to.high()[a], more.high()[a]);
    }
    Cells all(low, high);
    to.for_each([&](const Coordinates& cell) { all.add(cell); });
    more.for_each([&](const Coordinates& cell) { all.add(cell); });
    to = std::move(all);
}

template <class S>
typename Levels<S>::Coordinates Levels<S>::cell_at(int level, const Position& x) const {
    const Coordinates size = cells_along(level);
    Coordinates cell;
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        const double place = std::floor((x[i] - patch(0).min()[i]) * patch(level).inverse_cell_size()[i]);
        cell[a] = static_cast<int>(std::min(std::max(0.0, place), size[a] - 1.0));  // not a number: 0
    }
    return cell;
}

template <class S>
int Levels<S>::at(const Position& x) const {
    int level = count() - 1;
    while (level > 0 && !zone_[static_cast<std::size_t>(level)](cell_at(level - 1, x))) --level;
    return level;
}

/// Of the box with half a cell of the level on every side of a place.
template <class S>
bool Levels<S>::belongs(int level, const Coordinates& cell) const {
    if (level + 1 < count() && zone_[static_cast<std::size_t>(level) + 1](cell)) return false;
    if (level == 0) return true;
    Coordinates coarser = cell;
    for (int& along : coarser) along /= 2;
    return zone_[static_cast<std::size_t>(level)](coarser);
}

template <class S>
Geometry::Bounds Levels<S>::bounds(int level, Geometry::Bounds box) const {
    if (level == 0) return box;
    const Cells& zone = zone_[static_cast<std::size_t>(level)];
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        const double h = patch(level - 1).cell_size()[i], from = patch(0).min()[i];
        box.min[i] = std::max(box.min[i], from + zone.low()[a] * h);
        box.max[i] = std::min(box.max[i], from + zone.high()[a] * h);
    }
    return box;
}

template <class S>
template <class Visit>
bool Levels<S>::any_corner(int level, const Position& x, const Visit& visit) const {
    for (int corner = 0; corner < 1 << S::dimension; ++corner) {
        Position at = x;
        for (int a = 0; a < S::dimension; ++a)
            at[a] += ((corner >> a & 1) != 0 ? 0.5 : -0.5) * patch(level).cell_size()[a];
        if (visit(cell_at(level, at))) return true;
    }
    return false;
}

template <class S>
bool Levels<S>::may_be(int level, const Position& x) const {
    if (level + 1 < count()) {
        const Cells& finer = region_[static_cast<std::size_t>(level) + 1];
        if (any_corner(level, x, finer)) return false;
    }
    if (level == 0) return true;
    return any_corner(level - 1, x, zone_[static_cast<std::size_t>(level)]);
}

template <class S>
bool Levels<S>::may_all_be(int level, const Position& low, const Position& high) const {
    bool may = true;
    if (level + 1 < count()) {
        const Position half = patch(level).cell_size() / 2;
        Coordinates first = cell_at(level, low - half), last = cell_at(level, high + half);
        for (int& along : last) ++along;
        const Cells& finer = region_[static_cast<std::size_t>(level) + 1];
        for_box(first, last, [&](const Coordinates& cell) { may = may && !finer(cell); });
    }
    if (level > 0) {
        Coordinates first = cell_at(level - 1, low), last = cell_at(level - 1, high);
        for (int& along : last) ++along;
        const Cells& zone = zone_[static_cast<std::size_t>(level)];
        for_box(first, last, [&](const Coordinates& cell) { may = may && zone(cell); });
    }
    return may;
}

template <class S>
typename Levels<S>::Range Levels<S>::support(int level, int node) const {
    // Half the width of the support, (n - 1) / 2 cells, from the node, which may be centred.
    const int n = static_cast<int>(refinement_.size());
    if (!patch(level).centred()) return {node - (n - 1) / 2, node + (n - 1) / 2};
    return {node - (n - 2) / 2, node + n / 2};
}

template <class S>
bool Levels<S>::free(int level, const Coordinates& node) const {
    if (level == 0) return true;
    Coordinates low, high;
    const Coordinates size = cells_along(level);
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const Range range = support(level, node[a]);
        low[a] = std::max(0, range.low) / 2;
        high[a] = (std::min(size[a], range.high) + 1) / 2;
    }
    bool within = true;
    const Cells& region = region_[static_cast<std::size_t>(level)];
    for_box(low, high, [&](const Coordinates& cell) { within = within && region(cell); });
    return within;
}

template <class S>
bool Levels<S>::reached(int level, const Coordinates& node) const {
    if (level == 0) return true;
    Coordinates low, high;
    const Coordinates size = cells_along(level);
    for (std::size_t a = 0; a < S::dimension; ++a) {
        const Range range = support(level, node[a]);
        low[a] = std::max(0, range.low) / 2;
        high[a] = (std::min(size[a], range.high) + 1) / 2;
    }
    bool any = false;
    const Cells& reach = reach_[static_cast<std::size_t>(level)];
    for_box(low, high, [&](const Coordinates& cell) { any = any || reach(cell); });
    return any;
}

/// k = node - 2 parent + shift is the place of a line's coefficient.
template <class S>
int Levels<S>::shift(int level) const {
    const int n = static_cast<int>(refinement_.size());
    if (!patch(level).centred()) return (n - 1) / 2;
    return patch(level - 1).centred() ? n / 2 - 1 : n / 2;
}

template <class S>
std::vector<typename Levels<S>::Parent> Levels<S>::parents(int level, const Coordinates& node) const {
    const int n = static_cast<int>(refinement_.size());
    std::vector<Parent> all{{node, 1}};
    for (std::size_t a = 0; a < S::dimension; ++a) {
        std::vector<Parent> next;
        for (int k = 0; k < n; ++k) {
            const int twice = node[a] + shift(level) - k;
            if ((twice & 1) != 0) continue;
            for (Parent parent : all) {
                parent.node[a] = twice >> 1;
                parent.weight *= refinement_[static_cast<std::size_t>(k)];
                next.push_back(parent);
            }
        }
        all = std::move(next);
    }
    return all;
}

/// The node within the grid's faces whose image one beyond them is.
template <class S>
int Levels<S>::mirrored(int level, std::size_t axis, int node) const {
    const Patch<S>& own = patch(level);
    const int last = own.cells()[axis], centred = own.centred() ? 1 : 0;
    if (node < 0) return -node - centred;
    return node > last ? 2 * last - node + centred : node;
}

template <class S>
double Levels<S>::left_of(int level, const Coordinates& node) const {
    if (level + 1 == count()) return 1;
    const int n = static_cast<int>(refinement_.size());
    double taken = 0;
    Coordinates first{}, last;
    last.fill(n);
    for_box(first, last, [&](const Coordinates& k) {
        Coordinates child;
        double weight = 1;
        for (std::size_t a = 0; a < S::dimension; ++a) {
            child[a] = mirrored(level + 1, a, 2 * node[a] - shift(level + 1) + k[a]);
            weight *= refinement_[static_cast<std::size_t>(k[a])] / 2;
        }
        if (free(level + 1, child)) taken += weight;
    });
    return 1 - taken;
}

template <class S>
long Levels<S>::cells(int level) const {
    long count = 0;
    if (level == 0) {
        count = 1;
        for (const int along : cells_along(0)) count *= along;
    } else {
        region_[static_cast<std::size_t>(level)].for_each(
            [&](const Coordinates&) { count += 1 << S::dimension; });
    }
    if (level + 1 < this->count())
        region_[static_cast<std::size_t>(level) + 1].for_each([&](const Coordinates&) { --count; });
    return count;
}

template <class S>
long Levels<S>::cells_with_border(int level) const {
    long count = 0;
    zone_[static_cast<std::size_t>(level)].for_each([&](const Coordinates&) { count += 1 << S::dimension; });
    return count;
}

template <class S>
int Levels<S>::level_of(int number) const {
    const auto beyond = std::ranges::upper_bound(first_block_, number);
    return static_cast<int>(beyond - first_block_.begin()) - 1;
}

#define MATPOINT_INSTANTIATE(S) template class Levels<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
