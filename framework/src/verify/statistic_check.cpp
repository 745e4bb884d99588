#include "verify/bounds.hpp"
#include "verify/check.hpp"
#include "verify/statistics.hpp"

namespace matpoint {

CheckKind statistic_check() {
    Schema schema("A number taken from a column of a probe's file: a value (mean over the rows) or a time");
    describe_statistic(schema);
    schema.text("comment", {.doc = "For readers", .optional = true});
    describe_bounds(schema);
    return {"statistic", schema, [](const Json& check, const FinishedRun& run) {
                return within_bounds(check, statistic_text(check), statistic_of(check, run.output));
            }};
}

}  // namespace matpoint
