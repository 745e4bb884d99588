#include "step/light_nodes.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace matpoint {

namespace {

/// Steps of a line, and its length in cells, beyond which nothing leads. Stencils reach two cells beyond an
/// edge.
constexpr int most_steps = 3, largest_square = 12;

/// Visits the 3^D - 1 directions to a node's neighbours.
template <std::size_t D, class Visit>
void for_directions(const Visit& visit) {
    std::array<int, D> direction;
    direction.fill(-1);
    for (;;) {
        if (std::ranges::any_of(direction, [](int d) { return d != 0; })) visit(direction);
        std::size_t a = 0;
        while (a < D && direction[a] == 1) direction[a++] = -1;
        if (a == D) return;
        ++direction[a];
    }
}

/// Of a node's mass to what it has within the grid's faces.
template <class S>
double times_at_faces(const Patch<S>& patch, const typename Patch<S>::Coordinates& node) {
    double times = 1;
    for (std::size_t a = 0; a < S::dimension && !patch.centred(); ++a)
        if (node[a] == 0 || node[a] == patch.cells()[a]) times *= 2;
    return times;
}

}  // namespace

template <class S>
LightNodes<S>::LightNodes(double share, double density) : share_(share), density_(density) {
    std::map<int, std::vector<Line>> by_square;
    for_directions<S::dimension>([&](const Coordinates& direction) {
        int square = 0;
        for (const int d : direction) square += d * d;
        for (int steps = 1; steps <= most_steps && square * steps * steps <= largest_square; ++steps)
            by_square[square * steps * steps].push_back({direction, steps});
    });
    for (auto& [square, lines] : by_square) lines_.push_back(std::move(lines));
}

/// kg, of a node in the midst of the lightest body; at the grid's faces, of what is within.
template <class S>
double LightNodes<S>::full_mass(const Patch<S>& patch, int place) const {
    const Coordinates node = patch.node_coordinates(place);
    double mass = density_ / times_at_faces<S>(patch, node);
    if (!left_.empty()) mass *= static_cast<double>(left_[static_cast<std::size_t>(place)]);
    for (int a = 0; a < S::dimension; ++a) mass *= patch.cell_size()[a];
    if constexpr (S::axisymmetric) {
        const double h = patch.cell_size()[0];
        mass *= 2 * std::numbers::pi * std::max(patch.node_position(node)[0], h / 3);
    }
    return mass;
}

template <class S>
void LightNodes<S>::locate(std::span<Patch<S>* const> layers, const std::vector<char>& inside,
                           const std::vector<unsigned char>& prescribed, const std::vector<float>& left,
                           bool loaded) {
    left_ = left;
    links_.clear();
    leads_.clear();
    kept_.clear();
    if (share_ == 0) return;
    const Patch<S>& patch = *layers.front();
    const auto layer = [&](int i) -> const Patch<S>& { return *layers[patch.layer_of(i)]; };
    const Real* const mass = patch.column(NodeField::mass);
    const auto has_load = [&](int i) {
        for (int c = 0; loaded && c < S::dimension; ++c)
            if (patch.column(NodeField::external_force, c)[i] != Real(0)) return true;
        return false;
    };
    double most = density_;
    for (int a = 0; a < S::dimension; ++a) most *= patch.cell_size()[a];
    if constexpr (S::axisymmetric) most *= 2 * std::numbers::pi * patch.node_position(patch.cells())[0];
    const auto limit = static_cast<Real>(share_ * most);

    const int count = static_cast<int>(patch.node_count());
    prescribed_ = prescribed;
    states_.resize(static_cast<std::size_t>(count));
    light_.clear();
    for (int i = 0; i < count; ++i) {
        const auto place = static_cast<std::size_t>(i);
        const bool heavy = inside[place] && mass[i] > limit;
        states_[place] = heavy ? State::firm : State::none;
        if (heavy || !inside[place] || (mass[i] == Real(0) && !has_load(i))) continue;
        if (static_cast<double>(mass[i]) >= share_ * full_mass(layer(i), i))
            states_[place] = State::firm;
        else
            light_.push_back(i);
    }
    constexpr auto all_components = static_cast<unsigned char>((1 << S::dimension) - 1);
    std::erase_if(light_, [&](int i) { return prescribed[static_cast<std::size_t>(i)] == all_components; });

    std::vector<int>& alone = light_;  // so far: what no firm node leads
    std::erase_if(alone, [&](int i) {
        const auto link = along_lines(layer(i), i);
        if (link && link->part > 0) {
            links_.push_back(*link);
            states_[static_cast<std::size_t>(i)] = State::follows;
        }
        return link.has_value();
    });
    for (const int i : alone)
        if (const auto link = beside_heavier(layer(i), i)) links_.push_back(*link);
    weigh(patch);
}

/// What links take of their leads' masses.
template <class S>
void LightNodes<S>::weigh(const Patch<S>& patch) {
    const Real* const mass = patch.column(NodeField::mass);
    shared_.assign(states_.size(), 0);
    for (const Lead& lead : leads_)
        shared_[static_cast<std::size_t>(lead.node)] += static_cast<float>(std::abs(lead.factor));
    for (Lead& lead : leads_) {
        lead.by_mass = lead.factor / mass[lead.node];
        lead.reluctance =
            std::abs(lead.by_mass) * static_cast<Real>(shared_[static_cast<std::size_t>(lead.node)]);
    }
    for (Link& link : links_) {
        link.prescribed = prescribed_[static_cast<std::size_t>(link.node)];
        for (const Lead& lead : leads(link)) {
            link.prescribed |= prescribed_[static_cast<std::size_t>(lead.node)];
            link.reluctance += lead.reluctance;
        }
    }
    lambda_.resize(links_.size());
}

template <class S>
int LightNodes<S>::firm_node(const Patch<S>& patch, const Coordinates& from, const Coordinates& direction,
                             int steps) const {
    Coordinates node = from;
    for (std::size_t a = 0; a < S::dimension; ++a) node[a] += steps * direction[a];
    if (!patch.inside(node)) return -1;
    const int index = patch.node_index(node);
    return index >= 0 && states_[static_cast<std::size_t>(index)] == State::firm ? index : -1;
}

/// Whether the node is on a wall that mirrors the line from it to its opposite.
template <class S>
bool LightNodes<S>::mirrored(const Patch<S>& patch, const Coordinates& node,
                             const Coordinates& direction) const {
    int axis = -1;
    for (int a = 0; a < S::dimension; ++a) {
        if (direction[static_cast<std::size_t>(a)] == 0) continue;
        if (axis >= 0) return false;
        axis = a;
    }
    const auto a = static_cast<std::size_t>(axis);
    if (node[a] != 0 && node[a] != patch.cells()[a]) return false;
    return (prescribed_[static_cast<std::size_t>(patch.node_index(node))] >> axis & 1) != 0;
}

template <class S>
auto LightNodes<S>::link_of(int node, double part, std::size_t begin) const -> Link {
    return {.node = node,
            .part = static_cast<Real>(std::clamp(2 - 2 * part, 0.0, 1.0)),
            .begin = static_cast<int>(begin),
            .end = static_cast<int>(leads_.size())};
}

/// By the nearest lines of firm nodes, equally. Lines in opposite directions are a gap's: what one body gives
/// the node is not for the other.
template <class S>
auto LightNodes<S>::along_lines(const Patch<S>& patch, int i) -> std::optional<Link> {
    const Coordinates node = patch.node_coordinates(i);
    std::vector<Found>& found = found_;
    found.clear();
    const auto find = [&](bool whole) {
        for (const std::vector<Line>& lines : lines_) {
            for (const Line& line : lines)
                if (const int near = firm_node(patch, node, line.direction, line.steps); near >= 0)
                    found.push_back({&line, near, firm_node(patch, node, line.direction, line.steps + 1)});
            if (whole) std::erase_if(found, [](const Found& f) { return f.far < 0; });
            if (!found.empty()) return;
        }
    };
    find(true);
    if (found.empty()) find(false);  // too thin for two
    if (found.empty()) return {};
    const auto has_opposite = [&](const Found& own) {
        Coordinates opposite = own.line->direction;
        for (int& d : opposite) d = -d;
        return mirrored(patch, node, opposite) || std::ranges::any_of(found, [&](const Found& other) {
                   return other.line->direction == opposite;
               });
    };
    if (std::ranges::any_of(found, has_opposite)) return Link{.node = i, .part = 0, .begin = 0, .end = 0};

    const double part =
        static_cast<double>(patch.column(NodeField::mass)[i]) / (share_ * full_mass(patch, i));
    const std::size_t begin = leads_.size();
    for (const Found& own : found) {
        const auto weight = static_cast<Real>(1.0 / static_cast<double>(found.size()));
        if (own.far < 0) {
            leads_.push_back({.node = own.near, .factor = weight});
        } else {
            const auto steps = static_cast<Real>(own.line->steps);
            leads_.push_back({.node = own.near, .factor = (steps + 1) * weight});
            leads_.push_back({.node = own.far, .factor = -steps * weight});
        }
    }
    return link_of(i, part, begin);
}

/// The heaviest neighbour of a node, and its mass, were it not at a face; -1 if there are two.
template <class S>
auto LightNodes<S>::heaviest_neighbour(const Patch<S>& patch, const Coordinates& node) const -> Heaviest {
    const Real* const mass = patch.column(NodeField::mass);
    Heaviest heaviest;
    for_directions<S::dimension>([&](const Coordinates& direction) {
        Coordinates other = node;
        for (std::size_t a = 0; a < S::dimension; ++a) other[a] += direction[a];
        const int j = patch.inside(other) ? patch.node_index(other) : -1;
        if (j < 0) return;
        const double own = static_cast<double>(mass[j]) * times_at_faces<S>(patch, other);
        if (own == heaviest.mass) heaviest.node = -1;
        if (own > heaviest.mass) heaviest = {j, own};
    });
    return heaviest;
}

/// Where nothing is firm, what is light beside the heaviest node around moves as that one does.
template <class S>
auto LightNodes<S>::beside_heavier(const Patch<S>& patch, int i) -> std::optional<Link> {
    const Coordinates node = patch.node_coordinates(i);
    const Heaviest heaviest = heaviest_neighbour(patch, node);
    if (heaviest.node < 0 || states_[static_cast<std::size_t>(heaviest.node)] == State::follows) return {};
    const double part = static_cast<double>(patch.column(NodeField::mass)[i]) *
                        times_at_faces<S>(patch, node) / (share_ * heaviest.mass);
    if (part >= 1) return {};
    if (heaviest_neighbour(patch, patch.node_coordinates(heaviest.node)).mass * share_ > heaviest.mass)
        return {};  // it will follow another itself
    const std::size_t begin = leads_.size();
    leads_.push_back({.node = heaviest.node, .factor = Real(1)});
    return link_of(i, part, begin);
}

/// `impulse` of a node: its momentum or force.
template <class S>
template <class Impulse>
void LightNodes<S>::follow(const Patch<S>& patch, int component, Real* values, Real* force, Real share,
                           const Impulse& impulse) {
    const Real* const mass = patch.column(NodeField::mass);
    const auto is_prescribed = [&](int node) {
        return (prescribed_[static_cast<std::size_t>(node)] >> component & 1) != 0;
    };
    for (std::size_t k = 0; k < links_.size(); ++k) {
        const Link& link = links_[k];
        lambda_[k] = 0;
        Real reluctance = link.reluctance;
        if ((link.prescribed >> component & 1) != 0) {
            if (is_prescribed(link.node)) continue;
            for (const Lead& lead : leads(link))
                if (is_prescribed(lead.node)) reluctance -= lead.reluctance;
        }
        Real extrapolated(0);
        for (const Lead& lead : leads(link)) extrapolated += lead.factor * values[lead.node];
        const Real own = mass[link.node], given = impulse(link.node);
        const Real whole = (given - own * extrapolated) / (1 + own * reluctance);
        lambda_[k] = link.part * whole;
        values[link.node] = link.part == 1 ? extrapolated + whole * reluctance : (given - lambda_[k]) / own;
    }
    for (std::size_t k = 0; k < links_.size(); ++k) {
        const bool walls = (links_[k].prescribed >> component & 1) != 0;
        for (const Lead& lead : leads(links_[k])) {
            if (!walls || !is_prescribed(lead.node))
                values[lead.node] += lead.by_mass * lambda_[k];
            else if (share != 0)
                force[lead.node] += share * lead.factor * lambda_[k];
        }
    }
}

template <class S>
void LightNodes<S>::follow_velocity(Patch<S>& patch, NodeField velocity, Real share, NodeField given) {
    const Real* const mass = patch.column(NodeField::mass);
    for (int c = 0; c < S::dimension; ++c) {
        Real* const v = patch.column(velocity, c);
        follow(patch, c, v, patch.column(given, c), share, [&](int i) { return mass[i] * v[i]; });
    }
}

template <class S>
void LightNodes<S>::follow_acceleration(Patch<S>& patch) {
    for (int c = 0; c < S::dimension; ++c) {
        Real* const force = patch.column(NodeField::force, c);
        follow(patch, c, patch.column(NodeField::acceleration, c), force, Real(1),
               [&](int i) { return force[i]; });
    }
}

template <class S>
template <class Visit>
void LightNodes<S>::visit_nodes(const Visit& visit) const {
    for (const Link& link : links_) visit(link.node);
    for (const Lead& lead : leads_) visit(lead.node);
}

template <class S>
void LightNodes<S>::keep_velocity(const Patch<S>& patch) {
    kept_.clear();
    for (int c = 0; c < S::dimension; ++c)
        visit_nodes([&](int i) { kept_.push_back(patch.column(NodeField::velocity, c)[i]); });
}

template <class S>
void LightNodes<S>::restore_velocity(Patch<S>& patch) {
    auto kept = kept_.begin();
    for (int c = 0; c < S::dimension && !kept_.empty(); ++c)
        visit_nodes([&](int i) { patch.column(NodeField::velocity, c)[i] = *kept++; });
    kept_.clear();
}

#define MATPOINT_INSTANTIATE(S) template class LightNodes<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
