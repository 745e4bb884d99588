#include "verify/cases.hpp"

#include <matpoint/input_file.hpp>

#include "config/validate.hpp"
#include "verify/check.hpp"
#include "verify/no_components.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matpoint {
namespace {

namespace fs = std::filesystem;

constexpr const char* case_suffix = ".test.json";
constexpr const char* scene_case = "checks";  // the name of the case that a scene with checks is

bool is_case_file(const fs::path& file) {
    return file.filename().string().ends_with(case_suffix);
}

Schema error_schema() {
    return Schema("How the scene must fail")
        .text("at", {.doc = "The scene is refused, with a mistake at this JSON pointer", .optional = true})
        .choice("status",
                {.doc = "The run ends with this status instead", .optional = true, .choices = {"broke_down"}})
        .text("matches",
              {.doc = "Part of the message, or a regular expression found in it", .optional = true})
        .refuse("/status", "a scene that is refused does not run: give `at` or `status`",
                [](const Json& own, const Json&) { return own.contains("status") && own.contains("at"); });
}

Schema case_schema() {
    return Schema("A case")
        .add("tags", ParameterType::texts, {.doc = "To choose cases by", .default_value = Json::array()})
        .add("set", ParameterType::any,
             {.doc = "Values of the scene to replace, by JSON pointer", .default_value = Json::object()})
        .add("checks", ParameterType::any,
             {.doc = "What must hold after the run", .default_value = Json::array()})
        .add("expect_error", ParameterType::object,
             {.doc = "How the scene must fail",
              .optional = true,
              .nested = std::make_shared<Schema>(error_schema())})
        .text("comment", {.doc = "For readers", .optional = true})
        .refuse("/set", "expected an object of values by JSON pointer, {\"/time/end\": 0.1}",
                [](const Json& own, const Json&) {
                    if (!own.contains("set")) return false;
                    if (!own.at("set").is_object()) return true;
                    const auto entries = own.at("set").items();
                    return std::any_of(entries.begin(), entries.end(),
                                       [](const auto& entry) { return !entry.key().starts_with('/'); });
                })
        .refuse("/checks", "a scene that must fail leaves nothing to check: give `checks` or `expect_error`",
                [](const Json& own, const Json&) {
                    return own.contains("checks") && own.contains("expect_error");
                });
}

const Schema& case_file_schema() {
    static const Schema schema =
        Schema("Cases of one scene")
            .add("scene", ParameterType::file, {.doc = "Relative to this file"})
            .add("cases", ParameterType::map,
                 {.doc = "Cases by name", .at_least = 1, .nested = std::make_shared<Schema>(case_schema())})
            .text("comment", {.doc = "For readers", .optional = true});
    return schema;
}

std::string id_of(const fs::path& file, const std::string& name) {
    std::string path = fs::proximate(file).generic_string();
    const std::string_view suffix = is_case_file(file) ? case_suffix : ".json";
    if (path.ends_with(suffix)) path.erase(path.size() - suffix.size());
    return path + ":" + name;
}

void add_case_file(const std::shared_ptr<const Document>& document, std::vector<Case>& cases,
                   Diagnostics& mistakes) {
    Diagnostics found = document->mistakes;
    NoComponents none;
    Validator validator(*document, none, 0, found);
    const Json resolved = validator.object(case_file_schema(), document->json, "");
    if (!found.has_errors()) validator.check_rules(document->json);
    if (!found.has_errors()) {
        for (const auto& [name, own] : resolved.at("cases").items()) {
            const std::string pointer = join_pointer("/cases", name);
            if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != name.npos) {
                validator.error(pointer, "a case's name has small letters, digits and _ only");
            }
            if (name == scene_case) validator.error(pointer, "that is what a scene's own checks are called");
            Case one{.id = id_of(document->path, name),
                     .document = document,
                     .pointer = pointer,
                     .scene = fs::proximate(resolved.at("scene").get<std::string>()),
                     .tags = own.at("tags"),
                     .assignments = {},
                     .checks = validate_checks(*document, own.at("checks"), pointer + "/checks", found),
                     .expect_error = own.value("expect_error", Json())};
            for (const auto& [at, value] : own.at("set").items())
                one.assignments.push_back(at + "=" + value.dump());
            cases.push_back(std::move(one));
        }
    }
    mistakes.add(found);
}

void add_scene(const std::shared_ptr<const Document>& document, std::vector<Case>& cases,
               Diagnostics& mistakes) {
    Json checks = validate_checks(*document, document->json.at("checks"), "/checks", mistakes);
    cases.push_back({.id = id_of(document->path, scene_case),
                     .document = document,
                     .pointer = "",
                     .scene = document->path,
                     .tags = {},
                     .assignments = {},
                     .checks = std::move(checks),
                     .expect_error = {}});
}

void add_file(const fs::path& file, std::vector<Case>& cases, Diagnostics& mistakes) {
    try {
        const auto document = std::make_shared<const Document>(read_document(file));
        if (is_case_file(file)) {
            add_case_file(document, cases, mistakes);
        } else if (document->json.is_object() && document->json.contains("checks")) {
            add_scene(document, cases, mistakes);
        } else {
            mistakes.add(document->diagnostic(
                "", "a scene without `checks`, and no *.test.json either: nothing to test"));
        }
    } catch (const InputError& error) {
        mistakes.add(error.diagnostics());
    }
}

/// Most scenes have none, and needn't be parsed.
bool mentions_checks(const fs::path& file) {
    if (!why_unreadable(file).empty()) return false;
    const std::string text = read_whole(file);
    return text.find("\"checks\"") != text.npos && text.find("\"matpoint\"") != text.npos;
}

}  // namespace

std::vector<Case> find_cases(const std::vector<fs::path>& paths, Diagnostics& mistakes) {
    std::vector<Case> cases;
    for (const fs::path& path : paths) {
        std::error_code ignored;  // add_file tells
        if (!fs::is_directory(path, ignored)) {
            add_file(path, cases, mistakes);
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(path)) {
            const fs::path& file = entry.path();
            if (!entry.is_regular_file() || file.extension() != ".json") continue;
            if (is_case_file(file) || mentions_checks(file)) add_file(file, cases, mistakes);
        }
    }
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.id < b.id; });
    return cases;
}

}  // namespace matpoint
