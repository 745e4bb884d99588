#include "verify/tolerance.hpp"

#include <fmt/format.h>

#include <cmath>

namespace matpoint {

void Tolerance::describe(Schema& schema, bool required) {
    schema
        .number("relative", {.doc = "Largest deviation allowed, as a part of the largest value expected",
                             .optional = true,
                             .at_least = 0})
        .number("absolute", {.doc = "Largest deviation allowed, in SI; added to what `relative` allows",
                             .optional = true,
                             .at_least = 0});
    if (!required) return;
    schema.refuse(
        "", "say how large a deviation is allowed: `relative`, `absolute` or both",
        [](const Json& own, const Json&) { return !own.contains("relative") && !own.contains("absolute"); });
}

Tolerance::Tolerance(const Json& check)
    : absolute(check.value("absolute", 0.0)), relative(check.value("relative", 0.0)) {}

double Tolerance::at(double scale) const {
    return absolute + relative * std::abs(scale);
}

std::string Tolerance::against(double deviation, double scale) const {
    // Negated, so that a deviation that is not a number is above.
    const char* sign = !(deviation <= at(scale)) ? ">" : "<=";
    const double size = std::abs(scale);
    if (relative > 0 && absolute == 0 && size > 0) {
        return fmt::format("relative {:.3g} {} {:.3g}", deviation / size, sign, relative);
    }
    return fmt::format("{:.3g} {} {:.3g}", deviation, sign, at(scale));
}

}  // namespace matpoint
