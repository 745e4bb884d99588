#pragma once

#include <matpoint/schema.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace matpoint {

/// The name of a file that an output writes, or those of a numbered series.
struct OutputFileNames {
    std::string before;
    std::string after{};
    bool numbered = false;  ///< six digits or more stand in between

    bool holds(std::string_view name) const;
    /// Whether both have a name in common.
    bool meets(const OutputFileNames& other) const;
    /// The only name, or the first of the series.
    std::string example() const { return before + (numbered ? "000000" : "") + after; }
};

/// What an output of a resolved scene writes in the run's folder.
std::vector<OutputFileNames> output_files(const Json& own, const Json& scene, const Schema& schema);

}  // namespace matpoint
