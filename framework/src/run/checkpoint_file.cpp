#include "run/checkpoint_file.hpp"

#include <matpoint/input_file.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

#include "run/hdf5_file.hpp"
#include "run/seal.hpp"

namespace matpoint {

namespace fs = std::filesystem;

namespace {

constexpr const char* format_name = "matpoint-checkpoint";
constexpr std::int64_t format_version = 2;

void write_body(hid_t parent, const std::string& name, const CheckpointData::Body& body) {
    const hdf5::Handle group = hdf5::create_group(parent, name);
    hdf5::write_attribute(group, "name", body.name);
    hdf5::write_attribute(group, "size", body.size);
    hdf5::write_attribute(group, "columns", static_cast<std::int64_t>(body.columns.size()));
    hdf5::write_list(group, "ids", body.ids.data(), body.ids.size());
    hdf5::write_list(group, "block_numbers", body.block_numbers.data(), body.block_numbers.size());
    hdf5::write_list(group, "block_begins", body.block_begins.data(), body.block_begins.size());
    for (std::size_t c = 0; c < body.columns.size(); ++c) {
        const hdf5::Handle column = hdf5::create_group(group, "column_" + std::to_string(c));
        hdf5::write_attribute(column, "field", body.columns[c].field);
        hdf5::write_attribute(column, "component", static_cast<std::int64_t>(body.columns[c].component));
        std::visit(
            [&](const auto& values) { hdf5::write_list(column, "values", values.data(), values.size()); },
            body.columns[c].values);
    }
}

void write_data(hid_t file, const CheckpointData& data) {
    hdf5::write_attribute(file, "format", format_name);
    hdf5::write_attribute(file, "version", format_version);
    hdf5::write_attribute(file, "folder", data.folder);
    hdf5::write_attribute(file, "step", static_cast<std::int64_t>(data.step));
    hdf5::write_attribute(file, "time", data.time);
    hdf5::write_attribute(file, "bodies", static_cast<std::int64_t>(data.bodies.size()));
    hdf5::write_list(file, "scene", data.scene.data(), data.scene.size());
    const hdf5::Handle numbers = hdf5::create_group(file, "numbers");
    for (const auto& [name, value] : data.numbers) hdf5::write_attribute(numbers, name, value);
    const hdf5::Handle plugins = hdf5::create_group(file, "plugins");
    for (const auto& [name, version] : data.plugins) hdf5::write_attribute(plugins, name, version);
    for (std::size_t b = 0; b < data.bodies.size(); ++b)
        write_body(file, "body_" + std::to_string(b), data.bodies[b]);
}

CheckpointData::Body read_body(hid_t parent, const std::string& name) {
    const hdf5::Handle group = hdf5::open_group(parent, name);
    CheckpointData::Body body;
    body.name = hdf5::read_text(group, "name");
    body.size = hdf5::read_integer(group, "size");
    body.ids = hdf5::read_list<std::uint32_t>(group, "ids");
    body.block_numbers = hdf5::read_list<int>(group, "block_numbers");
    body.block_begins = hdf5::read_list<std::int64_t>(group, "block_begins");
    const std::int64_t columns = hdf5::read_integer(group, "columns");
    for (std::int64_t c = 0; c < columns; ++c) {
        const hdf5::Handle column = hdf5::open_group(group, "column_" + std::to_string(c));
        CheckpointData::Column& to = body.columns.emplace_back();
        to.field = hdf5::read_text(column, "field");
        to.component = static_cast<int>(hdf5::read_integer(column, "component"));
        if (hdf5::holds<float>(column, "values"))
            to.values = hdf5::read_list<float>(column, "values");
        else
            to.values = hdf5::read_list<double>(column, "values");
    }
    return body;
}

CheckpointData read_data(hid_t file) {
    CheckpointData data;
    data.folder = hdf5::read_text(file, "folder");
    data.step = static_cast<long>(hdf5::read_integer(file, "step"));
    data.time = hdf5::read_number(file, "time");
    const std::vector<char> scene = hdf5::read_list<char>(file, "scene");
    data.scene.assign(scene.begin(), scene.end());
    const hdf5::Handle numbers = hdf5::open_group(file, "numbers");
    for (const std::string& name : hdf5::attribute_names(numbers))
        data.numbers[name] = hdf5::read_number(numbers, name);
    const hdf5::Handle plugins = hdf5::open_group(file, "plugins");
    for (const std::string& name : hdf5::attribute_names(plugins))
        data.plugins[name] = hdf5::read_text(plugins, name);
    const std::int64_t bodies = hdf5::read_integer(file, "bodies");
    for (std::int64_t b = 0; b < bodies; ++b)
        data.bodies.push_back(read_body(file, "body_" + std::to_string(b)));
    return data;
}

[[noreturn]] void throw_errno() {
    throw std::system_error(errno, std::generic_category());
}

class Descriptor {
  public:
    Descriptor(const fs::path& path, int flags) : id_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
        if (id_ < 0) throw_errno();
    }
    ~Descriptor() { ::close(id_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(id_, bytes.data(), bytes.size());
            if (written >= 0)
                bytes.remove_prefix(static_cast<std::size_t>(written));
            else if (errno != EINTR)
                throw_errno();
        }
    }
    /// Waits until the operating system has put the file, or the names in a folder, on the disk.
    void sync() {
        if (::fsync(id_) != 0) throw_errno();
    }

  private:
    int id_;
};

/// What can be told before HDF5 opens the file.
void expect_whole(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored))
        throw CheckpointError(
            fmt::format("checkpoint {} is a folder: name the .h5 file in it", file.string()));
    if (const std::string why = why_unreadable(file); !why.empty())
        throw CheckpointError(fmt::format("checkpoint {}: {}", file.string(), why));
    switch (examine_seal(file)) {
        case SealState::absent:
            throw CheckpointError(file.string() +
                                  (H5Fis_hdf5(file.c_str()) > 0
                                       ? " is an HDF5 file, but not a checkpoint that Matpoint wrote"
                                       : " is not a checkpoint: it is not even an HDF5 file"));
        case SealState::cut_short:
            throw CheckpointError(
                fmt::format("checkpoint {} is cut short: go on from an older one", file.string()));
        case SealState::damaged:
            throw CheckpointError(fmt::format(
                "checkpoint {} is damaged, its checksum is wrong: go on from an older one", file.string()));
        case SealState::whole:
            break;
    }
}

void expect_version(const fs::path& file, hid_t id) {
    const std::int64_t version = hdf5::read_integer(id, "version");
    if (version > format_version)
        throw CheckpointError(
            fmt::format("checkpoint {} has format version {}, and this Matpoint reads versions up to {}: "
                        "use the newer Matpoint that wrote it",
                        file.string(), version, format_version));
    if (version < format_version)
        throw CheckpointError(fmt::format(
            "checkpoint {} has format version {}, whose particles carry other fields than those of "
            "version {}: use the Matpoint that wrote it, or run from the start",
            file.string(), version, format_version));
}

}  // namespace

void write_checkpoint(const fs::path& file, const CheckpointData& data) {
    const hdf5::Quiet quiet;
    fs::path aside = file;
    aside += ".tmp";
    try {
        hdf5::MemoryFile file_image(seal_size);
        write_data(file_image, data);
        const std::span<char> image = file_image.finish();
        seal(image);
        Descriptor written(aside, O_WRONLY | O_CREAT | O_TRUNC);
        written.write({image.data(), image.size()});
        written.sync();
        fs::rename(aside, file);
        Descriptor(fs::absolute(file).parent_path(), O_RDONLY).sync();
    } catch (const std::exception& error) {
        std::error_code ignored;
        fs::remove(aside, ignored);
        const auto* system = dynamic_cast<const std::system_error*>(&error);
        throw CheckpointError(fmt::format("can't write checkpoint {}: {}", file.string(),
                                          system ? system->code().message() : error.what()));
    }
}

CheckpointData read_checkpoint(const fs::path& file) {
    const hdf5::Quiet quiet;
    expect_whole(file);
    try {
        const hdf5::Handle id = hdf5::open_file(file.string());
        expect_version(file, id);
        return read_data(id);
    } catch (const CheckpointError&) {
        throw;
    } catch (const std::exception& error) {
        throw CheckpointError(fmt::format("checkpoint {} can't be read ({}): go on from an older one",
                                          file.string(), error.what()));
    }
}

}  // namespace matpoint
