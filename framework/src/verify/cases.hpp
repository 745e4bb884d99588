#pragma once

#include "config/document.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace matpoint {

/// A case of the regression suite: a scene, what to change in it, and what must hold.
struct Case {
    std::string id;                            ///< "configs/verification/disk:analytic"
    std::shared_ptr<const Document> document;  ///< the case file, or the scene that has `checks`
    std::string pointer;                       ///< of the case in the document
    std::filesystem::path scene;
    std::vector<std::string> tags;
    std::vector<std::string> assignments;  ///< `/json/pointer=VALUE`
    Json checks = Json::array();           ///< resolved
    Json expect_error;                     ///< {"at", "matches", "status"}, or null
};

/// The cases in files, and in everything below folders: `*.test.json`, and scenes with `checks`,
/// which are a case called `checks`. In the order of their ids. Mistakes are collected.
std::vector<Case> find_cases(const std::vector<std::filesystem::path>& paths, Diagnostics& mistakes);

}  // namespace matpoint
