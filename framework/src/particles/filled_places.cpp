#include "particles/filled_places.hpp"

#include <matpoint/parallel.hpp>

#include "particles/filled_line.hpp"
#include "particles/line_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace matpoint {

namespace {

/// Lines that are asked for at a time, about.
constexpr std::size_t lines_at_a_time = 65536;

/// What rounding of coordinates along an axis leaves between equal ones.
double resolution(const std::vector<double>& planes) {
    return 4 * std::numeric_limits<double>::epsilon() *
           std::max(std::abs(planes.front()), std::abs(planes.back()));
}

/// Parts of a place's edge with four lines each. The smaller the body, the more, so that the sum over its
/// lines is as exact: to 1e-3 of the volume or better.
int rule_parts(const CellLattice& lattice) {
    if (lattice.dimension() == 1) return 1;
    const double places = double(lattice.size(1)) * lattice.size(2);
    return lattice.dimension() == 2 ? static_cast<int>(std::clamp(4096 / places, 2.0, 64.0))
                                    : static_cast<int>(std::clamp(std::sqrt(8192 / places), 1.0, 8.0));
}

}  // namespace

FilledPlaces::FilledPlaces(CellLattice lattice, const Geometry& region, Seeding seeding, Wanted wanted)
    : lattice_(std::move(lattice)),
      wanted_(std::move(wanted)),
      whole_(static_cast<std::size_t>(lattice_.pieces())) {
    if (seeding == Seeding::centres) {
        parallel_for(pieces(), lattice_.size(), [&](Index piece) { take_whole(piece, region); });
    } else if (lattice_.size() > 0) {
        fill(region);
        give_to_neighbours();
    }
    count();
}

void FilledPlaces::take_whole(Index piece, const Geometry& region) {
    std::vector<char> inside = region.contains(lattice_.middles(piece));
    for (std::size_t i = 0; wanted_ && i < inside.size(); ++i)
        if (!is_wanted(lattice_.place(lattice_.begin(piece) + static_cast<Index>(i)))) inside[i] = 0;
    if (std::ranges::any_of(inside, [](char in) { return in != 0; }))
        whole_[static_cast<std::size_t>(piece)].assign(inside.begin(), inside.end());
}

void FilledPlaces::fill(const Geometry& region) {
    LineRules rules;
    for (int a = 1; a < lattice_.dimension(); ++a) {
        const std::vector<double> planes = lattice_.planes(a);
        rules[static_cast<std::size_t>(a)] =
            LineRule(planes, region.breaks(a), resolution(planes), rule_parts(lattice_));
    }
    std::vector<std::vector<Part>> parts(whole_.size());
    parallel_for(pieces(), lattice_.size(), [&](Index piece) {
        std::vector<Part>& own = parts[static_cast<std::size_t>(piece)];
        own = fill_piece(piece, region, rules);
        std::vector<Eigen::Vector3d> middles;
        for (const Part& part : own) middles.push_back(lattice_.middle(lattice_.place(part.number)));
        const std::vector<char> inside = region.contains(middles);
        for (std::size_t i = 0; i < own.size(); ++i) own[i].particle = inside[i] != 0;
    });
    for (const std::vector<Part>& own : parts) parts_.insert(parts_.end(), own.begin(), own.end());
}

std::vector<FilledPlaces::Part> FilledPlaces::fill_piece(Index piece, const Geometry& region,
                                                         const LineRules& rules) {
    const std::vector<double> planes = lattice_.planes(0);
    const Index begin = lattice_.begin(piece);
    std::vector<bool> whole(static_cast<std::size_t>(lattice_.begin(piece + 1) - begin));
    std::vector<Part> parts;
    FilledLine along(planes, resolution(planes));
    const std::vector<Place> all = lattice_.lines(piece);
    for (auto first = all.begin(), last = first; first != all.end(); first = last) {
        std::vector<Eigen::Vector2d> lines;
        for (; last != all.end() && lines.size() < lines_at_a_time; ++last)
            for (const LineRule::Point& z : rules[2].points((*last)[2]))
                for (const LineRule::Point& y : rules[1].points((*last)[1]))
                    lines.emplace_back(y.coordinate, z.coordinate);
        const std::vector<Intervals> sections =
            region.along_x(lines, {planes.front(), planes.back()}, lattice_.edges()[0] / 4);
        auto section = sections.begin();
        for (auto line = first; line != last; ++line) {
            along.clear();
            for (const LineRule::Point& z : rules[2].points((*line)[2]))
                for (const LineRule::Point& y : rules[1].points((*line)[1])) along.add(*section++, y, z);
            const std::vector<Filling>& fillings = along.fill();
            Place place = *line;
            for (; place[0] < lattice_.size(0); ++place[0]) {
                const auto i = static_cast<std::size_t>(place[0]);
                const Index number = lattice_.number(place);
                if (!is_wanted(place)) continue;
                if (along.is_whole(i))
                    whole[static_cast<std::size_t>(number - begin)] = true;
                else if (fillings[i].volume > 0)
                    parts.push_back({number, fillings[i], false});
            }
        }
    }
    std::ranges::sort(parts, {}, &Part::number);
    if (std::ranges::find(whole, true) != whole.end())
        whole_[static_cast<std::size_t>(piece)] = std::move(whole);
    return parts;
}

void FilledPlaces::give_to_neighbours() {
    std::vector<std::size_t> givers;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        if (!parts_[i].particle) givers.push_back(i);
    // Smaller ones first, which may give to larger ones.
    std::ranges::stable_sort(givers, {}, [&](std::size_t i) { return parts_[i].filling.volume; });
    std::vector<Gift> gifts(givers.size());
    const auto count = static_cast<Index>(givers.size());
    parallel_for(count, count, [&](Index i) {
        const Part& part = parts_[givers[static_cast<std::size_t>(i)]];
        gifts[static_cast<std::size_t>(i)] = {part.number, receivers(part)};
    });
    std::erase_if(gifts, [](const Gift& gift) { return gift.to.empty(); });
    make_parts(gifts);

    for (const Gift& gift : gifts) {
        const Place from = lattice_.place(gift.from);
        const Filling given = parts_[first_part(gift.from)].filling;
        for (const Index number : gift.to) {
            const Place to = lattice_.place(number);
            const Eigen::Vector3d shift(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
            parts_[first_part(number)].filling.add(given, 1.0 / static_cast<double>(gift.to.size()), shift);
        }
        parts_[first_part(gift.from)].filling = {};
    }
    std::erase_if(parts_, [](const Part& part) { return part.filling.volume == 0; });
}

/// Neighbours that are particles, or else those that have more than twice as much; of these the nearest, all
/// that are equally near.
std::vector<Index> FilledPlaces::receivers(const Part& part) const {
    struct Neighbour {
        Index number;
        double distance;
        bool particle;
    };
    std::vector<Neighbour> neighbours;
    const Place place = lattice_.place(part.number);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const Place other{place[0] + x, place[1] + y, place[2] + z};
                if (other == place || !lattice_.has(other)) continue;
                const Index number = lattice_.number(other);
                bool particle = is_whole(number);
                if (!particle) {
                    const std::size_t i = first_part(number);
                    if (i == parts_.size() || parts_[i].number != number) continue;
                    particle = parts_[i].particle;
                    if (!particle && parts_[i].filling.volume <= 2 * part.filling.volume) continue;
                }
                const double distance = (part.filling.centroid() - Eigen::Vector3d(x, y, z)).norm();
                neighbours.push_back({number, distance, particle});
            }
    if (std::ranges::any_of(neighbours, &Neighbour::particle))
        std::erase_if(neighbours, [](const Neighbour& neighbour) { return !neighbour.particle; });
    std::vector<Index> nearest;
    if (neighbours.empty()) return nearest;
    const double least = std::ranges::min(neighbours, {}, &Neighbour::distance).distance;
    for (const Neighbour& neighbour : neighbours)
        if (neighbour.distance < least * (1 + 1e-9)) nearest.push_back(neighbour.number);
    return nearest;
}

bool FilledPlaces::is_whole(Index number) const {
    const Index piece = lattice_.piece_of(number);
    const std::vector<bool>& whole = whole_[static_cast<std::size_t>(piece)];
    return !whole.empty() && whole[static_cast<std::size_t>(number - lattice_.begin(piece))];
}

/// The first part with this number or one beyond.
std::size_t FilledPlaces::first_part(Index number) const {
    const auto found = std::ranges::lower_bound(parts_, number, {}, &Part::number);
    return static_cast<std::size_t>(found - parts_.begin());
}

/// Of the whole places that are given something, fillings are kept too.
void FilledPlaces::make_parts(const std::vector<Gift>& gifts) {
    const auto old = static_cast<std::ptrdiff_t>(parts_.size());
    for (const Gift& gift : gifts)
        for (const Index number : gift.to) {
            if (!is_whole(number)) continue;
            const Index piece = lattice_.piece_of(number);
            whole_[static_cast<std::size_t>(piece)]
                  [static_cast<std::size_t>(number - lattice_.begin(piece))] = false;
            parts_.push_back({number, Filling::whole(), true});
        }
    std::ranges::sort(parts_.begin() + old, parts_.end(), {}, &Part::number);
    std::ranges::inplace_merge(parts_, parts_.begin() + old, {}, &Part::number);
}

void FilledPlaces::count() {
    begins_.assign(1, 0);
    std::size_t part = 0;
    for (Index piece = 0; piece < pieces(); ++piece) {
        const std::vector<bool>& whole = whole_[static_cast<std::size_t>(piece)];
        const std::size_t end = first_part(lattice_.begin(piece + 1));
        begins_.push_back(begins_.back() + std::count(whole.begin(), whole.end(), true) +
                          static_cast<Index>(end - part));
        part = end;
    }
}

}  // namespace matpoint
