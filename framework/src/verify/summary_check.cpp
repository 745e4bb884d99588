#include "verify/check.hpp"
#include "verify/tolerance.hpp"

#include "config/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

CheckResult evaluate(const Json& check, const FinishedRun& run) {
    const std::string pointer = check.at("summary");
    const double value = number_at(run.result.summary, pointer);
    CheckResult result{.holds = true, .measured = {}};
    std::vector<std::string> bounds;
    const auto bound = [&](bool holds, const std::string& text) {
        result.holds = result.holds && holds;
        bounds.push_back(text);
    };
    if (check.contains("below")) {
        const double limit = check.at("below");
        bound(value < limit, fmt::format("{} {:.6g}", value < limit ? "<" : "not <", limit));
    }
    if (check.contains("above")) {
        const double limit = check.at("above");
        bound(value > limit, fmt::format("{} {:.6g}", value > limit ? ">" : "not >", limit));
    }
    if (check.contains("equals")) {
        const double expected = check.at("equals");
        const Tolerance tolerance(check);
        const bool equal = std::abs(value - expected) <= tolerance.at(expected);
        bound(equal, fmt::format("{} {:.9g}", equal ? "=" : "not =", expected));
    }
    result.measured = fmt::format("{}: {:.6g} {}", pointer, value, fmt::join(bounds, ", "));
    return result;
}

}  // namespace

CheckKind summary_check() {
    Schema schema("A number in summary.json");
    schema.text("summary", {.doc = "JSON pointer into summary.json, \"/error/linf\""})
        .number("below", {.doc = "It must be less", .optional = true})
        .number("above", {.doc = "It must be more", .optional = true})
        .number("equals",
                {.doc = "It must be this, within the tolerances; exactly without", .optional = true})
        .text("comment", {.doc = "For readers", .optional = true})
        .refuse("/summary", "expected a JSON pointer into summary.json, such as \"/conservation/mass_drift\"",
                [](const Json& own, const Json&) {
                    return own.at("summary").is_string() && !is_pointer(own.at("summary").get<std::string>());
                })
        .refuse("", "say what must hold: `below`, `above` or `equals`", [](const Json& own, const Json&) {
            return !own.contains("below") && !own.contains("above") && !own.contains("equals");
        });
    Tolerance::describe(schema, false);
    return {"summary", schema, evaluate};
}

}  // namespace matpoint
