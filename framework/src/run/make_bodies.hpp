#pragma once

#include <matpoint/geometry.hpp>

#include "run/assemble.hpp"
#include "run/maker.hpp"

#include <memory>
#include <vector>

namespace matpoint {

/// The bodies' geometries, in the scene's order; one that goes on for ever is a mistake.
template <class S>
std::vector<std::shared_ptr<Geometry>> make_geometries(Maker& maker);

/// Gives bodies the fields that the scene's components, outputs and checks ask for, and seeds them.
template <class S>
void make_bodies(Maker& maker, const std::vector<std::shared_ptr<Geometry>>& geometries,
                 Assembly<S>& assembly);

}  // namespace matpoint
