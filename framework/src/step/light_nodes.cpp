#include "step/light_nodes.hpp"

#include <algorithm>
#include <numbers>

namespace matpoint {

namespace {

/// A node leads another that has at most this part of its mass: then no lead ends with less than nothing.
constexpr double lead_ratio = 8;

enum State : char { leads, waits, follows };

/// Of a node's mass to what it has within the grid's faces.
template <class S>
double mirrored(const Patch<S>& patch, const typename Patch<S>::Coordinates& node) {
    double parts = 1;
    for (std::size_t a = 0; a < S::dimension; ++a)
        if (node[a] == 0 || node[a] == patch.cells()[a]) parts *= 2;
    return parts;
}

}  // namespace

/// kg, of a node in the midst of the lightest body.
template <class S>
double LightNodes<S>::full_mass(const Patch<S>& patch, const Coordinates& node) const {
    double mass = density_;
    for (int a = 0; a < S::dimension; ++a) mass *= static_cast<double>(patch.cell_size()[a]);
    if constexpr (S::axisymmetric) {
        const auto h = static_cast<double>(patch.cell_size()[0]);
        mass *= 2 * std::numbers::pi * std::max(static_cast<double>(patch.node_position(node)[0]), h / 3);
    }
    return mass;
}

template <class S>
void LightNodes<S>::locate(const Patch<S>& patch, const std::vector<char>& inside,
                           const std::vector<unsigned char>& prescribed, bool loaded) {
    links_.clear();
    terms_.clear();
    if (share_ == 0) return;
    constexpr auto all_components = static_cast<unsigned char>((1 << S::dimension) - 1);
    const Real* const mass = patch.column(NodeField::mass);
    const auto has_load = [&](int i) {
        for (int c = 0; loaded && c < S::dimension; ++c)
            if (patch.column(NodeField::external_force, c)[i] != Real(0)) return true;
        return false;
    };
    state_.assign(static_cast<std::size_t>(patch.node_count()), leads);
    pending_.clear();
    double most = density_;
    for (int a = 0; a < S::dimension; ++a) most *= static_cast<double>(patch.cell_size()[a]);
    if constexpr (S::axisymmetric)
        most *= 2 * std::numbers::pi * static_cast<double>(patch.node_position(patch.cells())[0]);
    const auto limit = static_cast<Real>(share_ * most);
    for (int i = 0; i < static_cast<int>(patch.node_count()); ++i) {
        const auto place = static_cast<std::size_t>(i);
        if (mass[i] > limit || !inside[place] || prescribed[place] == all_components) continue;
        if (mass[i] == Real(0) && !has_load(i)) continue;
        state_[place] = waits;
        pending_.push_back(i);
    }
    // A node that only light ones surround comes after these.
    for (std::size_t before = pending_.size() + 1; !pending_.empty() && pending_.size() < before;) {
        before = pending_.size();
        const std::size_t first = links_.size();
        std::erase_if(pending_, [&](int i) { return link(patch, i, inside, prescribed); });
        for (std::size_t k = first; k < links_.size(); ++k)
            state_[static_cast<std::size_t>(links_[k].node)] = follows;
    }
}

/// Whether it is settled what the node is made of.
template <class S>
bool LightNodes<S>::link(const Patch<S>& patch, int i, const std::vector<char>& inside,
                         const std::vector<unsigned char>& prescribed) {
    const Real* const mass = patch.column(NodeField::mass);
    const Coordinates node = patch.node_coordinates(i);
    const double own_mass = static_cast<double>(mass[i]) * mirrored<S>(patch, node);
    struct Neighbour {
        int node = -1;
        double mass = 0;
    };
    const auto neighbour = [&](int axis, int steps) -> Neighbour {
        Coordinates other = node;
        other[static_cast<std::size_t>(axis)] += steps;
        const int j = patch.node_index(other);
        if (j < 0 || !inside[static_cast<std::size_t>(j)]) return {};
        return {j, static_cast<double>(mass[j]) * mirrored<S>(patch, other)};
    };
    const auto may_lead = [&](const Neighbour& other) {
        if (other.node < 0) return false;
        const auto place = static_cast<std::size_t>(other.node), own = static_cast<std::size_t>(i);
        if (prescribed[own] != 0 && prescribed[place] != prescribed[own]) return false;
        if (own_mass == 0 && other.mass == 0) return state_[place] == follows;
        return other.mass >= lead_ratio * own_mass;
    };

    struct Lead {
        int near, far;
        double weight;
    };
    std::array<Lead, 2 * S::dimension> leads_found;
    std::size_t count = 0;
    double heaviest = 0, sum = 0;
    for (int a = 0; a < S::dimension; ++a)
        for (const int side : {-1, 1}) {
            const Neighbour near = neighbour(a, side), far = neighbour(a, 2 * side);
            if (!may_lead(near)) continue;
            if (state_[static_cast<std::size_t>(near.node)] == waits) return false;
            const bool both = may_lead(far);
            if (both && state_[static_cast<std::size_t>(far.node)] == waits) return false;
            const double weight = std::max(near.mass, std::numeric_limits<double>::min());
            heaviest = std::max(heaviest, weight);
            sum += weight;
            leads_found[count++] = {near.node, both ? far.node : -1, weight};
        }
    if (count == 0) {
        if (own_mass > 0) state_[static_cast<std::size_t>(i)] = leads;
        return own_mass > 0;
    }
    // A node without mass is light even where none is to be.
    const double part = own_mass > 0 ? own_mass / std::min(heaviest, full_mass(patch, node)) / share_ : 0;
    const double own = std::clamp(2 * part - 1, 0.0, 1.0);
    if (own == 1) {
        state_[static_cast<std::size_t>(i)] = leads;
        return true;
    }
    const int begin = static_cast<int>(terms_.size());
    for (std::size_t k = 0; k < count; ++k) {
        const double weight = (1 - own) * leads_found[k].weight / sum;
        if (leads_found[k].far < 0) {
            terms_.push_back({leads_found[k].near, static_cast<Real>(weight)});
        } else {
            terms_.push_back({leads_found[k].near, static_cast<Real>(2 * weight)});
            terms_.push_back({leads_found[k].far, static_cast<Real>(-weight)});
        }
    }
    links_.push_back({i, static_cast<Real>(own), begin, static_cast<int>(terms_.size())});
    return true;
}

template <class S>
void LightNodes<S>::fold(Patch<S>& patch, NodeField field) const {
    for (int c = 0; c < Patch<S>::components(field); ++c) {
        Real* const values = patch.column(field, c);
        for (auto link = links_.rbegin(); link != links_.rend(); ++link) {
            for (int t = link->begin; t < link->end; ++t) {
                const Term& term = terms_[static_cast<std::size_t>(t)];
                values[term.node] += term.weight * values[link->node];
            }
            values[link->node] *= link->own;
        }
    }
}

template <class S>
void LightNodes<S>::fill(Patch<S>& patch, NodeField field) {
    own_.resize(links_.size() * S::dimension);
    for (int c = 0; c < Patch<S>::components(field); ++c) {
        Real* const values = patch.column(field, c);
        Real* const own = own_.data() + static_cast<std::size_t>(c) * links_.size();
        for (std::size_t k = 0; k < links_.size(); ++k) {
            const Link& link = links_[k];
            own[k] = values[link.node];
            Real value = link.own * own[k];
            for (int t = link.begin; t < link.end; ++t) {
                const Term& term = terms_[static_cast<std::size_t>(t)];
                value += term.weight * values[term.node];
            }
            values[link.node] = value;
        }
    }
}

template <class S>
void LightNodes<S>::restore(Patch<S>& patch, NodeField field) const {
    for (int c = 0; c < Patch<S>::components(field); ++c)
        for (std::size_t k = 0; k < links_.size(); ++k)
            patch.column(field, c)[links_[k].node] = own_[static_cast<std::size_t>(c) * links_.size() + k];
}

#define MATPOINT_INSTANTIATE(S) template class LightNodes<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
