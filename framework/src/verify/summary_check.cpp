#include "verify/bounds.hpp"
#include "verify/check.hpp"

#include "config/nearest.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace matpoint {
namespace {

bool is_pointer(const std::string& text) {
    try {
        return !text.empty() && Json::json_pointer(text).to_string() == text;
    } catch (const Json::exception&) {
        return false;
    }
}

double number_at(const Json& summary, const std::string& pointer) {
    const Json::json_pointer at(pointer);
    if (!summary.contains(at)) {
        const Json flat = summary.flatten();
        std::vector<std::string> pointers;
        for (const auto& member : flat.items()) pointers.push_back(member.key());
        throw std::runtime_error(
            fmt::format("summary.json has no {}{}", pointer, did_you_mean(pointer, pointers)));
    }
    const Json& value = summary.at(at);
    // nlohmann writes numbers that are not finite as null.
    if (value.is_null()) return std::nan("");
    if (!value.is_number()) throw std::runtime_error(fmt::format("summary.json's {} is no number", pointer));
    return value.get<double>();
}

CheckResult evaluate_summary(const Json& check, const FinishedRun& run) {
    const std::string pointer = check.at("summary");
    return within_bounds(check, pointer, number_at(run.result.summary, pointer));
}

}  // namespace

CheckKind summary_check() {
    Schema schema("A number in summary.json");
    schema.text("summary", {.doc = "JSON pointer into summary.json, \"/error/linf\""})
        .text("comment", {.doc = "For readers", .optional = true})
        .refuse("/summary", "expected a JSON pointer into summary.json, such as \"/conservation/mass_drift\"",
                [](const Json& own, const Json&) {
                    return own.at("summary").is_string() && !is_pointer(own.at("summary").get<std::string>());
                });
    describe_bounds(schema);
    return {"summary", schema, evaluate_summary};
}

}  // namespace matpoint
