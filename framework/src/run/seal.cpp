#include "run/seal.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace matpoint {

namespace {

constexpr const char* seal_name = "Matpoint checkpoint";

std::string seal_text(std::uint64_t bytes, std::uint32_t checksum) {
    std::string text = fmt::format("{}\nbytes {}\nCRC-32 {:08x}\n", seal_name, bytes, checksum);
    text.resize(seal_size, '\0');
    return text;
}

}  // namespace

void seal(std::span<char> image) {
    const std::span<char> contents = image.subspan(seal_size);
    boost::crc_32_type checksum;
    checksum.process_bytes(contents.data(), contents.size());
    const std::string text = seal_text(contents.size(), checksum.checksum());
    std::memcpy(image.data(), text.data(), seal_size);
}

SealState examine_seal(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string found(seal_size, '\0');
    stream.read(found.data(), seal_size);
    const std::string first_lines = fmt::format("{}\nbytes ", seal_name);
    if (!found.starts_with(first_lines)) return SealState::absent;
    const std::uint64_t expected = std::strtoull(found.c_str() + first_lines.size(), nullptr, 10);

    const std::uintmax_t size = std::filesystem::file_size(file);
    if (size < seal_size + expected) return SealState::cut_short;
    if (size > seal_size + expected) return SealState::damaged;

    boost::crc_32_type checksum;
    std::vector<char> buffer(1024 * 1024);
    while (stream) {
        stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        checksum.process_bytes(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    }
    return found == seal_text(expected, checksum.checksum()) ? SealState::whole : SealState::damaged;
}

}  // namespace matpoint
