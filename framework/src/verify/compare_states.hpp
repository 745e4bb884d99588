#pragma once

#include "run/checkpoint_file.hpp"

#include <string>

namespace matpoint {

/// Where two states first differ, bit for bit, in words; empty if they are the same. Scene, folder and
/// plugins are left out.
std::string first_difference(const CheckpointData& expected, const CheckpointData& found);

}  // namespace matpoint
