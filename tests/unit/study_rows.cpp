// Rows of a study from made-up results: errors, fronts, orders and references are those that were put in.

#include "study_fixture.hpp"

#include "config/diagnostics.hpp"
#include "study/rows.hpp"

#include <cmath>

namespace {

using namespace matpoint;

class StudyRows : public StudyFolder {
  protected:
    /// The rows of a study over cell sizes 0.4, 0.2, 0.1 and two schemes a and b, with made-up summaries.
    template <class Summary>
    void compare(const std::string& accuracy, Summary summary) {
        const StudyFile file = study(R"("cost": {"summary": "/price"}, "variants": {"a": {}, "b": {}},
            "vary": {"/grid/cell_size": [0.4, 0.2, 0.1]}, "accuracy": )" +
                                     accuracy);
        const StudyOptions options{.program = {}, .output = folder};
        const Measurement measurement(file, options);
        Rows made(file, measurement);
        for (Variant& variant : make_variants(file)) {
            const double h = variant.settings.at("/grid/cell_size");
            variant.scene = {{"grid", {{"cell_size", {h, h}}}}};  // as resolved: one per axis
            made.add(variant, {"completed", "", summary(variant.set, h)});
        }
        made.compare();
        rows = made.json();
        accuracy_told = made.accuracy();
    }
    std::vector<double> column(const char* key) const {
        std::vector<double> values;
        for (const Json& row : rows) values.push_back(row.at(key).is_null() ? -1 : row.at(key).get<double>());
        return values;
    }
    std::vector<int> numbers_with(const char* key) const {
        std::vector<int> numbers;
        for (const Json& row : rows)
            if (row.at(key) == true) numbers.push_back(row.at("number"));
        return numbers;
    }

    Json rows, accuracy_told;
};

TEST_F(StudyRows, ErrorsCostsFrontAndOrders) {
    // b costs the same, is less accurate on coarse grids, and needs fewer particle steps.
    compare(R"({"summary": "/error", "scale": 10})", [](const std::string& scheme, double h) {
        const double order = scheme == "a" ? 1 : 3;
        return Json{{"error", -10 * std::pow(h / 0.2, order)},
                    {"price", 1 / h},
                    {"particle_steps", scheme == "a" ? 100 / h : 10 / h}};
    });
    const std::vector<double> errors{2, 1, 0.5, 8, 1, 0.125}, orders{-1, 1, 1, -1, 3, 3};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(column("error")[i], errors[i], 1e-12);
        EXPECT_NEAR(column("order")[i], orders[i], 1e-12);
    }
    EXPECT_EQ(column("cost")[2], 10);
    EXPECT_EQ(numbers_with("front"), (std::vector<int>{1, 2, 5, 6}));
    EXPECT_EQ(numbers_with("front_particle_steps"), (std::vector<int>{4, 5, 6}));
}

TEST_F(StudyRows, WithoutExactSolutionTheLimitIsExtrapolated) {
    compare(R"({"summary": "/q", "reference": "finest"})", [](const std::string& scheme, double h) {
        return Json{{"q", scheme == "a" ? 4 - h * h : 4 + (h == 0.2 ? 0.1 : 0)}, {"price", 1}};
    });
    EXPECT_NEAR(rows[0].at("error"), 0.16 / 4, 1e-9);
    EXPECT_NEAR(rows[2].at("error"), 0.01 / 4, 1e-9);
    EXPECT_NEAR(rows[1].at("order"), 2, 1e-6);
    const Json& lines = accuracy_told.at("reference").at("lines");
    EXPECT_NEAR(lines[0].at("value"), 4, 1e-9);
    EXPECT_NEAR(lines[0].at("order"), 2, 1e-9);
    // b is not monotone: the finest is the reference, and its own error is not known.
    EXPECT_EQ(lines[1].at("extrapolated"), false);
    EXPECT_TRUE(lines[1].at("order").is_null());
    EXPECT_EQ(lines[1].at("finest"), "b, cell_size=0.1");
    EXPECT_TRUE(rows[5].at("error").is_null());
    EXPECT_NEAR(rows[4].at("error"), 0.1 / 4, 1e-12);
    EXPECT_FALSE(rows[5].at("front"));
}

TEST_F(StudyRows, ANumberThatIsNotFiniteIsABreakdown) {
    compare(R"({"summary": "/error"})", [](const std::string&, double h) {
        return Json{{"error", h == 0.2 ? Json() : Json(h)}, {"price", 1}};
    });
    EXPECT_EQ(rows[0].at("status"), "completed");
    EXPECT_EQ(rows[1].at("status"), "broke_down");
    EXPECT_NE(rows[1].at("reason").get<std::string>().find("/error"), std::string::npos);
    EXPECT_NEAR(rows[2].at("order"), 1, 1e-12) << "against the next coarser that completed";
}

TEST_F(StudyRows, AMeasureThatIsNotInTheSummaryIsAMistake) {
    try {
        compare(R"({"summary": "/eror"})", [](const std::string&, double h) {
            return Json{{"error", h}, {"price", 1}};
        });
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"/error\""), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("/accuracy/summary"), std::string::npos) << error.what();
    }
}

}  // namespace
