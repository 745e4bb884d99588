#include "step/walls.hpp"

namespace matpoint {

namespace {

/// Cells beyond a closed face from which particles are put back: rounding leaves them at 1e-16, nodes with
/// hardly any mass at a few per cent.
constexpr double reach_of_walls = 0.1;

}  // namespace

template <class S>
Walls<S>::Walls(std::vector<PlacedCondition<S>> conditions)
    : conditions_(std::move(conditions)), carries_(conditions_.size(), Vector(Vector::Zero())) {
    for (int axis = 0; axis < S::dimension; ++axis)
        for (int side = 0; side < 2; ++side) {
            Face face{axis, side, {}, false, false, {}};
            face.condition.fill(-1);
            for (std::size_t k = 0; k < conditions_.size(); ++k) {
                if (!holds_on(conditions_[k], axis, side)) continue;
                if (friction_of(conditions_[k])) {
                    face.unilateral = true;
                    continue;
                }
                face.wall = true;
                const auto prescribes = prescribed(k, axis);
                for (std::size_t c = 0; c < S::dimension; ++c)
                    if (prescribes[c]) face.condition[c] = static_cast<int>(k);
                carry(k, prescribes);
            }
            faces_.push_back(std::move(face));
        }
    for (std::size_t k = 0; k < conditions_.size(); ++k)
        if (conditions_[k].faces.empty()) carry(k, prescribed(k, -1));
}

template <class S>
void Walls<S>::carry(std::size_t condition, const std::array<bool, 3>& prescribes) {
    for (int c = 0; c < S::dimension; ++c)
        if (prescribes[static_cast<std::size_t>(c)]) carries_[condition][c] = 1;
}

template <class S>
std::optional<typename Walls<S>::Link> Walls<S>::link_of(const Patch<S>& patch, int ghost,
                                                         const Face& face) const {
    auto edge = patch.node_coordinates(ghost), inner = edge;
    const auto axis = static_cast<std::size_t>(face.axis);
    edge[axis] = face.side == 0 ? 0 : patch.cells()[axis];
    Position position = patch.node_position(edge);
    const int inwards = face.side == 0 ? 1 : -1;
    // Nodes at the middles of cells have their images in the next cell.
    const bool next = patch.centred() && face.wall;
    inner[axis] = edge[axis] + (next ? 0 : inwards);
    if (patch.centred()) position[face.axis] -= inwards * patch.cell_size()[face.axis] / 2;
    const Link link{ghost, patch.node_index(edge), patch.node_index(inner), position};
    if (link.edge < 0 || link.inner < 0) return {};
    return link;
}

template <class S>
void Walls<S>::locate(std::span<Patch<S>* const> layers, const std::vector<char>& followers) {
    const Patch<S>& all = *layers.front();
    using Coordinates = typename Patch<S>::Coordinates;
    prescribed_.clear();
    prescribed_components_.assign(static_cast<std::size_t>(all.node_count()), 0);
    const auto levels = static_cast<std::size_t>(layers.back()->level()) + 1;
    for (Face& face : faces_) face.links.assign(levels, {});

    for (int index = 0; index < static_cast<int>(all.node_count()); ++index) {
        const Patch<S>& patch = *layers[all.layer_of(index)];
        const Coordinates node = patch.node_coordinates(index);
        for (Face& face : faces_) {
            const auto axis = static_cast<std::size_t>(face.axis);
            const int last = patch.cells()[axis];
            if (node[axis] != (face.side == 0 ? -1 : last + 1)) continue;
            // Axes are folded one after the other: those before this one have no ghosts left.
            bool concerned = true;
            for (std::size_t a = 0; a < S::dimension; ++a) {
                const int margin = a > axis ? 1 : 0;
                concerned =
                    concerned && (a == axis || (node[a] >= -margin && node[a] <= patch.cells()[a] + margin));
            }
            if (!concerned) continue;
            if (const auto link = link_of(patch, index, face))
                face.links[static_cast<std::size_t>(patch.level())].push_back(*link);
        }
        if (!patch.inside(node) || (!followers.empty() && followers[static_cast<std::size_t>(index)] != 0))
            continue;

        const Position position = patch.node_position(node);
        std::array<int, S::dimension> condition;
        condition.fill(-1);
        for (const Face& face : faces_) {
            const auto axis = static_cast<std::size_t>(face.axis);
            if (patch.centred() || node[axis] != (face.side == 0 ? 0 : patch.cells()[axis])) continue;
            for (std::size_t c = 0; c < S::dimension; ++c)
                if (condition[c] < 0) condition[c] = face.condition[c];
        }
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        point.head<S::dimension>() = position;
        for (std::size_t k = 0; k < conditions_.size(); ++k) {
            const Geometry* const region = conditions_[k].region.get();
            if (!region || !guarded(*region, "contains", [&] { return region->contains(point); })) continue;
            const auto prescribes = prescribed(k, -1);
            for (std::size_t c = 0; c < S::dimension; ++c)
                if (prescribes[c] && condition[c] < 0) condition[c] = static_cast<int>(k);
        }
        for (int c = 0; c < S::dimension; ++c) {
            if (condition[static_cast<std::size_t>(c)] < 0) continue;
            prescribed_.push_back({index, c, condition[static_cast<std::size_t>(c)], position});
            prescribed_components_[static_cast<std::size_t>(index)] |= static_cast<unsigned char>(1 << c);
        }
    }
    located_ = prescribed_.size();
}

template <class S>
void Walls<S>::hold_node(const Patch<S>& patch, int node, std::size_t condition) {
    const auto prescribes = prescribed(condition, -1);
    unsigned char& held = prescribed_components_[static_cast<std::size_t>(node)];
    for (int c = 0; c < S::dimension; ++c) {
        if (!prescribes[static_cast<std::size_t>(c)] || (held >> c & 1) != 0) continue;
        prescribed_.push_back({node, c, static_cast<int>(condition), patch.position_at(node)});
        held |= static_cast<unsigned char>(1 << c);
    }
}

template <class S>
void Walls<S>::let_go() {
    for (; prescribed_.size() > located_; prescribed_.pop_back())
        prescribed_components_[static_cast<std::size_t>(prescribed_.back().node)] &=
            static_cast<unsigned char>(~(1 << prescribed_.back().component));
}

template <class S>
typename S::Vector Walls<S>::velocity(int condition, const Position& position, const PathMean& mean) const {
    const BoundaryCondition<S>& own = *conditions_[static_cast<std::size_t>(condition)].condition;
    const Vector v = guarded(own, "velocity", [&] { return own.velocity(position, mean.time); });
    return mean.span == 0 || (v.array() == 0).all() ? v : along_path(condition, position, mean);
}

/// By the classical method of Runge and Kutta; where a component is the same all along, that to the bit. What
/// a condition doesn't prescribe carries nothing.
template <class S>
typename S::Vector Walls<S>::along_path(int condition, const Position& position, const PathMean& mean) const {
    const auto k = static_cast<std::size_t>(condition);
    const BoundaryCondition<S>& own = *conditions_[k].condition;
    const auto at = [&](const Position& x) -> Vector {
        const Vector v = guarded(own, "velocity", [&] { return own.velocity(x, mean.time); });
        return (carries_[k].array() != 0).select(v, Vector::Zero());
    };
    const auto after = [&](double part, const Vector& v) {
        return at(position + part * mean.span * v.template cast<double>());
    };
    const Vector first = at(position);
    try {
        const Vector second = after(0.5, first), third = second == first ? second : after(0.5, second),
                     last = after(1, third);
        return first + (2 * (second - first) + 2 * (third - first) + (last - first)) / 6;
    } catch (const FormulaError&) {
        return first;  // there is none beside the node, as of sqrt(1 - x) on a face at x = 1
    }
}

/// Components at one node come one after the other: their velocity is asked for once.
template <class S>
class Walls<S>::Velocities {
  public:
    Velocities(const Walls& walls, const PathMean& mean) : walls_(walls), mean_(mean) {}

    Real operator()(const Prescribed& p) {
        if (p.node != node_ || p.condition != condition_)
            velocity_ = walls_.velocity(p.condition, p.position, mean_);
        node_ = p.node;
        condition_ = p.condition;
        return velocity_[p.component];
    }

  private:
    const Walls& walls_;
    PathMean mean_;
    int node_ = -1, condition_ = -1;
    Vector velocity_;
};

template <class S>
std::array<bool, 3> Walls<S>::prescribed(std::size_t condition, int axis) const {
    const BoundaryCondition<S>& own = *conditions_[condition].condition;
    return guarded(own, "prescribes", [&] { return own.prescribes(axis); });
}

template <class S>
void Walls<S>::fold_mass(Patch<S>& patch, int level) const {
    Real* mass = patch.column(NodeField::mass);
    for (const Face& face : faces_)
        for (const Link& link : face.links[static_cast<std::size_t>(level)]) {
            if (face.wall) {
                mass[link.inner] += mass[link.ghost];
            } else {
                mass[link.edge] += 2 * mass[link.ghost];
                mass[link.inner] -= mass[link.ghost];
            }
        }
}

template <class S>
void Walls<S>::fold_momentum(Patch<S>& patch, NodeField momentum, const PathMean& mean, int level) const {
    fold_force(patch, momentum, level);
    // The mirrored body moves with 2 V - v where the wall moves with V.
    const Real* mass = patch.column(NodeField::mass);
    for (const Face& face : faces_)
        for (int c = 0; c < S::dimension; ++c) {
            const int condition = face.condition[static_cast<std::size_t>(c)];
            if (condition < 0) continue;
            Real* p = patch.column(momentum, c);
            for (const Link& link : face.links[static_cast<std::size_t>(level)])
                p[link.inner] += 2 * mass[link.ghost] * velocity(condition, link.position, mean)[c];
        }
}

template <class S>
void Walls<S>::fold_force(Patch<S>& patch, NodeField force, int level) const {
    for (const Face& face : faces_)
        for (int c = 0; c < S::dimension; ++c) {
            Real* f = patch.column(force, c);
            const Real sign = face.condition[static_cast<std::size_t>(c)] >= 0 ? Real(-1) : Real(1);
            for (const Link& link : face.links[static_cast<std::size_t>(level)]) {
                if (face.wall) {
                    f[link.inner] += sign * f[link.ghost];
                } else {
                    f[link.edge] += 2 * f[link.ghost];
                    f[link.inner] -= f[link.ghost];
                }
            }
        }
}

template <class S>
void Walls<S>::constrain(Patch<S>& patch, NodeField field, const PathMean& mean) const {
    Velocities velocity(*this, mean);
    for (const Prescribed& p : prescribed_) patch.column(field, p.component)[p.node] = velocity(p);
}

template <class S>
void Walls<S>::constrain_acceleration(Patch<S>& patch, const PathMean& from, const PathMean& to,
                                      double dt) const {
    Velocities before(*this, from), after(*this, to);
    for (const Prescribed& p : prescribed_)
        patch.column(NodeField::acceleration, p.component)[p.node] =
            (after(p) - before(p)) / static_cast<Real>(dt);
}

template <class S>
template <class Value>
void Walls<S>::fill(Patch<S>& patch, NodeField field, const Value& prescribed, int level) const {
    for (auto face = faces_.rbegin(); face != faces_.rend(); ++face)
        for (int c = 0; c < S::dimension; ++c) {
            Real* v = patch.column(field, c);
            const int condition = face->condition[static_cast<std::size_t>(c)];
            for (const Link& link : face->links[static_cast<std::size_t>(level)]) {
                if (!face->wall) {
                    v[link.ghost] = 2 * v[link.edge] - v[link.inner];
                } else if (condition < 0) {
                    v[link.ghost] = v[link.inner];
                } else {
                    v[link.ghost] = 2 * prescribed(condition, c, link.position) - v[link.inner];
                }
            }
        }
}

template <class S>
void Walls<S>::fill_velocity(Patch<S>& patch, NodeField field, const PathMean& mean, int level) const {
    fill(
        patch, field,
        [&](int condition, int c, const Position& x) { return velocity(condition, x, mean)[c]; }, level);
}

template <class S>
void Walls<S>::fill_acceleration(Patch<S>& patch, const PathMean& from, const PathMean& to, double dt,
                                 int level) const {
    fill(
        patch, NodeField::acceleration,
        [&](int condition, int c, const Position& x) {
            return (velocity(condition, x, to)[c] - velocity(condition, x, from)[c]) / static_cast<Real>(dt);
        },
        level);
}

template <class S>
void Walls<S>::keep_ghosts(const Patch<S>& patch, NodeField field) {
    kept_ghosts_.clear();
    for (const Face& face : faces_)
        for (int c = 0; c < S::dimension; ++c) {
            if (face.condition[static_cast<std::size_t>(c)] < 0) continue;
            const Real* const v = patch.column(field, c);
            face.for_links([&](const Link& link) { kept_ghosts_.push_back(v[link.ghost]); });
        }
}

template <class S>
void Walls<S>::add_change_of_ghosts(Patch<S>& patch, NodeField field, const PathMean& mean,
                                    Real share) const {
    const Real* const mass = patch.column(NodeField::mass);
    auto before = kept_ghosts_.begin();
    for (const Face& face : faces_)
        for (int c = 0; c < S::dimension; ++c) {
            const int condition = face.condition[static_cast<std::size_t>(c)];
            if (condition < 0) continue;
            const Real* const v = patch.column(field, c);
            Real* const force = patch.column(NodeField::force, c);
            face.for_links([&](const Link& link) {
                force[link.ghost] +=
                    share * mass[link.ghost] *
                    (*before++ + v[link.inner] - 2 * velocity(condition, link.position, mean)[c]);
            });
        }
}

template <class S>
std::optional<Exit> Walls<S>::exit(const Face& face, const Patch<S>& patch, const Position& x,
                                   double time) const {
    const double inwards = face.side == 0 ? 1 : -1;
    const double distance = inwards * (face.place(patch) - x[face.axis]);
    if (!(distance > 0)) return {};
    Exit exit{face_name(face.axis, face.side), distance * patch.inverse_cell_size()[face.axis],
              Exit::Through::open};
    if (face.unilateral) exit.through = Exit::Through::closed;
    if (const int condition = face.condition[static_cast<std::size_t>(face.axis)]; condition >= 0)
        exit.through = inwards * static_cast<double>(velocity(condition, x, {time})[face.axis]) < 0
                           ? Exit::Through::outflow
                           : Exit::Through::closed;
    return exit;
}

template <class S>
std::optional<Exit> Walls<S>::exit(const Patch<S>& patch, const Position& x, double time) const {
    if (x.allFinite())
        for (const Face& face : faces_)
            if (auto own = exit(face, patch, x, time)) return own;
    return {};
}

template <class S>
bool Walls<S>::hold(const Patch<S>& patch, Particles<S>& particles, Index particle, double time) const {
    for (const Face& face : faces_) {
        const auto own = exit(face, patch, particles.position(particle), time);
        if (own && own->through == Exit::Through::closed && own->distance <= reach_of_walls)
            particles.set_value(Field::position, face.axis, particle, face.place(patch));
    }
    const Position x = particles.position(particle);
    return x.allFinite() && !exit(patch, x, time);
}

template <class S>
std::array<std::array<bool, 2>, 3> Walls<S>::mirrors() const {
    std::array<std::array<bool, 2>, 3> all{};
    for (const Face& face : faces_)
        all[static_cast<std::size_t>(face.axis)][static_cast<std::size_t>(face.side)] =
            face.condition[static_cast<std::size_t>(face.axis)] >= 0;
    return all;
}

template <class S>
void Walls<S>::reaction(const Patch<S>& patch, NodeField source, NodeField value, const PathMean& mean,
                        std::vector<Sum>& sums) const {
    const Real* mass = patch.column(NodeField::mass);
    const auto add = [&](int condition, int c, double amount, const Position& x) {
        Sum& sum = sums[static_cast<std::size_t>(condition)];
        sum.total[static_cast<std::size_t>(c)] += amount;
        sum.power += amount * static_cast<double>(velocity(condition, x, mean)[c]);
    };
    for (const Prescribed& p : prescribed_) {
        const Real* s = patch.column(source, p.component);
        const Real* v = patch.column(value, p.component);
        add(p.condition, p.component, static_cast<double>(mass[p.node] * v[p.node] - s[p.node]), p.position);
        if (mass[p.node] > 0) sums[static_cast<std::size_t>(p.condition)].held = true;
    }
    // A ghost's source was taken from its image within, which is pushed the other way by as much;
    // momentum was also given what the wall's own velocity brings (fold_momentum).
    const Real moving = value == NodeField::acceleration ? 0 : 2;
    for (const Face& face : faces_)
        for (int c = 0; c < S::dimension; ++c) {
            const int condition = face.condition[static_cast<std::size_t>(c)];
            if (condition < 0) continue;
            const Real* s = patch.column(source, c);
            const Real* v = patch.column(value, c);
            face.for_links([&](const Link& link) {
                add(condition, c,
                    static_cast<double>(mass[link.ghost] *
                                            (v[link.ghost] - v[link.inner] +
                                             moving * velocity(condition, link.position, mean)[c]) -
                                        2 * s[link.ghost]),
                    link.position);
            });
        }
}

#define MATPOINT_INSTANTIATE(S) template class Walls<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
