#include <matpoint/input_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace matpoint {

namespace {

namespace fs = std::filesystem;

std::string what_it_is(fs::file_type type) {
    switch (type) {
        case fs::file_type::directory:
            return "a folder";
        case fs::file_type::fifo:
            return "a pipe";
        case fs::file_type::socket:
            return "a socket";
        default:
            return "a device";
    }
}

std::string read(const fs::path& file, std::uintmax_t bytes, std::uintmax_t most_bytes) {
    if (const std::string why = why_unreadable(file, most_bytes); !why.empty())
        throw std::invalid_argument(fmt::format("{}: {}", file.string(), why));
    std::ifstream stream(file, std::ios::binary);
    std::string text(static_cast<std::size_t>(std::min(bytes, fs::file_size(file))), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (stream.bad())
        throw std::invalid_argument(
            fmt::format("{}: can't be read: {}", file.string(), std::strerror(errno)));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

}  // namespace

std::string why_unreadable(const fs::path& file, std::uintmax_t most_bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) return "there is no such file";
    if (!fs::status_known(status)) return "can't be read: " + error.message();
    if (!fs::is_regular_file(status)) return fmt::format("is {}, not a file", what_it_is(status.type()));
    if (const std::uintmax_t size = fs::file_size(file, error); size > most_bytes)
        return fmt::format("has {} bytes, more than such a file can have ({})", size, most_bytes);
    errno = 0;
    if (!std::ifstream(file)) return fmt::format("can't be read: {}", std::strerror(errno));
    return {};
}

std::string read_beginning(const fs::path& file, std::size_t most_bytes) {
    return read(file, most_bytes, std::numeric_limits<std::uintmax_t>::max());
}

std::string read_whole(const fs::path& file, std::uintmax_t most_bytes) {
    return read(file, std::numeric_limits<std::uintmax_t>::max(), most_bytes);
}

}  // namespace matpoint
