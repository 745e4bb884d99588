#pragma once

#include "registry/plugin_index.hpp"
#include "study/study_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

/// A scene with some values replaced.
struct Variant {
    int number = 0;                        ///< from 1
    std::string name;                      ///< what tells it from the others
    std::string set;                       ///< the name of its set, or ""
    Json settings = Json::object();        ///< its values of its set and of `vary`, by pointer
    std::vector<Setting> assignments;      ///< all that is replaced, in order
    std::vector<std::string> arguments{};  ///< what `matpoint run` needs after --set, each
    std::string refusal{};                 ///< why the scene's rules refuse it, or ""
    Json scene{};  ///< resolved, with the versions of program and plugins; null if it is refused
};

/// All combinations of the sets and the values that are varied.
std::vector<Variant> make_variants(const StudyFile& study);

/// Scenes of variants.
class VariantScenes {
  public:
    /// Reads the study's scene; throws InputError if that can't be done.
    explicit VariantScenes(const StudyFile& study);

    /// Fills in the variant's `arguments` and `scene`, or `refusal`, whose mistakes are returned. A pointer
    /// that leads nowhere is a mistake of the study.
    Diagnostics resolve(Variant& variant, Diagnostics& mistakes) const;
    /// The same for all. Throws InputError for mistakes of the study: a value with which no variant can be
    /// run is one.
    void resolve_all(std::vector<Variant>& variants) const;
    /// The variant as a scene that runs from any folder, with the outputs of the original.
    Json scene_to_keep(const Variant& variant) const;

  private:
    std::vector<Setting> all_settings(const Variant& variant) const;
    Diagnostics in_study(const Diagnostics& mistakes, const Variant& variant) const;

    const StudyFile& study_;
    Document document_;
    PluginIndex index_;
};

/// The number at a pointer of a scene or summary, of a list its first; NaN if there is none.
double number_at(const Json& json, const std::string& pointer);

}  // namespace matpoint
