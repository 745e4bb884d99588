#pragma once

#include <filesystem>

namespace matpoint {

/// folder/checkpoint_<step, 8 digits>.h5
std::filesystem::path checkpoint_path(const std::filesystem::path& folder, long step);

/// Removes all checkpoints of a folder but the `keep` (at least 1) of the latest steps, and what a
/// killed run was writing.
void prune_checkpoints(const std::filesystem::path& folder, int keep);

/// Removes the checkpoints of later steps, which a run that starts at `step` replaces (-1: all).
void remove_checkpoints_after(const std::filesystem::path& folder, long step);

}  // namespace matpoint
