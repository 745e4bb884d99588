#include "verify/check.hpp"
#include "verify/table.hpp"
#include "verify/tolerance.hpp"

#include <matpoint/profile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace matpoint {
namespace {

CheckResult evaluate_probe(const Json& check, const FinishedRun& run) {
    const std::string probe = check.at("probe");
    const Table table = read_table(run.output / (probe + ".csv"));
    const std::string name =
        check.contains("column") ? check.at("column").get<std::string>() : table.only_column();
    const std::vector<double>& times = table.column("time");
    const std::vector<double>& values = table.column(name);
    const Profile formula(check.at("formula"));
    const double from = check.value("from", -std::numeric_limits<double>::infinity());
    const double to = check.value("to", std::numeric_limits<double>::infinity());

    double scale = 0, worst = -1;
    std::size_t row = 0, rows = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] < from || times[i] > to) continue;
        ++rows;
        const double expected = formula({}, times[i]);
        scale = std::max(scale, std::abs(expected));
        const double deviation = std::abs(values[i] - expected);
        if (deviation > worst || std::isnan(deviation)) {
            worst = deviation;
            row = i;
        }
        if (std::isnan(deviation)) break;
    }
    if (rows == 0)
        throw std::runtime_error(fmt::format("{} has no row in the times asked for", table.file.string()));

    const Tolerance tolerance(check);
    const std::string subject = check.contains("column") ? fmt::format("{}.{}", probe, name) : probe;
    return {.holds = worst <= tolerance.at(scale),
            .measured = fmt::format("{}: {}", subject, tolerance.against(worst, scale)),
            .where = fmt::format("at t = {:g} s it is {:.9g}, expected {:.9g}", times[row], values[row],
                                 formula({}, times[row]))};
}

}  // namespace

CheckKind probe_check() {
    Schema schema("A column of a probe's file, at all its times, against a formula");
    schema.text("probe", {.doc = "Name of a probe among the scene's outputs"})
        .profile("formula", {.doc = "What the value should be at time t (s)", .variables = "t"})
        .text("column", {.doc = "Column of the file; needed if it has several beside time", .optional = true})
        .number("from", {.unit = "s", .doc = "Earlier rows are left out", .optional = true})
        .number("to", {.unit = "s", .doc = "Later rows are left out", .optional = true})
        .text("comment", {.doc = "For readers", .optional = true});
    Tolerance::describe(schema, true);
    return {"probe", schema, evaluate_probe};
}

}  // namespace matpoint
