#include "verify/bounds.hpp"

#include "verify/tolerance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace matpoint {

void describe_bounds(Schema& schema) {
    schema.number("below", {.doc = "It must be less", .optional = true})
        .number("above", {.doc = "It must be more", .optional = true})
        .number("equals",
                {.doc = "It must be this, within the tolerances; exactly without", .optional = true})
        .refuse("", "say what must hold: `below`, `above` or `equals`", [](const Json& own, const Json&) {
            return !own.contains("below") && !own.contains("above") && !own.contains("equals");
        });
    Tolerance::describe(schema, false);
}

CheckResult within_bounds(const Json& check, const std::string& subject, double value) {
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
    result.measured = fmt::format("{}: {:.6g} {}", subject, value, fmt::join(bounds, ", "));
    return result;
}

}  // namespace matpoint
