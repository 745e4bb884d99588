#pragma once

#include "config/document.hpp"
#include "study/axis.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace matpoint {

/// A value of the scene that a study replaces.
struct Setting {
    std::string pointer;  ///< JSON pointer into the scene
    Json value;
    std::string from{};  ///< where the study says so: JSON pointer into its file; "" if it doesn't
};

/// Settings by a name of the user's.
struct NamedSettings {
    std::string name;
    std::vector<Setting> settings;
};

/// A file of `matpoint study` or `matpoint limits` without mistakes.
struct StudyFile {
    std::shared_ptr<const Document> document;
    Json json;  ///< resolved; pointers in `plots` are full ones
    std::string title;
    std::filesystem::path scene;      ///< absolute
    std::vector<Setting> set;         ///< of all variants
    std::vector<NamedSettings> sets;  ///< at least one; its name is "" if the study names none
    std::vector<Axis> axes;
};

/// Throws InputError with all mistakes.
StudyFile read_study_file(const std::filesystem::path& file);
StudyFile read_limits_file(const std::filesystem::path& file);

/// What `plots` may show of a variant, beside the values that are varied.
const std::vector<std::string>& plotted_quantities();

}  // namespace matpoint
