// Levels of the grid: which one particles are on, and those that go with a body or a tool.
#include "step/phase_timer.hpp"

#include <matpoint/parallel.hpp>

#include <algorithm>
#include <stdexcept>

namespace matpoint {

namespace {

/// Whether a particle's stencil, and a node on every side of it, exist.
template <class S>
bool has_nodes(const Patch<S>& patch, const typename Patch<S>::Coordinates& base, int width) {
    for (int corner = 0; corner < 1 << S::dimension; ++corner) {
        typename Patch<S>::Coordinates node;
        for (std::size_t a = 0; a < S::dimension; ++a)
            node[a] = std::clamp(base[a] + ((corner >> a & 1) != 0 ? width : -1), -1, patch.cells()[a] + 1);
        if (patch.node_index(node) < 0) return false;
    }
    return true;
}

}  // namespace

template <class S>
int Engine<S>::level_at(std::size_t body, const typename S::Position& x) const {
    const ShapeFunction<S>& shape = *components_.shape;
    const int level = levels_.at(x);
    for (const int own : {level, level + 1, level - 1}) {
        if (own < 0 || own >= levels_.count()) continue;
        const Patch<S>& patch = nodes(body, own);
        const auto base =
            guarded(shape, "base_node", [&] { return shape.base_node(patch, bodies_[body], x); });
        if (has_nodes(patch, base, shape.width())) return own;
    }
    throw std::logic_error("a body has no nodes at one of its particles");
}

/// The centre of mass, or where the tool is, m.
template <class S>
Eigen::Vector3d Engine<S>::place_of(const Follow& follow) const {
    if (follow.contact) {
        const ContactReport report = contact_report(*follow.contact);
        return Eigen::Vector3d::Map(report.position.data());
    }
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    if (!follow.body) return place;
    const Particles<S>& particles = bodies_[*follow.body];
    const Real* const masses = particles.column(Field::mass);
    double mass = 0;
    for (Index p = 0; p < particles.size(); ++p) {
        mass += static_cast<double>(masses[p]);
        for (int a = 0; a < S::dimension; ++a)
            place[a] += static_cast<double>(masses[p]) * particles.value(Field::position, a, p);
    }
    return mass > 0 ? Eigen::Vector3d(place / mass) : place;
}

/// A region moves when what it follows has gone on by half a cell of the next coarser level, so that it
/// doesn't flicker. The grid holds no state between steps.
template <class S>
void Engine<S>::move_levels() {
    bool moved = false;
    for (std::size_t k = 0; k < level_starts_.size(); ++k) {
        const Follow& follow = components_.follows[k];
        if (!follow.body && !follow.contact) continue;
        const Eigen::Vector3d shift = place_of(follow) - level_starts_[k];
        const auto& cell = levels_.patch(static_cast<int>(k)).cell_size();
        for (int a = 0; a < S::dimension; ++a)
            moved = moved || std::abs(shift[a] - level_shifts_[k][a]) > cell[a] / 2;
    }
    if (!moved) return;
    for (std::size_t k = 0; k < level_starts_.size(); ++k)
        if (const Follow& follow = components_.follows[k]; follow.body || follow.contact)
            level_shifts_[k] = place_of(follow) - level_starts_[k];
    levels_.move(level_shifts_);
    for (std::size_t b = 0; b < bodies_.size(); ++b) ordering_.forget(b);
}

template <class S>
void Engine<S>::restore_levels(std::vector<Eigen::Vector3d> starts, std::vector<Eigen::Vector3d> shifts) {
    level_starts_ = std::move(starts);
    level_shifts_ = std::move(shifts);
    if (!level_shifts_.empty()) levels_.move(level_shifts_);
}

#define MATPOINT_INSTANTIATE(S)                                                       \
    template Eigen::Vector3d Engine<S>::place_of(const Follow&) const;                \
    template int Engine<S>::level_at(std::size_t, const typename S::Position&) const; \
    template void Engine<S>::move_levels();                                           \
    template void Engine<S>::restore_levels(std::vector<Eigen::Vector3d>, std::vector<Eigen::Vector3d>);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
