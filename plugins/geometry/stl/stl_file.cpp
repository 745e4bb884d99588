#include "stl_file.hpp"

#include <matpoint/input_file.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace matpoint {

namespace {

// A binary file is a header of 80 bytes, the number of triangles (4 bytes), and for each triangle its
// normal and its corners (12 numbers of 4 bytes) and 2 bytes more; all little-endian.
constexpr std::size_t header_size = 84, triangle_size = 50, corners_offset = 12;
static_assert(std::endian::native == std::endian::little,
              "the binary reader copies little-endian numbers as they are");

/// What the header says.
std::size_t binary_triangles(const std::string& data) {
    std::uint32_t count;
    std::memcpy(&count, data.data() + header_size - sizeof count, sizeof count);
    return count;
}

/// Binary files may begin with "solid" too; only text has a facet or an end soon after it.
bool looks_like_text(std::string_view start) {
    return start.substr(0, 256).find("solid") != std::string_view::npos &&
           (start.find("facet") != std::string_view::npos ||
            start.find("endsolid") != std::string_view::npos) &&
           start.find('\0') == std::string_view::npos;
}

std::vector<Triangle> read_binary(const std::string& data, const std::string& name) {
    std::vector<Triangle> triangles(binary_triangles(data));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Eigen::Vector3f& x = triangles[t][corner];
            std::memcpy(x.data(),
                        data.data() + header_size + triangle_size * t + corners_offset * (1 + corner), 12);
            if (!x.allFinite())
                throw std::invalid_argument(name + ": triangle " + std::to_string(t + 1) +
                                            " has a corner that is not finite");
        }
    return triangles;
}

/// Reads "solid … facet normal … outer loop vertex x y z (three) endloop endfacet … endsolid", line by line.
class TextReader {
  public:
    TextReader(const std::string& data, const std::string& name) : in_(data), name_(name) {}

    std::vector<Triangle> read() {
        expect_line("solid");
        while (true) {
            next_line("facet\" or \"endsolid");
            if (starts_with("endsolid")) {
                if (!next_solid()) return triangles_;
                continue;
            }
            if (!starts_with("facet")) fail("facet\" or \"endsolid");
            expect_line("outer");
            Triangle triangle;
            for (Eigen::Vector3f& corner : triangle) corner = read_vertex();
            expect_line("endloop");
            expect_line("endfacet");
            triangles_.push_back(triangle);
        }
    }

  private:
    /// Goes to the next line that is not blank; false at the end of the file.
    bool advance() {
        while (std::getline(in_, line_)) {
            ++number_;
            const std::size_t first = line_.find_first_not_of(" \t\r");
            if (first == std::string::npos) continue;
            line_.erase(0, first);
            line_.erase(line_.find_last_not_of(" \t\r") + 1);
            return true;
        }
        return false;
    }
    void next_line(const char* expected) {
        if (!advance())
            throw std::invalid_argument(name_ + " ends after line " + std::to_string(number_) + " and " +
                                        std::to_string(triangles_.size()) + " complete facets, where \"" +
                                        expected + "\" was expected: it seems truncated");
    }
    void expect_line(const char* keyword) {
        next_line(keyword);
        if (!starts_with(keyword)) fail(keyword);
    }
    bool next_solid() {
        if (!advance()) return false;
        if (!starts_with("solid")) fail("solid");
        return true;
    }
    bool starts_with(std::string_view keyword) const {
        return std::string_view(line_).substr(0, line_.find_first_of(" \t")) == keyword;
    }
    [[noreturn]] void fail(const char* expected) const {
        throw std::invalid_argument(name_ + ":" + std::to_string(number_) + ": expected \"" + expected +
                                    "\", found \"" + line_.substr(0, 60) + "\"");
    }
    Eigen::Vector3f read_vertex() {
        expect_line("vertex");
        const char* at = line_.data() + std::strlen("vertex");
        const char* const end = line_.data() + line_.size();
        Eigen::Vector3f x;
        for (float& value : x) {
            while (at != end && (*at == ' ' || *at == '\t' || *at == '+')) ++at;
            const auto [stop, error] = std::from_chars(at, end, value);
            if (error != std::errc() || !std::isfinite(value))
                fail("vertex\" and three finite numbers, \"vertex x y z");
            at = stop;
        }
        if (at != end) fail("vertex\" and three finite numbers, \"vertex x y z");
        return x;
    }

    std::istringstream in_;
    std::string name_, line_;
    long number_ = 0;
    std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> read_stl_file(const std::filesystem::path& file) {
    const std::string name = file.string();
    const std::string start = read_beginning(file, 1024);
    const std::uintmax_t size = std::filesystem::file_size(file);

    std::vector<Triangle> triangles;
    if (start.empty()) throw std::invalid_argument(name + " is empty; expected an STL file, binary or ASCII");
    if (size >= header_size && size == header_size + triangle_size * binary_triangles(start)) {
        triangles = read_binary(read_whole(file), name);
    } else if (looks_like_text(start)) {
        triangles = TextReader(read_whole(file), name).read();
    } else if (size < header_size) {
        throw std::invalid_argument(name + " has " + std::to_string(size) +
                                    " bytes and is not ASCII STL; a binary STL file has at least 84");
    } else {
        const std::size_t count = binary_triangles(start);
        throw std::invalid_argument(
            name + ": its header announces " + std::to_string(count) + " triangles, which take " +
            std::to_string(header_size + triangle_size * count) + " bytes, but the file has " +
            std::to_string(size) + ": it is truncated, or not an STL file");
    }
    if (triangles.empty()) throw std::invalid_argument(name + " has no triangles");
    return triangles;
}

}  // namespace matpoint
