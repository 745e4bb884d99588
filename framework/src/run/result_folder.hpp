#pragma once

#include <filesystem>

namespace matpoint {

/// The folder that a run or a study writes into: made if it is missing, and nobody else's while this lives.
/// The lock is the system's, on the folder itself (flock): it leaves nothing behind, and goes with its
/// process.
class ResultFolder {
  public:
    /// Throws ResourceError if another process has it, std::filesystem::filesystem_error if it can't be made.
    explicit ResultFolder(std::filesystem::path path);
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    /// Throws std::runtime_error if somebody removed it, or put another one in its place.
    void expect_in_place() const;

  private:
    std::filesystem::path path_;
    int descriptor_;
};

}  // namespace matpoint
