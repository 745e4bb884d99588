#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace matpoint {

/// Length of the seal at the beginning of a checkpoint: HDF5's smallest user block, which HDF5 skips.
inline constexpr std::size_t seal_size = 512;

/// Writes the seal into the first bytes of a file's image: a text with the length and the checksum
/// (CRC-32) of what follows. HDF5 1.10 may crash on a damaged file, so damage is found before it.
void seal(std::span<char> image);

enum class SealState { absent, cut_short, damaged, whole };

/// Compares a file with its seal.
SealState examine_seal(const std::filesystem::path& file);

}  // namespace matpoint
