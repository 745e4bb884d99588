#pragma once

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>

namespace matpoint::conformance {

/// Runs checks. What fails is told once, with how often it failed: a mistake mostly shows at many particles
/// and in every space.
template <class Checks>
void each_failure_once(const Checks& checks) {
    using Reporter = testing::ScopedFakeTestPartResultReporter;
    testing::TestPartResultArray results;
    {
        const Reporter reporter(Reporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
        checks();
    }
    const auto line = [](const testing::TestPartResult& result) {
        return std::pair<std::string, int>(result.file_name() ? result.file_name() : "",
                                           result.line_number());
    };
    std::map<std::pair<std::string, int>, int> times;
    for (int i = 0; i < results.size(); ++i)
        if (results.GetTestPartResult(i).failed()) ++times[line(results.GetTestPartResult(i))];
    for (int i = 0; i < results.size(); ++i) {
        const testing::TestPartResult& result = results.GetTestPartResult(i);
        const int count = std::exchange(times[line(result)], 0);
        if (count == 0) continue;
        ADD_FAILURE_AT(result.file_name(), result.line_number())
            << result.message()
            << (count > 1 ? "\n(and so " + std::to_string(count - 1) + " times more)" : "");
    }
}

}  // namespace matpoint::conformance
