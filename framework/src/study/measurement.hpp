#pragma once

#include "study/process.hpp"
#include "study/variants.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace matpoint {

/// How the run of a variant ended.
struct Outcome {
    std::string status;  ///< completed, broke_down, crashed or refused
    std::string reason{};
    Json summary{};  ///< what its summary.json holds; null if there is none
};

/// What `matpoint study` and `matpoint limits` are told on the command line.
struct StudyOptions {
    std::filesystem::path program;  ///< `matpoint` itself, to run variants with
    std::filesystem::path output;   ///< folder for results
    int jobs = 1;                   ///< runs at a time
    bool again = false;             ///< measure anew what was measured before
    bool progress = false;          ///< a progress line on stderr
};

/// Runs of variants, each in a process and a folder of its own. The folder is called after the scene, so that
/// a later study finds the runs that it has in common with this one.
class Measurement {
  public:
    Measurement(const StudyFile& study, const StudyOptions& options) : study_(study), options_(options) {}

    /// Relative to the output folder; "" for a variant that is refused.
    static std::string folder(const Variant& variant);
    /// The outcome, if it is known without running: the variant is refused, or an earlier call measured it.
    std::optional<Outcome> known(const Variant& variant) const;
    /// Whether this scene is being run already: then the outcome will be known without running it again.
    bool is_running(const Variant& variant) const { return running_.contains(folder(variant)); }
    /// Prepares a folder; what is to be run there.
    Job prepare(const Variant& variant, std::size_t id);
    /// Reads what a run left, and tidies its folder up.
    Outcome finish(const Variant& variant, ProcessEnd end);

    /// A number in the summary of a run that completed. Throws InputError, about the place in the study that
    /// asks for it, if there is no such number; NaN if it isn't finite.
    double number(const Outcome& outcome, const std::string& pointer, const std::string& asked_at) const;
    /// What the accuracy of a run that completed is measured by; NaN, and the reason, if there is none.
    /// Throws as number() does.
    double measured(const Variant& variant, const Outcome& outcome, std::string& why_not) const;

  private:
    /// Name of the probe's file that measured() reads; empty if it reads none.
    std::string measured_file() const;

    const StudyFile& study_;
    const StudyOptions& options_;
    std::set<std::string> running_;  ///< folders
};

}  // namespace matpoint
