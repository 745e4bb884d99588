// A wave speed that can't be is told as the material's.

#include "failures_fixture.hpp"

namespace matpoint {
namespace {

class WaveSpeed : public Failures {
  protected:
    static Json with(const std::string& how, double from) {
        Json text = bar();
        text["materials"]["stuff"].update({{"where", "wave_speed"}, {"how", how}, {"from", from}});
        return text;
    }
    /// Strained from the start.
    static Json stretched(const std::string& how) {
        Json text = with(how, 0);
        text["bodies"]["bar"]["velocity"] = {"x/10"};
        return text;
    }
    static Json automatic(Json text) {
        text["time"] = {{"end", 0.02}};
        return text;
    }
};

TEST_F(WaveSpeed, ThatIsNoNumberOrNegativeIsTheMaterialsFault) {
    for (const std::string how : {"nan", "negative"}) {
        SCOPED_TRACE(how);
        const std::vector<Diagnostic> mistakes = refused(with(how, 0));
        ASSERT_EQ(mistakes.size(), 1U);
        EXPECT_EQ(mistakes[0].pointer, "/materials/stuff");
        EXPECT_SAYS(mistakes[0].message, how == "nan" ? "wave speed nan m/s" : "wave speed -1 m/s");

        const RunResult result = run(with(how, 3.1042));
        EXPECT_EQ(result.status, RunStatus::broke_down);
        EXPECT_SAYS(result.reason,
                    "/materials/stuff: material \"faulty_material\" of plugin \"faulty\" 0.0.1");
        EXPECT_SAYS(result.reason, "particle 1199 of body \"bar\"");
        EXPECT_SAYS(result.reason, how == "nan" ? "wave speed nan m/s" : "wave speed -1 m/s");
        EXPECT_EQ(saved().step, 5);
    }
}

TEST_F(WaveSpeed, ZeroUnderStressLeavesAnAutomaticStepWithoutALimit) {
    const RunResult result = run(automatic(stretched("zero")));
    EXPECT_EQ(result.status, RunStatus::broke_down);
    EXPECT_SAYS(result.reason, "body \"bar\" is under stress, but its material says that no wave runs in it");
    EXPECT_SAYS(result.reason, "/materials/stuff");
}

TEST_F(WaveSpeed, ZeroUnderStressIsWarnedOfWhereTheStepIsGiven) {
    const RunResult result = run(stretched("zero"));
    EXPECT_EQ(result.status, RunStatus::completed);
    ASSERT_EQ(result.summary.value("warnings", Json::array()).size(), 1U);
    EXPECT_SAYS(result.summary.at("warnings")[0].get<std::string>(), "no wave runs in it");
}

TEST_F(WaveSpeed, OfDustIsZero) {
    Json text = automatic(stretched("zero"));
    text["materials"]["stuff"]["stiffness"] = 0;
    const RunResult result = run(text);
    EXPECT_EQ(result.status, RunStatus::completed) << result.reason;
    EXPECT_FALSE(result.summary.contains("warnings"));
}

}  // namespace
}  // namespace matpoint
