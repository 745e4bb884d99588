#pragma once

#include <matpoint/registry.hpp>

namespace matpoint {

/// Another registry whose materials, in the plane, leave no stress along the normal: the mode plane_stress.
/// They have one variable more, `thickness_strain`, what the thickness has grown by over that of the start.
///
/// That works with any material, for each is compiled for axisymmetric bodies too, whose tensors have a
/// strain along the normal. Of this strain the one is sought, particle by particle, with which the material's
/// own stress along the normal vanishes; its own variables are those of the last trial alone.
Registry with_plane_stress(const Registry& registry);

}  // namespace matpoint
