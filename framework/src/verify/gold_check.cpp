#include "verify/check.hpp"
#include "verify/table.hpp"
#include "verify/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matpoint {
namespace {

namespace fs = std::filesystem;

/// The row in which two columns differ most; one that is not a number counts as the worst.
std::size_t worst_row(const std::vector<double>& a, const std::vector<double>& b) {
    std::size_t worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double deviation = std::abs(a[i] - b[i]);
        if (std::isnan(deviation)) return i;
        if (deviation > std::abs(a[worst] - b[worst])) worst = i;
    }
    return worst;
}

CheckResult evaluate_gold(const Json& check, const FinishedRun& run) {
    const std::string probe = check.at("probe");
    const fs::path measured_file = run.output / (probe + ".csv");
    const fs::path gold_file = run.folder / check.at("gold").get<std::string>();
    if (run.update_gold) {
        fs::create_directories(gold_file.parent_path());
        fs::copy_file(measured_file, gold_file, fs::copy_options::overwrite_existing);
        return {.holds = true, .measured = fmt::format("{}: wrote {}", probe, gold_file.string())};
    }
    if (!fs::exists(gold_file)) {
        throw std::runtime_error(
            fmt::format("there is no gold file {}: make it with `matpoint test --update-gold` and look "
                        "whether it is right",
                        gold_file.string()));
    }

    const Table measured = read_table(measured_file), gold = read_table(gold_file);
    if (measured.rows() != gold.rows()) {
        throw std::runtime_error(fmt::format("{} has {} rows, {} has {}", measured_file.string(),
                                             measured.rows(), gold_file.string(), gold.rows()));
    }
    for (const std::string& name : measured.names) gold.column(name);

    const Tolerance tolerance(check);
    CheckResult worst{.holds = true,
                      .measured = fmt::format("{}: as {}", probe, gold_file.filename().string())};
    double worst_share = -1;
    for (std::size_t c = 0; c < gold.names.size() && gold.rows() > 0; ++c) {
        const std::vector<double>& expected = gold.columns[c];
        const std::vector<double>& values = measured.column(gold.names[c]);
        const std::size_t row = worst_row(values, expected);
        double scale = 0;
        for (const double value : expected) scale = std::max(scale, std::abs(value));
        const double deviation = std::abs(values[row] - expected[row]);
        const double share = deviation == 0 ? 0 : deviation / tolerance.at(scale);
        if (share <= worst_share) continue;
        worst_share = share;
        worst = {
            .holds = deviation <= tolerance.at(scale),
            .measured = fmt::format("{}.{}: {}", probe, gold.names[c], tolerance.against(deviation, scale)),
            .where = fmt::format("row {} is {:.9g}, in {} {:.9g}", row + 1, values[row], gold_file.string(),
                                 expected[row])};
        if (!(share <= 1)) return worst;
    }
    return worst;
}

}  // namespace

CheckKind gold_check() {
    Schema schema("A probe's file, column by column, against one that was found right before");
    schema.text("gold", {.doc = "CSV file, relative to the file with the check"})
        .text("probe", {.doc = "Name of a probe among the scene's outputs"})
        .text("comment", {.doc = "For readers", .optional = true});
    Tolerance::describe(schema, true);
    return {"gold", schema, evaluate_gold};
}

}  // namespace matpoint
