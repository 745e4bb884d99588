#include "contact/pairs.hpp"

#include "contact/normals.hpp"

#include <algorithm>
#include <cmath>

namespace matpoint {

namespace {
/// Where more than two bodies meet: until impulses change by less than this part, or so many sweeps are done.
constexpr double agreement = 1e-10;
constexpr int most_sweeps = 200;
/// Cells; a layer that has less around a node is not there: what is measured of it is rounding.
constexpr double least_size = 1e-5;
}  // namespace

template <class S>
ContactPairs<S>::ContactPairs(std::vector<PlacedContact<S>> contacts, ContactLayers layers,
                              const Patch<S>& patch, const ShapeFunction<S>& shape)
    : contacts_(std::move(contacts)),
      layers_(std::move(layers)),
      nodes_(patch, shape),
      cell_size_(patch.cell_size()),
      reports_(contacts_.size()) {
    for (const PlacedContact<S>& placed : contacts_)
        if (placed.contact->law())
            needs_neighbours_ = needs_neighbours_ || placed.rule.normal == PairRule::Normal::regression ||
                                placed.rule.gap == PairRule::Gap::particles;
}

template <class S>
void ContactPairs<S>::orient() {
    pairs_.clear();
    for (const auto& node : nodes_.nodes()) {
        const Vector cell_size = std::ldexp(1.0, -node.level) * cell_size_;
        for (std::size_t i = node.begin; i < node.end; ++i)
            for (std::size_t j = i + 1; j < node.end; ++j) {
                const auto& shares = nodes_.shares();
                if (std::min(shares[i].size, shares[j].size) < least_size) continue;
                const std::size_t first = shares[i].layer, second = shares[j].layer;
                const auto law = static_cast<std::size_t>(layers_.law_between(first, second));
                const PlacedContact<S>& placed = contacts_[law];
                Vector normal;
                if (placed.rule.normal == PairRule::Normal::fixed) {
                    const double sign = layers_.layer[placed.bodies.front()] == second ? -1 : 1;
                    normal = sign * placed.rule.fixed.template head<S::dimension>();
                } else {
                    normal = contact_normal(placed.rule, nodes_, i, j);
                }
                pairs_.push_back({.first = i,
                                  .second = j,
                                  .law = law,
                                  .normal = normal,
                                  .gap = contact_gap<S>(placed.rule, nodes_, i, j, normal, cell_size),
                                  .cell = cell_size.minCoeff(),
                                  .alone = node.end == node.begin + 2});
            }
    }
}

/// 1/kg, by component; 0 where a boundary condition holds the node.
template <class S>
auto ContactPairs<S>::inverse_mass(std::size_t share) const -> Vector {
    const auto& own = nodes_.shares()[share];
    Vector inverse;
    for (int c = 0; c < S::dimension; ++c)
        inverse[c] = (prescribed_[static_cast<std::size_t>(own.place)] >> c & 1) != 0 ? 0.0 : 1 / own.mass;
    return inverse;
}

/// As the pair would move with the velocities of both as they are.
template <class S>
auto ContactPairs<S>::point_of(const Pair& pair, double dt) const -> Point {
    using Real = typename S::Real;
    const Vector inverse = inverse_mass(pair.first) + inverse_mass(pair.second);  // of what an impulse does
    const auto free = (inverse.array() > 0).template cast<double>().matrix().eval();
    const Vector along = pair.normal.cwiseProduct(free);
    const double size = along.norm(), yielding = along.dot(inverse.cwiseProduct(along));
    Point point{};
    point.normal = point.velocity = point.sticking = S::Vector::Zero();
    if (free.isZero(0)) return point;
    const Vector relative = velocity_[pair.second] - velocity_[pair.first];
    point.gap = static_cast<Real>(pair.gap);
    point.mass = static_cast<Real>(free.sum() / inverse.sum());
    point.velocity = relative.cwiseProduct(free).template cast<Real>();
    point.dt = static_cast<Real>(dt);
    if (!(size > 1e-6)) return point;  // nothing tells where they press, or what holds them takes it all
    // They may close by what lies between them.
    const double lacks = -std::max(pair.gap, 0.0) / dt - pair.normal.dot(relative);
    const double pressing = std::max(lacks / yielding, 0.0);
    const Vector normal = along / size;
    Vector sliding = (relative + pressing * inverse.cwiseProduct(along)).cwiseProduct(free);
    sliding -= normal * normal.dot(sliding);
    point.normal = normal.template cast<Real>();
    point.pressing = static_cast<Real>(pressing * size);
    point.sticking = (-sliding * (size * size / yielding)).template cast<Real>();
    return point;
}

template <class S>
void ContactPairs<S>::apply(const Pair& pair, double sign) {
    velocity_[pair.first] -= sign * inverse_mass(pair.first).cwiseProduct(pair.impulse);
    velocity_[pair.second] += sign * inverse_mass(pair.second).cwiseProduct(pair.impulse);
}

template <class S>
void ContactPairs<S>::resolve_alone(double dt) {
    for (std::size_t law = 0; law < contacts_.size(); ++law) {
        if (!contacts_[law].contact->law()) continue;
        alone_.clear();
        points_.clear();
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            if (!pairs_[k].alone || pairs_[k].law != law) continue;
            const Point point = point_of(pairs_[k], dt);
            if (!(point.mass > 0)) continue;
            alone_.push_back(k);
            points_.push_back(point);
        }
        if (points_.empty()) continue;
        impulses_.assign(points_.size(), S::Vector::Zero());
        const ContactLaw<S>& own = *contacts_[law].contact->law();
        guarded(own, "impulses", [&] { own.impulses(points_, impulses_); });
        for (std::size_t k = 0; k < alone_.size(); ++k) {
            Pair& pair = pairs_[alone_[k]];
            pair.impulse = impulses_[k].template cast<double>();
            apply(pair, 1);
        }
    }
}

/// Pair by pair, each with what the others have done so far, until that no longer changes.
template <class S>
void ContactPairs<S>::resolve_together(double dt) {
    for (std::size_t begin = 0; begin < pairs_.size();) {
        // Pairs of one node share the first or follow each other: their shares are within one node.
        std::size_t end = begin + 1;
        const auto node = std::ranges::upper_bound(nodes_.nodes(), pairs_[begin].first, {},
                                                   [](const auto& n) { return n.begin; }) -
                          1;
        while (end < pairs_.size() && pairs_[end].first < node->end) ++end;
        for (int sweep = 0; sweep < most_sweeps && !pairs_[begin].alone; ++sweep) {
            double change = 0, largest = 0;
            for (std::size_t k = begin; k < end; ++k) {
                Pair& pair = pairs_[k];
                const Vector before = pair.impulse;
                apply(pair, -1);
                const Point point = point_of(pair, dt);
                typename S::Vector impulse = S::Vector::Zero();
                const ContactLaw<S>& law = *contacts_[pair.law].contact->law();
                if (point.mass > 0)
                    guarded(law, "impulses", [&] { law.impulses({&point, 1}, {&impulse, 1}); });
                pair.impulse = impulse.template cast<double>();
                apply(pair, 1);
                change = std::max(change, (pair.impulse - before).norm());
                largest = std::max(largest, pair.impulse.norm());
            }
            if (!(change > agreement * largest)) break;
        }
        begin = end;
    }
}

template <class S>
void ContactPairs<S>::resolve(std::span<const Vector> velocity, std::span<const unsigned char> prescribed,
                              double dt, std::vector<Change>& change) {
    velocity_.assign(velocity.begin(), velocity.end());
    prescribed_ = prescribed;
    for (Pair& pair : pairs_) pair.impulse = Vector::Zero();
    resolve_alone(dt);
    resolve_together(dt);
    change.resize(velocity.size());
    for (std::size_t k = 0; k < velocity.size(); ++k)
        change[k] = {velocity_[k] - velocity[k], Vector::Zero()};
    for (const Pair& pair : pairs_) {
        change[pair.first].impulse -= pair.impulse;
        change[pair.second].impulse += pair.impulse;
    }
}

template <class S>
void ContactPairs<S>::report(std::span<const Vector> start, double dt) {
    for (const Pair& pair : pairs_) {
        if (pair.impulse.isZero(0)) continue;
        const PlacedContact<S>& placed = contacts_[pair.law];
        ContactReport& own = reports_[pair.law];
        const std::size_t first = layers_.layer[placed.bodies.front()];
        const double sign = nodes_.shares()[pair.first].layer == first    ? -1
                            : nodes_.shares()[pair.second].layer == first ? 1
                                                                          : 0;
        for (int c = 0; c < S::dimension; ++c) {
            own.force[static_cast<std::size_t>(c)] += sign * pair.impulse[c] / dt;
            own.impulse[static_cast<std::size_t>(c)] += sign * pair.impulse[c];
        }
        const Vector across = pair.impulse - pair.normal * pair.normal.dot(pair.impulse);
        const Vector sliding =
            velocity_[pair.second] - velocity_[pair.first] + start[pair.second] - start[pair.first];
        own.friction_work -= across.dot(sliding) / 2;
        own.penetration = std::max(own.penetration, -pair.gap / pair.cell);
        if (own.touched == 0) own.first_gap = pair.gap / pair.cell;
        own.touched = 1;
    }
}

#define MATPOINT_INSTANTIATE(S) template class ContactPairs<S>;
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
