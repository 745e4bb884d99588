#include "verify/run_case.hpp"

#include "verify/check.hpp"
#include "verify/load_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace matpoint {
namespace {

bool matches(const std::string& text, const Json& expected) {
    if (!expected.contains("matches")) return true;
    const std::string wanted = expected.at("matches");
    if (text.find(wanted) != text.npos) return true;
    try {
        return std::regex_search(text, std::regex(wanted));
    } catch (const std::regex_error&) {
        return false;  // plain text with brackets
    }
}

std::string status_name(RunStatus status) {
    switch (status) {
        case RunStatus::completed:
            return "completed";
        case RunStatus::broke_down:
            return "broke_down";
        case RunStatus::interrupted:
            return "interrupted";
        case RunStatus::unfinished:
            break;
    }
    return "unfinished";
}

class Judge {
  public:
    Judge(const Case& test, CaseResult& result) : test_(test), result_(result) {}

    void fail(const std::string& below, const std::string& message) {
        result_.failures.push_back(to_string(test_.document->diagnostic(test_.pointer + below, message)));
    }

    void refused(const Diagnostics& diagnostics) {
        if (test_.expect_error.is_null()) return fail("", "the scene was refused:\n" + diagnostics.text());
        const Json& expected = test_.expect_error;
        const auto all = diagnostics.all();
        const bool found =
            !expected.contains("status") && std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) {
                return d.error && (!expected.contains("at") || d.pointer == expected.at("at")) &&
                       matches(d.message, expected);
            });
        if (!found)
            return fail("/expect_error",
                        "the scene was refused, but not as expected:\n" + diagnostics.text());
        result_.measured.push_back("refused as expected");
    }

    void ended(const FinishedRun& run) {
        const RunResult& ran = run.result;
        const std::string how =
            ran.reason.empty() ? status_name(ran.status) : status_name(ran.status) + ": " + ran.reason;
        result_.interrupted = ran.status == RunStatus::interrupted;
        if (!test_.expect_error.is_null()) {
            const bool broke_down =
                test_.expect_error.contains("status") && ran.status == RunStatus::broke_down;
            if (!broke_down || !matches(ran.reason, test_.expect_error)) {
                return fail("/expect_error", "the run did not fail as expected; it " + how);
            }
            return result_.measured.push_back("broke down as expected");
        }
        if (ran.status != RunStatus::completed) return fail("", "the run " + how);
        if (test_.checks.empty()) result_.measured.push_back("completed");
        for (std::size_t i = 0; i < test_.checks.size(); ++i) {
            const CheckResult check = evaluate_check(test_.checks[i], run);
            result_.measured.push_back(check.measured);
            if (check.holds) continue;
            fail(fmt::format("/checks/{}", i),
                 check.where.empty() ? check.measured : check.measured + "; " + check.where);
        }
    }

  private:
    const Case& test_;
    CaseResult& result_;
};

}  // namespace

CaseResult run_case(const Case& test, const CaseOptions& options) {
    CaseResult result;
    Judge judge(test, result);
    try {
        PluginCatalogue catalogue;
        Scene scene = load_scene(test.scene, test.assignments, catalogue);
        scene.resolved["checks"] = test.checks;  // the particles carry the fields that checks look at
        const RunResult ran =
            run_scene(scene, catalogue, {.output = options.output, .quiet = true, .keep_state = true});
        judge.ended({.scene = scene,
                     .catalogue = catalogue,
                     .output = options.output,
                     .folder = std::filesystem::absolute(test.document->path).parent_path(),
                     .result = ran,
                     .update_gold = options.update_gold});
    } catch (const InputError& error) {
        judge.refused(error.diagnostics());
    } catch (const std::exception& error) {
        judge.fail("", error.what());
    }
    return result;
}

}  // namespace matpoint
