#include "run/rotation.hpp"

#include <fmt/format.h>

#include <map>
#include <regex>
#include <string>
#include <vector>

namespace matpoint {

namespace fs = std::filesystem;

namespace {

/// The checkpoints of a folder by step.
std::map<long, fs::path> checkpoints_in(const fs::path& folder) {
    static const std::regex pattern(R"(checkpoint_(\d{8,18})\.h5)");
    std::map<long, fs::path> found;
    std::smatch match;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (std::regex_match(name, match, pattern)) found.emplace(std::stol(match[1]), entry.path());
    }
    return found;
}

}  // namespace

fs::path checkpoint_path(const fs::path& folder, long step) {
    return folder / fmt::format("checkpoint_{:08}.h5", step);
}

void prune_checkpoints(const fs::path& folder, int keep) {
    const std::map<long, fs::path> found = checkpoints_in(folder);
    auto surplus = static_cast<long>(found.size()) - keep;
    for (auto oldest = found.begin(); surplus > 0; ++oldest, --surplus) fs::remove(oldest->second);

    static const std::regex unfinished(R"(checkpoint_\d{8,18}\.h5\.tmp)");
    std::vector<fs::path> leftovers;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (std::regex_match(entry.path().filename().string(), unfinished)) leftovers.push_back(entry.path());
    for (const fs::path& file : leftovers) fs::remove(file);
}

void remove_checkpoints_after(const fs::path& folder, long step) {
    const std::map<long, fs::path> found = checkpoints_in(folder);
    for (auto later = found.upper_bound(step); later != found.end(); ++later) fs::remove(later->second);
}

}  // namespace matpoint
