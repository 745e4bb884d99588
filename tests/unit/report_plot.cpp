// Pictures of plots, read back as XML.

#include "report/slope_guides.hpp"
#include "report/svg_plot.hpp"

#include "report_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using namespace matpoint;

/// Two marks' distance is what is known of the layout: the plot's frame is 560 x 380 pixels.
constexpr double width = 560, height = 380;

struct Place {
    double x, y;
};

/// Where a mark is: the path begins there.
Place place_of(const Element& mark) {
    Place place{};
    char separator = 0;
    std::istringstream path(mark.attributes.at("d"));
    path >> separator >> place.x >> place.y;
    EXPECT_EQ(separator, 'M');
    return place;
}

std::vector<Place> vertices(const Element& polyline) {
    std::vector<Place> all;
    std::istringstream points(polyline.attributes.at("points"));
    char comma = 0;
    for (Place place{}; points >> place.x >> comma >> place.y;) all.push_back(place);
    return all;
}

/// The mark with a text.
Place place_of(const std::vector<Element>& elements, const std::string& text) {
    for (std::size_t i = 1; i < elements.size(); ++i) {
        if (elements[i].name == "title" && elements[i].text == text) return place_of(elements[i - 1]);
    }
    ADD_FAILURE() << "no mark " << text;
    return {};
}

Plot example() {
    Plot plot{.title = "t", .x = {"cost"}, .y = {"error"}};
    plot.series.push_back(
        {.name = "a", .points = {{1, 1e-1, "left"}, {10, 1e-2, "middle"}, {100, 1e-3, "right"}}});
    return plot;
}

TEST(ReportPlot, PointsLieWhereTheirLogarithmsAre) {
    const auto elements = elements_of(svg(example()));
    const Place left = place_of(elements, "left"), middle = place_of(elements, "middle"),
                right = place_of(elements, "right");
    // Two decades and a tenth of that around them fill the frame.
    EXPECT_NEAR(middle.x - left.x, width / 2.2, 0.15);
    EXPECT_NEAR(right.x - middle.x, width / 2.2, 0.15);
    EXPECT_NEAR(middle.y - left.y, height / 2.2, 0.15);
    EXPECT_NEAR(right.y - middle.y, height / 2.2, 0.15);
}

TEST(ReportPlot, TheFrontGoesThroughItsPoints) {
    Plot plot = example();
    plot.front = {{1, 1e-1}, {100, 1e-3}};
    const auto elements = elements_of(svg(plot));
    const auto fronts = of_class(elements, "front");
    ASSERT_EQ(fronts.size(), 1U);
    const auto line = vertices(fronts.front());
    ASSERT_EQ(line.size(), 2U);
    EXPECT_DOUBLE_EQ(line[0].x, place_of(elements, "left").x);
    EXPECT_DOUBLE_EQ(line[0].y, place_of(elements, "left").y);
    EXPECT_DOUBLE_EQ(line[1].x, place_of(elements, "right").x);
    EXPECT_DOUBLE_EQ(line[1].y, place_of(elements, "right").y);
}

TEST(ReportPlot, BrokenDownVariantsAreAboveThePlotAtTheirX) {
    Plot plot = example();
    plot.series[0].broken = {{10, 0, "lost"}};
    plot.series.push_back({.name = "b", .style = {1, 1}, .broken = {{10, 0, "lost too"}}});
    const auto elements = elements_of(svg(plot));
    EXPECT_EQ(of_class(elements, "broken").size(), 2U);
    const Place lost = place_of(elements, "lost"), lost_too = place_of(elements, "lost too");
    EXPECT_DOUBLE_EQ(lost.x, place_of(elements, "middle").x);
    EXPECT_LT(lost.y, place_of(elements, "left").y);
    EXPECT_GT(lost_too.y, lost.y + 5) << "each series has its own row";
    EXPECT_TRUE(of_class(elements_of(svg(example())), "broken").empty());
}

TEST(ReportPlot, TargetAndBestAreAtTheirValues) {
    Plot plot = example();
    plot.target = 1e-2;
    plot.best = {100, 1e-3, "best"};
    const auto elements = elements_of(svg(plot));
    const auto targets = of_class(elements, "target"), bests = of_class(elements, "best");
    ASSERT_EQ(targets.size(), 1U);
    EXPECT_DOUBLE_EQ(place_of(targets.front()).y, place_of(elements, "middle").y);
    ASSERT_EQ(bests.size(), 1U);
    EXPECT_DOUBLE_EQ(std::stod(bests.front().attributes.at("cx")), place_of(elements, "right").x);
}

TEST(ReportPlot, LinesGoInTheOrderOfXButNotBackOverARepeatedOne) {
    Plot plot{.title = "t", .x = {"x"}, .y = {"y"}, .lines = true};
    plot.series.push_back({.name = "a", .points = {{4, 1}, {1, 2}, {2, 3}}});
    std::vector<Element> elements = elements_of(svg(plot));
    const auto is_line = [](const Element& element) { return element.name == "polyline"; };
    const auto line = std::find_if(elements.begin(), elements.end(), is_line);
    ASSERT_NE(line, elements.end());
    const auto places = vertices(*line);
    ASSERT_EQ(places.size(), 3U);
    EXPECT_LT(places[0].x, places[1].x);
    EXPECT_LT(places[1].x, places[2].x);

    plot.series[0].points.push_back({2, 5});
    elements = elements_of(svg(plot));
    EXPECT_EQ(std::count_if(elements.begin(), elements.end(), is_line), 0);
}

TEST(ReportPlot, ZeroAndNegativeErrorsAreBelowTheLogarithmicAxis) {
    Plot plot = example();
    plot.series[0].points.push_back({10, 0, "none"});
    plot.series[0].points.push_back({100, -1, "less"});
    plot.series[0].points.push_back({0, 1e-2, "free"});
    const auto elements = elements_of(svg(plot));
    EXPECT_GT(place_of(elements, "none").y, place_of(elements, "right").y);
    EXPECT_DOUBLE_EQ(place_of(elements, "none").y, place_of(elements, "less").y);
    EXPECT_DOUBLE_EQ(place_of(elements, "none").x, place_of(elements, "middle").x);
    EXPECT_LT(place_of(elements, "free").x, place_of(elements, "left").x);
}

TEST(ReportPlot, NothingOrOneOrEqualValuesMakeAPicture) {
    Plot plot{.title = "t", .x = {"x"}, .y = {"y"}, .lines = true, .slopes = {2}, .target = 1e-3};
    const auto is_finite = [](const Plot& shown) {
        const std::string picture = svg(shown);
        EXPECT_NO_THROW(elements_of(picture));
        EXPECT_EQ(picture.find("nan"), std::string::npos);
        EXPECT_EQ(picture.find("inf"), std::string::npos);
    };
    is_finite(plot);
    EXPECT_NE(svg(plot).find("no completed variant"), std::string::npos);
    plot.series = {{.name = "a", .broken = {{1, 0, "lost"}}}};
    is_finite(plot);
    plot.series[0].points = {{1, 1e-3, "only"}};
    is_finite(plot);
    plot.series[0].points = {{1, 1e-3}, {2, 1e-3}, {2, 1e-3}};
    is_finite(plot);
    plot.series[0].points = {{0, 0}, {-1, 0}};
    is_finite(plot);
    plot.x.logarithmic = plot.y.logarithmic = false;
    is_finite(plot);
}

TEST(ReportPlot, TextOfOthersIsEscaped) {
    Plot plot{.title = "a < b & \"c\"", .x = {"<x>"}, .y = {"y & 'z'"}};
    plot.series.push_back({.name = "<&>", .points = {{1, 1, "\"<\x01&"}}});
    const auto elements = elements_of(svg(plot));
    EXPECT_EQ(elements.at(1).text, "a &lt; b &amp; &quot;c&quot;");
    place_of(elements, "&quot;&lt; &amp;");
}

TEST(ReportPlot, LongNamesAreCutBetweenCharactersAndKeptForThePointer) {
    Plot plot = example();
    for (int i = 0; i < 100; ++i) plot.series[0].name += "é";
    const std::string picture = svg(plot);
    EXPECT_NE(picture.find("é…</text><title>aé"), std::string::npos);
}

TEST(ReportPlot, ThousandsOfPointsStaySmall) {
    Plot plot{.title = "t", .x = {"x"}, .y = {"y"}};
    for (std::size_t s = 0; s < 4; ++s) {
        PlotSeries series{.name = "s", .style = {s, s}};
        for (int i = 1; i <= 950; ++i)
            series.points.push_back(
                {0.01 * i, 1e-3 * (1 + std::abs(std::sin(i * i))), "a variant of that name"});
        plot.series.push_back(series);
    }
    EXPECT_LT(svg(plot).size(), 400'000U);
    plot.lines = true;
    const std::string lines = svg(plot);
    EXPECT_LT(lines.size(), 80'000U);
    for (const Element& element : elements_of(lines))
        if (element.name == "polyline") {
            EXPECT_EQ(vertices(element).size(), 950U);
        }
}

TEST(ReportPlot, SlopeGuidesHaveTheirSlopeAndLieBelowThePoints) {
    PlotSeries series{.name = "a"};
    for (const double h : {0.01, 0.02, 0.04, 0.08, 0.16}) series.points.push_back({h, 7 * h * h});
    const auto guides = slope_guides({series}, {2, 1});
    ASSERT_EQ(guides.size(), 2U);
    for (const SlopeGuide& guide : guides) {
        EXPECT_NEAR(std::log(guide.to_y / guide.from_y) / std::log(guide.to_x / guide.from_x), guide.slope,
                    1e-9);
        EXPECT_LT(guide.from_y, 7 * guide.from_x * guide.from_x);
        EXPECT_LT(guide.to_y, 7 * guide.to_x * guide.to_x);
    }
    EXPECT_LT(guides[0].to_x, guides[1].from_x) << "side by side";
    EXPECT_TRUE(slope_guides({{.name = "a", .points = {{1, 1}}}}, {2}).empty());
}

TEST(ReportPlot, SlopeGuidesDoNotCrossLinesBetweenFarPoints) {
    const PlotSeries series{.name = "a", .points = {{1, 1}, {100, 0.5}, {10000, 0.4}}};
    const auto line = [](double x) {
        return x < 100 ? std::pow(0.5, std::log10(x) / 2) : 0.5 * std::pow(0.8, std::log10(x / 100) / 2);
    };
    for (const double slope : {-2.0, 1.0, 4.0}) {
        for (const SlopeGuide& guide : slope_guides({series}, {slope, slope, slope})) {
            EXPECT_LT(guide.from_y, line(guide.from_x)) << slope;
            EXPECT_LT(guide.to_y, line(guide.to_x)) << slope;
        }
    }
}

TEST(ReportPlot, MarksOfManySeriesDiffer) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < 56; ++i)
        EXPECT_TRUE(seen.insert(colour_of({i, i}) + marker_path({i, i}, 0, 0, 4)).second) << i;
}

}  // namespace
