#include "run/memory.hpp"

#include "run/resource_error.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>

namespace matpoint {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// What /proc/meminfo says, bytes.
double free_memory() {
    std::ifstream file("/proc/meminfo");
    double sum = 0;
    for (std::string line; std::getline(file, line);)
        for (const std::string_view name : {"MemAvailable:", "SwapFree:"})
            if (line.starts_with(name)) sum += 1024 * std::stod(line.substr(name.size()));
    return sum > 0 ? sum : no_limit;
}

/// A number in a file; no limit if there is none ("max").
double number_in(const std::filesystem::path& file) {
    double number = no_limit;
    if (double read = 0; std::ifstream(file) >> read) number = read;
    return number;
}

/// Of the control groups that the process is in, of both versions of them.
double group_limit() {
    double limit = no_limit;
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        // 0::/user/session or 4:memory:/user/session
        const bool unified = line.starts_with("0::");
        const std::size_t controllers = line.find(":memory:");
        if (!unified && controllers == line.npos) continue;
        const std::filesystem::path root = unified ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
        std::filesystem::path group = line.substr(line.find('/'));
        for (;; group = group.parent_path()) {
            const auto folder = root / group.relative_path();
            limit = std::min(limit, number_in(folder / (unified ? "memory.max" : "memory.limit_in_bytes")));
            if (group == group.root_path()) break;
        }
    }
    return limit;
}

}  // namespace

std::string memory_text(double bytes) {
    constexpr std::array<const char*, 6> units{"kB", "MB", "GB", "TB", "PB", "EB"};
    std::size_t unit = 0;
    for (bytes /= 1e3; bytes >= 999.5 && unit + 1 < units.size(); bytes /= 1e3) ++unit;
    return fmt::format("{:.3g} {}", bytes, units[unit]);
}

double available_memory() {
    double least = std::min(free_memory(), group_limit());
    for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
        rlimit limit{};
        if (getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
            least = std::min(least, static_cast<double>(limit.rlim_cur));
    }
    return least;
}

void MemoryBudget::add(const std::string& body, double particles, double bytes_per_particle) {
    const double bytes = particles * bytes_per_particle;
    if (exceeded_by(bytes))
        throw ResourceError(fmt::format(
            "not enough memory for body \"{}\": about {:.3g} particles of {} bytes take {}{}, and there are "
            "{}: take "
            "larger cells or fewer particles per cell",
            body, particles, bytes_per_particle, memory_text(bytes),
            taken_ > 0 ? fmt::format(", beside {} for the bodies before it", memory_text(taken_)) : "",
            memory_text(available_)));
    taken_ += bytes;
}

}  // namespace matpoint
