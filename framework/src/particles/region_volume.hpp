#pragma once

#include <matpoint/geometry.hpp>

#include <optional>

namespace matpoint {

/// Volume of a region, whatever the grid: m^D, of whole rings when axisymmetric. Exact for boxes and what is
/// put together from them, and to 1e-4 for what is round. Not known of lists of points and of regions without
/// end.
template <class S>
std::optional<double> volume_of(const Geometry& region);

}  // namespace matpoint
