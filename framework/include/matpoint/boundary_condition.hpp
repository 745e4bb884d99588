#pragma once

#include <matpoint/registry.hpp>
#include <matpoint/space.hpp>

#include <array>
#include <optional>

namespace matpoint {

/// A prescribed velocity on faces of the grid, in a region or of a part of a body (the parameter `on`, which
/// the kernel turns into nodes). On a face it is a wall: ghost nodes mirror the nodes within, components that
/// are prescribed odd about the prescribed velocity, the others even.
template <class S>
class BoundaryCondition : public Component {
  public:
    using Space = S;
    using Vector = typename S::Vector;
    using Position = typename S::Position;

    /// Which components of velocity are prescribed at nodes of a face normal to `axis`; -1: elsewhere.
    virtual std::array<bool, 3> prescribes(int axis) const = 0;
    /// The velocity, m/s; components that are not prescribed are ignored. Time in s.
    virtual Vector velocity(const Position&, double) const { return Vector::Zero(); }
    /// Coefficient of friction of a face that pushes and rubs but does not pull. Such a condition prescribes
    /// nothing.
    virtual std::optional<double> friction() const { return {}; }
    /// Time (s) from which on nothing is moved; infinite if something always is. A scene does not end at rest
    /// before.
    virtual double settled_at() const { return 0; }
};

}  // namespace matpoint
