#pragma once

namespace matpoint {

/// The particle fields that bodies have where the grid has levels: how often the distance of particles was
/// halved, by seeding or splitting, and the level that a particle is on.
inline constexpr const char* refinement_field = "refinement";
inline constexpr const char* level_field = "level";

}  // namespace matpoint
