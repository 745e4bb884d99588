#include "study/variants.hpp"

#include "config/utf8.hpp"
#include "run/summary.hpp"
#include "study/type_change.hpp"
#include "verify/load_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace matpoint {
namespace {

constexpr std::string_view from_command_line = "--set ";

std::string name_of(const StudyFile& study, const NamedSettings& set,
                    const std::vector<std::size_t>& choice) {
    std::vector<std::string> parts;
    if (!set.name.empty()) parts.push_back(set.name);
    for (std::size_t i = 0; i < choice.size(); ++i) {
        const Axis& axis = study.axes[i];
        if (axis.values.size() > 1) parts.push_back(axis.label + "=" + axis.value_labels[choice[i]]);
    }
    return parts.empty() ? study.title : fmt::format("{}", fmt::join(parts, ", "));
}

/// The next combination, the last axis fastest; false after the last one.
bool advance(std::vector<std::size_t>& choice, const std::vector<Axis>& axes) {
    for (std::size_t i = axes.size(); i-- > 0;) {
        if (++choice[i] < axes[i].values.size()) return true;
        choice[i] = 0;
    }
    return false;
}

/// Applies settings to a scene; returns them as --set takes them.
std::vector<std::string> apply(const std::vector<Setting>& settings, Document& scene, Catalogue& catalogue,
                               Diagnostics& mistakes) {
    std::vector<std::string> assignments;
    for (const Setting& given : settings) {
        const Setting setting = without_leftovers(given, scene.json, catalogue);
        assignments.push_back(setting.pointer + "=" + setting.value.dump());
        apply_set(scene, assignments.back(), mistakes);
    }
    return assignments;
}

std::string one_line(const Diagnostics& mistakes) {
    std::vector<std::string> texts;
    for (const Diagnostic& d : mistakes.all())
        if (d.error) texts.push_back(d.pointer.empty() ? d.message : d.pointer + ": " + d.message);
    return fmt::format("{}", fmt::join(texts, "; "));
}

/// The probe that the accuracy is measured by, if there is one.
Json measured_output(const StudyFile& study, const Document& scene) {
    Json outputs = Json::array();
    const Json accuracy = study.json.value("accuracy", Json::object());
    if (!accuracy.contains("measure") || !scene.json.contains("outputs")) return outputs;
    for (const Json& output : scene.json.at("outputs"))
        if (output.is_object() && output.value("name", Json()) == accuracy.at("measure").at("probe"))
            outputs.push_back(output);
    return outputs;
}

}  // namespace

std::vector<Variant> make_variants(const StudyFile& study) {
    std::vector<Variant> variants;
    for (const NamedSettings& set : study.sets) {
        std::vector<std::size_t> choice(study.axes.size(), 0);
        do {
            Variant variant;
            variant.number = static_cast<int>(variants.size()) + 1;
            variant.name = name_of(study, set, choice);
            variant.set = set.name;
            variant.assignments = study.set;
            for (const Setting& setting : set.settings) {
                variant.settings[setting.pointer] = setting.value;
                variant.assignments.push_back(setting);
            }
            for (std::size_t i = 0; i < choice.size(); ++i) {
                const Axis& axis = study.axes[i];
                const Json& value = axis.values[choice[i]];
                variant.settings[axis.pointer] = value;
                variant.assignments.push_back({axis.pointer, value, join_pointer("/vary", axis.pointer)});
            }
            variants.push_back(std::move(variant));
        } while (advance(choice, study.axes));
    }
    return variants;
}

VariantScenes::VariantScenes(const StudyFile& study)
    : study_(study), document_(read_document(study.scene)), index_(plugin_folders()) {}

std::vector<Setting> VariantScenes::all_settings(const Variant& variant) const {
    std::vector<Setting> all = variant.assignments;
    if (study_.json.at("keep_outputs") == true) return all;
    all.push_back({"/outputs", measured_output(study_, document_)});
    all.push_back({"/checkpoint", nullptr});
    return all;
}

/// Mistakes of values that the study gives are told where it gives them.
Diagnostics VariantScenes::in_study(const Diagnostics& mistakes, const Variant& variant) const {
    Diagnostics located;
    for (const Diagnostic& d : mistakes.all()) {
        const Setting* giver = nullptr;
        if (d.file.starts_with(from_command_line)) {
            const std::string set = d.file.substr(from_command_line.size());
            for (const Setting& setting : variant.assignments)
                if (!setting.from.empty() && (setting.pointer == set || setting.pointer == set + "/type"))
                    giver = &setting;
        }
        const std::string where = d.pointer.empty() ? "" : d.pointer + ": ";
        located.add(giver ? study_.document->diagnostic(giver->from, where + d.message, d.error) : d);
    }
    return located;
}

Diagnostics VariantScenes::resolve(Variant& variant, Diagnostics& mistakes) const {
    Document document = document_;
    PluginCatalogue catalogue(index_);
    Diagnostics lost;
    variant.arguments = apply(all_settings(variant), document, catalogue, lost);
    mistakes.add(in_study(lost, variant));
    if (lost.has_errors()) return {};
    try {
        variant.scene = with_plugins(load_scene(std::move(document), {}, catalogue).resolved, catalogue);
        variant.scene["resolved_with"]["matpoint"] = MATPOINT_VERSION;
        if (study_.json.contains("timing"))
            variant.scene["resolved_with"]["timing"] = study_.json.at("timing");
        return {};
    } catch (const InputError& error) {
        variant.refusal = as_utf8(one_line(error.diagnostics()));
        return in_study(error.diagnostics(), variant);
    }
}

void VariantScenes::resolve_all(std::vector<Variant>& variants) const {
    Diagnostics mistakes;
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> uses;  // of a value, by variant
    std::vector<Diagnostics> refusals;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        refusals.push_back(resolve(variants[i], mistakes));
        for (const Setting& setting : variants[i].assignments)
            if (!setting.from.empty()) uses[{setting.from, setting.value.dump()}].push_back(i);
    }
    for (const auto& [value, users] : uses)
        if (std::ranges::all_of(users, [&](std::size_t i) { return !variants[i].refusal.empty(); }))
            for (const std::size_t i : users) mistakes.add(refusals[i]);
    Diagnostics once;
    std::set<std::string> told;
    for (const Diagnostic& d : mistakes.all())
        if (told.insert(to_string(d)).second) once.add(d);
    once.throw_if_errors();
}

double number_at(const Json& json, const std::string& pointer) {
    const Json::json_pointer at(pointer);
    const Json* value = json.contains(at) ? &json.at(at) : nullptr;
    if (value && value->is_array() && !value->empty()) value = &value->front();
    return value && value->is_number() ? value->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Json VariantScenes::scene_to_keep(const Variant& variant) const {
    Document document = document_;
    PluginCatalogue catalogue(index_);
    Diagnostics none;  // they were applied before
    apply(variant.assignments, document, catalogue, none);
    Json scene = with_plugins(load_scene(std::move(document), {}, catalogue).resolved, catalogue);
    scene["resolved_with"]["matpoint"] = MATPOINT_VERSION;
    scene.erase("checks");  // of the original; their files are beside it
    return scene;
}

}  // namespace matpoint
