#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace matpoint {

/// The whole state of a run between two steps: what a run that goes on from it needs.
struct CheckpointData {
    std::string scene;   ///< the resolved scene, JSON text
    std::string folder;  ///< the scene's folder, which its file parameters are relative to
    long step = 0;
    double time = 0;                        ///< s
    std::map<std::string, double> numbers;  ///< accumulators of the run

    /// One component of a field for all particles, in the order in which the run stores them.
    struct Column {
        std::string field;
        int component = 0;
        std::variant<std::vector<float>, std::vector<double>> values;
    };
    struct Body {
        std::string name;
        std::int64_t size = 0;
        std::vector<Column> columns;
        std::vector<std::uint32_t> ids;
        std::vector<int> block_numbers;
        std::vector<std::int64_t> block_begins;
    };
    std::vector<Body> bodies;
    std::map<std::string, std::string> plugins;  ///< name -> version
};

/// A checkpoint can't be written or read; the text names the file, the reason and what to do.
class CheckpointError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Writes an HDF5 file that reads back bit for bit. It is written aside and gets its name when it is
/// on the disk: whatever happens, no half file carries the name, and an older one stays.
void write_checkpoint(const std::filesystem::path& file, const CheckpointData& data);
CheckpointData read_checkpoint(const std::filesystem::path& file);

}  // namespace matpoint
