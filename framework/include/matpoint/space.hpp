#pragma once

#include <Eigen/Core>

#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace matpoint {

/// How the directions outside the grid behave.
/// `bar` (1D): free sides, so stress is uniaxial. `plane_strain` (2D): no strain along z.
/// `axisymmetric` (2D): x is the radius r, y the axis z; volumes are those of whole rings (2 pi r).
/// `solid` (3D).
enum class Mode { bar, plane_strain, axisymmetric, solid };

/// Dimension, mode and precision of a simulation, known when a component is compiled: a 1D scene
/// carries one component where a 3D scene carries nine.
template <int Dimension, Mode M, class R>
struct Space {
    static constexpr int dimension = Dimension;
    static constexpr Mode mode = M;
    static constexpr bool axisymmetric = M == Mode::axisymmetric;
    /// Whether tensors have a component normal to the plane (zz, or the hoop direction).
    static constexpr bool has_normal = Dimension == 2;
    /// Stored components of a deformation gradient: in-plane ones by column, then the hoop.
    static constexpr int deformation_size = Dimension * Dimension + (axisymmetric ? 1 : 0);
    /// Stored components of a stress: xx | xx yy zz xy | xx yy zz xy yz xz.
    static constexpr int stress_size = Dimension == 1 ? 1 : Dimension == 2 ? 4 : 6;

    using Real = R;
    static constexpr bool single = std::is_same_v<R, float>;
    using Vector = Eigen::Matrix<R, Dimension, 1>;
    /// Where something is, m: in double precision whatever R is, for far from the origin a cell is small.
    using Position = Eigen::Matrix<double, Dimension, 1>;
    using Matrix = Eigen::Matrix<R, Dimension, Dimension>;
};

/// Every space a component is compiled for; `MATPOINT_FOR_EACH_SPACE(X)` expands X(Space) for each.
using Bar = Space<1, Mode::bar, double>;
using PlaneStrain = Space<2, Mode::plane_strain, double>;
using Axisymmetric = Space<2, Mode::axisymmetric, double>;
using Solid = Space<3, Mode::solid, double>;
using BarSingle = Space<1, Mode::bar, float>;
using PlaneStrainSingle = Space<2, Mode::plane_strain, float>;
using AxisymmetricSingle = Space<2, Mode::axisymmetric, float>;
using SolidSingle = Space<3, Mode::solid, float>;

// MATPOINT_WITHOUT_SINGLE is defined by builds that were asked for double precision alone.
#ifdef MATPOINT_WITHOUT_SINGLE
inline constexpr bool has_single = false;
#define MATPOINT_FOR_EACH_SINGLE_SPACE(X)
#else
inline constexpr bool has_single = true;
#define MATPOINT_FOR_EACH_SINGLE_SPACE(X) \
    X(::matpoint::BarSingle)              \
    X(::matpoint::PlaneStrainSingle)      \
    X(::matpoint::AxisymmetricSingle)     \
    X(::matpoint::SolidSingle)
#endif
#define MATPOINT_FOR_EACH_SPACE(X) \
    X(::matpoint::Bar)             \
    X(::matpoint::PlaneStrain)     \
    X(::matpoint::Axisymmetric)    \
    X(::matpoint::Solid)           \
    MATPOINT_FOR_EACH_SINGLE_SPACE(X)

/// A space as a value, for code that is not compiled per space (the registry, the command line).
struct SpaceId {
    Mode mode = Mode::plane_strain;
    bool single = false;

    template <class S>
    static constexpr SpaceId of() {
        return {S::mode, S::single};
    }
    constexpr int dimension() const { return mode == Mode::bar ? 1 : mode == Mode::solid ? 3 : 2; }
    static constexpr int count = 8;
    constexpr int index() const { return static_cast<int>(mode) * 2 + (single ? 1 : 0); }
    friend constexpr bool operator==(SpaceId, SpaceId) = default;
};

/// Calls `function.template operator()<S>()` for the space that `id` names; returns its result. Throws
/// std::invalid_argument if it was not built for that.
template <class Function>
auto with_space(SpaceId id, Function&& function) {
    const auto call = [&]<class Double, class Single>() {
        if constexpr (has_single)
            if (id.single) return function.template operator()<Single>();
        if (id.single) throw std::invalid_argument("built without single precision");
        return function.template operator()<Double>();
    };
    switch (id.mode) {
        case Mode::bar:
            return call.template operator()<Bar, BarSingle>();
        case Mode::plane_strain:
            return call.template operator()<PlaneStrain, PlaneStrainSingle>();
        case Mode::axisymmetric:
            return call.template operator()<Axisymmetric, AxisymmetricSingle>();
        case Mode::solid:
            break;
    }
    return call.template operator()<Solid, SolidSingle>();
}

}  // namespace matpoint
