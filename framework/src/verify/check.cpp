#include "verify/check.hpp"

#include "config/expected.hpp"
#include "config/nearest.hpp"
#include "config/validate.hpp"
#include "verify/no_components.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matpoint {
namespace {

const CheckKind* kind_of(const Json& check) {
    const auto& kinds = check_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const CheckKind& kind) { return check.contains(kind.key); });
    return found == kinds.end() ? nullptr : &*found;
}

std::string unknown_kind(const Json& check) {
    std::vector<std::string> keys;
    for (const CheckKind& kind : check_kinds()) keys.push_back(kind.key);
    for (const auto& member : check.items()) {
        if (nearest(member.key(), keys)) {
            return fmt::format("unknown check \"{}\"{}", member.key(), did_you_mean(member.key(), keys));
        }
    }
    return "a check says what it looks at" + did_you_mean("", keys);
}

}  // namespace

const std::vector<CheckKind>& check_kinds() {
    static const std::vector<CheckKind> kinds{gold_check(),   twin_check(),    statistic_check(),
                                              probe_check(),  summary_check(), particles_check(),
                                              restart_check()};
    return kinds;
}

Json validate_checks(const Document& document, const Json& checks, const std::string& at,
                     Diagnostics& diagnostics) {
    if (!checks.is_array()) {
        diagnostics.add(
            document.diagnostic(at, fmt::format("expected a list of checks, got {}", shown(checks))));
        return Json::array();
    }
    NoComponents none;
    Validator validator(document, none, 0, diagnostics);
    Json resolved = Json::array();
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const Json& check = checks[i];
        const std::string pointer = fmt::format("{}/{}", at, i);
        if (!check.is_object()) {
            validator.error(pointer, fmt::format("expected a check: an object, got {}", shown(check)));
        } else if (const CheckKind* kind = kind_of(check)) {
            resolved.push_back(validator.object(kind->schema, check, pointer));
        } else {
            validator.error(pointer, unknown_kind(check));
        }
    }
    validator.check_rules(document.json);
    return resolved;
}

CheckResult evaluate_check(const Json& check, const FinishedRun& run) {
    const CheckKind& kind = *kind_of(check);
    try {
        return kind.evaluate(check, run);
    } catch (const std::exception& error) {
        return {.holds = false, .measured = fmt::format("{} can't be checked: {}", kind.key, error.what())};
    }
}

}  // namespace matpoint
