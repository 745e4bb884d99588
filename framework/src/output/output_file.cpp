#include <matpoint/input_file.hpp>
#include <matpoint/output_file.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <regex>
#include <set>
#include <stdexcept>

namespace matpoint {

namespace {

/// Ends the name of a file that is being written.
constexpr std::string_view unfinished = ".tmp";

[[noreturn]] void throw_not_written(const std::filesystem::path& file, int error) {
    throw std::runtime_error(
        fmt::format("can't write {}: {}", file.string(), error ? std::strerror(error) : "the stream failed"));
}

/// Adds text to a file of `size` bytes. If that fails the file is as it was: half a number would be a wrong
/// one.
void append_to(const std::filesystem::path& file, std::uintmax_t& size, std::string_view text) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (descriptor < 0) throw_not_written(file, errno);
    struct stat status {};
    if (fstat(descriptor, &status) != 0 || static_cast<std::uintmax_t>(status.st_size) != size) {
        ::close(descriptor);
        throw std::runtime_error(
            fmt::format("can't write {}: somebody else changed it during the run", file.string()));
    }
    int error = 0;
    for (std::string_view left = text; !left.empty() && error == 0;) {
        const ssize_t written = ::write(descriptor, left.data(), left.size());
        if (written >= 0)
            left.remove_prefix(static_cast<std::size_t>(written));
        else if (errno != EINTR)
            error = errno;
    }
    if (error != 0 && ftruncate(descriptor, static_cast<off_t>(size)) != 0) error = errno;
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error != 0) throw_not_written(file, error);
    size += text.size();
}

}  // namespace

std::string number_text(double value, int digits) {
    std::array<char, 40> text;
    char* const end = text.data() + text.size();
    const auto result = digits >= 17
                            ? std::to_chars(text.data(), end, value)
                            : std::to_chars(text.data(), end, value, std::chars_format::general, digits);
    return {text.data(), result.ptr};
}

OutputFile::OutputFile(std::filesystem::path file) : file_(std::move(file)), aside_(file_) {
    aside_ += unfinished;
    errno = 0;
    stream_.open(aside_, std::ios::binary | std::ios::trunc);
    if (!stream_) throw_not_written(file_, errno);
}

OutputFile::~OutputFile() {
    stream_.close();
    std::error_code ignored;  // there is nothing to remove after commit()
    std::filesystem::remove(aside_, ignored);
}

void OutputFile::write(std::string_view text) {
    errno = 0;
    if (!stream_.write(text.data(), static_cast<std::streamsize>(text.size())))
        throw_not_written(file_, errno);
}

void OutputFile::commit() {
    errno = 0;
    stream_.close();
    if (!stream_) throw_not_written(file_, errno);
    std::error_code error;
    std::filesystem::rename(aside_, file_, error);
    if (error) throw_not_written(file_, error.value());
}

void TimeTable::open(const std::filesystem::path& file, const std::vector<std::string>& columns,
                     double resumed_at) {
    file_ = file;
    rows_ = 0;
    const std::string header = fmt::format("{}\n", fmt::join(columns, ","));
    std::string kept = header;
    if (resumed_at >= 0 && std::filesystem::exists(file)) {
        if (const std::string why = why_unreadable(file); !why.empty())
            throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
        std::ifstream old(file);
        std::string line;
        if (std::getline(old, line) && line + "\n" != header)
            throw std::runtime_error(
                fmt::format("{} has the columns {}, but the run that resumes would write {}: choose another "
                            "folder or name",
                            file.string(), line, fmt::join(columns, ",")));
        // A last row without its end of line is one that a killed run did not finish.
        while (std::getline(old, line) && !old.eof()) {
            double time = 0;
            const auto parsed = std::from_chars(line.data(), line.data() + line.size(), time);
            if (parsed.ec != std::errc() || time > resumed_at) break;
            kept += line + "\n";
            last_time_ = time;
            ++rows_;
        }
    }
    OutputFile begun(file);
    begun.write(kept);
    begun.commit();
    size_ = kept.size();
}

void TimeTable::append(double time, const std::vector<std::string>& values) {
    if (ends_at(time)) return;
    append_to(file_, size_, fmt::format("{},{}\n", number_text(time), fmt::join(values, ",")));
    last_time_ = time;
    ++rows_;
}

void add_file_name(Schema& schema, ParameterOptions options, const std::vector<std::string>& files) {
    schema.text("name", std::move(options));
    schema.refuse("/name", "a file name is expected: letters, digits, \"_\", \"-\" and \".\"",
                  [](const Json& own, const Json&) {
                      static const std::regex plain("[A-Za-z0-9_.-]+");
                      return !std::regex_match(own.at("name").get<std::string>(), plain);
                  });
    for (const std::string& file : files) schema.writes(file);
}

void remove_numbered(const std::filesystem::path& folder, const std::string& before, const std::string& after,
                     std::size_t first) {
    static const std::regex digits("\\d{6,18}");
    std::vector<std::filesystem::path> found;
    std::error_code missing;  // the first write tells
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        const std::string name = entry.path().filename().string();
        const std::string_view end = name.ends_with(unfinished) ? unfinished : "";
        if (!name.starts_with(before) || !name.ends_with(after + std::string(end))) continue;
        if (name.size() < before.size() + after.size() + end.size()) continue;
        const std::string number =
            name.substr(before.size(), name.size() - before.size() - after.size() - end.size());
        if (std::regex_match(number, digits) && std::stoull(number) >= first && !entry.is_symlink())
            found.push_back(entry.path());
    }
    for (const std::filesystem::path& file : found) std::filesystem::remove(file);
}

std::vector<std::string> observed_bodies(const RunView& run, const std::string& body) {
    return body.empty() ? run.bodies() : std::vector<std::string>{body};
}

bool has_field(const RunView& run, const std::string& body, const std::string& field) {
    const std::vector<std::string> fields = run.fields(body);
    return std::find(fields.begin(), fields.end(), field) != fields.end();
}

void expect_field(const RunView& run, const std::vector<std::string>& bodies, const std::string& field) {
    std::set<std::string> known;
    for (const std::string& body : bodies)
        for (std::string& name : run.fields(body)) known.insert(std::move(name));
    if (known.count(field)) return;
    throw std::runtime_error(
        fmt::format("an output asks for the field \"{}\", which {} not carry; there are: {}", field,
                    bodies.size() == 1 ? "body \"" + bodies.front() + "\" does" : "the bodies do",
                    fmt::join(known, ", ")));
}

}  // namespace matpoint
