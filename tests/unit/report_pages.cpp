// The files that reports consist of.

#include "report/limits_report.hpp"
#include "report/report.hpp"
#include "report/report_rows.hpp"
#include "report/study_plots.hpp"

#include "report_fixture.hpp"

#include <algorithm>

namespace {

using namespace matpoint;

Json variant(int number, const std::string& shape, double cell_size, double error, double cost) {
    return {{"number", number},
            {"name", shape + " & " + std::to_string(number)},
            {"variant", ""},
            {"settings", {{"/shape_function", {{"type", shape}}}, {"/grid/cell_size", cell_size}}},
            {"status", "completed"},
            {"reason", ""},
            {"error", error},
            {"cost", cost},
            {"particle_steps", 1000 * number},
            {"peak_memory_bytes", 3 << 20},
            {"order", nullptr},
            {"front", false}};
}

Json example() {
    Json study{{"title", "A <study>"},
               {"scene", "scene.json"},
               {"accuracy", {{"summary", "/error/linf"}, {"label", "largest error"}}},
               {"cost", {{"summary", "/cpu_seconds"}}},
               {"target", 1e-2},
               {"variants", Json::array()}};
    study["variants"] = {variant(1, "linear", 0.2, 4e-2, 1), variant(2, "linear", 0.1, 2e-2, 8),
                         variant(3, "gimp", 0.2, 8e-3, 2), variant(4, "gimp", 0.1, 2e-3, 16)};
    for (const std::size_t i : {0U, 2U, 3U}) study["variants"][i]["front"] = true;
    study["best"] = {
        {"number", 3}, {"name", "gimp & 3"}, {"error", 8e-3}, {"cost", 2}, {"scene", "best.json"}};
    Json broken = variant(5, "gimp", 0.05, 0, 3);
    broken["status"] = "broke_down";
    broken["reason"] = "speed > \"sound\"";
    broken["error"] = nullptr;
    Json refused = variant(6, "gimp", -1, 0, 3);
    refused["status"] = "refused";
    refused["error"] = refused["cost"] = nullptr;
    study["variants"].push_back(broken);
    study["variants"].push_back(refused);
    study["plots"] = {{{"name", "convergence"},
                       {"x", "/grid/cell_size"},
                       {"lines", {"/shape_function/type"}},
                       {"slopes", {2}},
                       {"x_divisor", 2}}};
    return study;
}

std::size_t count(const std::vector<Element>& elements, const std::string& name) {
    return static_cast<std::size_t>(std::count_if(
        elements.begin(), elements.end(), [&](const Element& element) { return element.name == name; }));
}

TEST_F(ReportTest, AStudysFilesAreWellFormed) {
    write_report(example(), folder);
    for (const char* file : {"study.svg", "convergence.svg", "study.html"})
        EXPECT_NO_THROW(elements_of(content(file))) << file;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 3);
}

TEST_F(ReportTest, ThePageNeedsNothingButItself) {
    write_report(example(), folder);
    for (const Element& element : elements_of(content("study.html"))) {
        EXPECT_FALSE(element.attributes.contains("src"));
        if (element.attributes.contains("href")) {
            EXPECT_EQ(element.attributes.at("href"), "best.json");
        }
    }
}

TEST_F(ReportTest, TheTableHasEveryVariant) {
    write_report(example(), folder);
    const std::string page = content("study.html");
    const auto elements = elements_of(page);
    EXPECT_EQ(count(elements, "tr"), 1U + 6U);
    EXPECT_EQ(of_class(elements, "best").size(), 1U + 1U) << "the row, and the ring in the plot";
    EXPECT_NE(page.find("<td>broke down: speed &gt; &quot;sound&quot;</td>"), std::string::npos);
    EXPECT_NE(page.find("3.0 MiB"), std::string::npos);
    EXPECT_NE(page.find("6 variants of scene.json: 4 completed, 1 broke down, 1 refused."),
              std::string::npos);
    EXPECT_NE(page.find("meets the target 0.01 is <strong>gimp &amp; 3</strong>"), std::string::npos);
}

TEST_F(ReportTest, AMissedTargetIsSaid) {
    Json study = example();
    study.erase("best");
    study["target"] = 1e-9;
    write_report(study, folder);
    EXPECT_NE(content("study.html")
                  .find("No variant meets the target 1e-09. The most accurate is "
                        "<strong>gimp &amp; 4</strong>"),
              std::string::npos);
}

TEST_F(ReportTest, AStudyWithoutACompletedVariantIsReported) {
    Json study = example();
    study.erase("best");
    for (Json& row : study["variants"]) {
        row["status"] = "crashed";
        row["error"] = row["cost"] = nullptr;
        row["front"] = false;
    }
    write_report(study, folder);
    EXPECT_NE(content("study.svg").find("no completed variant"), std::string::npos);
    EXPECT_NO_THROW(elements_of(content("study.html")));
    study["variants"] = Json::array();
    study.erase("target");
    write_report(study, folder);
    EXPECT_NO_THROW(elements_of(content("study.html")));
}

TEST_F(ReportTest, TradePlotHasFrontBestAndBrokenVariants) {
    const Plot plot = trade_plot(example());
    ASSERT_EQ(plot.series.size(), 2U) << "by shape function";
    EXPECT_EQ(plot.series[0].name, "linear");
    EXPECT_EQ(plot.series[1].points.size(), 2U);
    EXPECT_EQ(plot.series[1].broken.size(), 1U) << "a refused variant has not run";
    ASSERT_EQ(plot.front.size(), 3U);
    EXPECT_EQ(plot.front[1].x, 2);
    EXPECT_EQ(plot.y.label, "largest error");
    EXPECT_EQ(plot.x.label, "cpu seconds");
    ASSERT_TRUE(plot.best);
    EXPECT_EQ(plot.best->y, 8e-3);
}

TEST_F(ReportTest, PlotsShowSettingsDividedAndFiltered) {
    const Json study = example();
    Plot plot = study_plot(study, study["plots"][0]);
    ASSERT_EQ(plot.series.size(), 2U);
    EXPECT_EQ(plot.series[0].points[0].x, 0.1);
    EXPECT_EQ(plot.series[1].broken[0].x, 0.025);
    EXPECT_EQ(plot.x.label, "cell size / 2");
    plot = study_plot(study, {{"name", "p"},
                              {"x", "cost"},
                              {"y", "particle_steps"},
                              {"y_scale", "linear"},
                              {"where", {{"/grid/cell_size", 0.1}}},
                              {"lines", {"/shape_function", "/grid/cell_size"}}});
    ASSERT_EQ(plot.series.size(), 2U);
    EXPECT_EQ(plot.series[1].name, "gimp, cell size 0.1");
    EXPECT_EQ(plot.series[1].points.at(0).y, 4000);
    EXPECT_FALSE(plot.y.logarithmic);
    EXPECT_FALSE(plot.target);
}

TEST_F(ReportTest, KindsThatFollowFromOthersAreNotNamedTwice) {
    Json rows = Json::array();
    for (const char* set : {"a", "b"}) {
        for (const char* integrator : {"usl", "usf"}) {
            rows.push_back({{"variant", set},
                            {"settings",
                             {{"/shape_function/type", std::string("shape of ") + set},
                              {"/integrator/type", integrator},
                              {"/time/cfl", 0.1}}}});
        }
    }
    std::vector<const Json*> variants;
    for (const Json& row : rows) variants.push_back(&row);
    EXPECT_EQ(kind_keys(variants), (std::vector<std::string>{"variant", "/integrator/type"}));
    const auto groups = grouped(variants, kind_keys(variants));
    ASSERT_EQ(groups.size(), 4U);
    EXPECT_EQ(groups[3].name, "b, usf");
    EXPECT_EQ(groups[3].style.colour, 1U);
    EXPECT_EQ(groups[2].style.marker, 0U);
}

TEST_F(ReportTest, LimitsAreBars) {
    const auto row = [](const char* name, const char* status, const Json& limit) {
        return Json{{"number", 1},
                    {"name", name},
                    {"variant", name},
                    {"settings", Json::object()},
                    {"limit", limit},
                    {"status", status},
                    {"reason", "broke down < here"}};
    };
    Json limits{{"title", "Limits & more"},
                {"scene", "scene.json"},
                {"search", {{"pointer", "/time/cfl"}, {"from", 0.05}, {"to", 2.0}, {"digits", 2}}},
                {"stable", {{"summary", "/error/linf"}, {"below", 0.1}}},
                {"variants",
                 {row("a", "found", 0.5), row("b", "found", 1), row("c", "stable_everywhere", 2),
                  row("d", "unstable_everywhere", nullptr), row("e", "refused", nullptr)}}};
    write_limits_report(limits, folder);
    const auto elements = elements_of(content("limits.svg"));
    const auto bars = of_class(elements, "bar");
    ASSERT_EQ(bars.size(), 3U);
    const auto length = [&](std::size_t i) { return std::stod(bars[i].attributes.at("width")); };
    EXPECT_NEAR(length(1), 2 * length(0), 0.2);
    EXPECT_NEAR(length(2), 4 * length(0), 0.4);
    const std::string page = content("limits.html");
    EXPECT_EQ(count(elements_of(page), "tr"), 1U + 5U);
    EXPECT_NE(page.find("unstable even at 0.05"), std::string::npos);
    EXPECT_NE(page.find("stable even at 2"), std::string::npos);
    limits["variants"] = Json::array();
    EXPECT_NO_THROW(write_limits_report(limits, folder));
}

}  // namespace
