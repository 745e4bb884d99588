#pragma once

#include <matpoint/schema.hpp>

#include <string>

namespace matpoint {

/// How far a value may be from what it should be: `absolute`, plus `relative` times a scale.
struct Tolerance {
    double absolute = 0, relative = 0;

    /// Adds the parameters; one of them must be given if `required`.
    static void describe(Schema& schema, bool required);
    /// From a resolved check.
    explicit Tolerance(const Json& check);

    double at(double scale) const;
    /// "0.0123 <= 0.03", of the scale if nothing absolute is allowed.
    std::string against(double deviation, double scale) const;
};

}  // namespace matpoint
