#include "run/result_folder.hpp"

#include "run/resource_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <string>

namespace matpoint {

namespace {

namespace fs = std::filesystem;

/// Who has the lock, where the system tells.
std::string holder(int descriptor) {
    struct stat folder {};
    fstat(descriptor, &folder);
    const std::string wanted =
        fmt::format("{:02x}:{:02x}:{}", major(folder.st_dev), minor(folder.st_dev), folder.st_ino);
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {
        // 1: FLOCK  ADVISORY  WRITE 4711 fe:00:1234 0 EOF
        std::istringstream fields(line);
        std::string number, kind, advisory, mode, process, place;
        fields >> number >> kind >> advisory >> mode >> process >> place;
        if (kind == "FLOCK" && place == wanted) return "process " + process;
    }
    return "another process";
}

}  // namespace

ResultFolder::ResultFolder(fs::path path) : path_(std::move(path)) {
    fs::create_directories(path_);
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0)
        throw fs::filesystem_error("can't open the folder", path_,
                                   std::error_code(errno, std::generic_category()));
    // File systems without locks are used all the same.
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    const std::string who = holder(descriptor_);
    ::close(descriptor_);
    throw ResourceError(
        fmt::format("{} writes its results into {}: wait until it has ended, or choose another "
                    "folder with --output",
                    who, path_.string()));
}

ResultFolder::~ResultFolder() {
    ::close(descriptor_);
}

void ResultFolder::expect_in_place() const {
    struct stat mine {
    }, there{};
    fstat(descriptor_, &mine);
    if (stat(path_.c_str(), &there) != 0)
        throw std::runtime_error(fmt::format("the folder {} was removed during the run", path_.string()));
    if (mine.st_ino != there.st_ino || mine.st_dev != there.st_dev)
        throw std::runtime_error(
            fmt::format("the folder {} is not the one any more that the run began in", path_.string()));
}

}  // namespace matpoint
