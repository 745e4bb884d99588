#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace matpoint {

/// Why a file can't be read from its beginning to its end: it is not there, a folder, a pipe or a device,
/// which may have no end, larger than `most_bytes`, or the system refuses. Empty if it can.
std::string why_unreadable(const std::filesystem::path& file,
                           std::uintmax_t most_bytes = std::numeric_limits<std::uintmax_t>::max());

/// The first bytes of a file, as many as there are up to `most_bytes`. Throws std::invalid_argument
/// "<file>: <why it can't be read>".
std::string read_beginning(const std::filesystem::path& file, std::size_t most_bytes);

/// All bytes of a file. Throws std::invalid_argument as read_beginning does.
std::string read_whole(const std::filesystem::path& file,
                       std::uintmax_t most_bytes = std::numeric_limits<std::uintmax_t>::max());

}  // namespace matpoint
