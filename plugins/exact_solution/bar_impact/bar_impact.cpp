#include "../bar.hpp"

#include <matpoint/plugin.hpp>

namespace matpoint {

/// Two equal bars that hit each other and rebound; see README.md.
class BarImpact final : public BarSolution {
  public:
    static Schema schema() {
        Schema schema("Two equal elastic bars fly towards each other, hit and rebound",
                      "[Chen & Brannon 2002, figures 7 to 10]");
        schema
            .number("velocity", {.unit = "m/s",
                                 .doc = "Velocity of the left bar; the right one's is the opposite",
                                 .paper = "V_0 / 2",
                                 .greater_than = 0})
            .number("start", {.unit = "m", .doc = "Left end of the left bar", .default_value = 0.0})
            .number("length", {.unit = "m",
                               .doc = "Length of each bar",
                               .paper = "L",
                               .default_value = 0.5,
                               .greater_than = 0})
            .number("gap",
                    {.unit = "m", .doc = "Distance between the bars", .default_value = 0.5, .at_least = 0})
            .number("contact_distance",
                    {.unit = "m",
                     .doc = "Distance at which the bars feel each other: 0 in truth, about a cell on a grid "
                            "without a law of contact",
                     .default_value = 0.0,
                     .at_least = 0})
            .refuse("/contact_distance", "is greater than the gap", [](const Json& own, const Json&) {
                return own.at("contact_distance").get<double>() > own.at("gap").get<double>();
            });
        warn_of_extent(
            schema,
            "the bars of the solution lie on [start, start + length] and, a gap further, on "
            "[start + length + gap, start + 2 length + gap], and a body elsewhere",
            [](const Json& own, double min, double max) {
                const double start = own.at("start").get<double>(), length = own.at("length").get<double>(),
                             right = start + length + own.at("gap").get<double>();
                const auto near = [&](double a, double b) { return std::abs(a - b) <= 1e-9 * length; };
                return !(near(min, start) && near(max, start + length)) &&
                       !(near(min, right) && near(max, right + length));
            });
        return bar_rules(schema);
    }
    explicit BarImpact(const Parameters& parameters)
        : BarSolution(parameters),
          velocity_(parameters.number("velocity")),
          length_(parameters.number("length")),
          gap_(parameters.number("gap")),
          middle_(parameters.number("start") + length_ + gap_ / 2),
          contact_time_((gap_ - parameters.number("contact_distance")) / (2 * velocity_)) {}

    BarMotion motion(double x, double time) const override {
        const double side = x < middle_ ? -1 : 1;  // away from the other bar
        const double depth = side * (x - middle_) - gap_ / 2;
        const double since = time - contact_time_, duration = 2 * length_ / wave_speed();
        if (since <= 0) return {-side * velocity_ * time, -side * velocity_, 0};
        const double flown = -side * velocity_ * contact_time_;
        if (since >= duration) return {flown + side * velocity_ * (since - duration), side * velocity_, 0};
        // By symmetry the bars' ends stand still, as at a wall.
        const BarMotion bar = stopped_bar(length_, -velocity_, wave_speed(), depth, since);
        return {flown + side * bar.displacement, side * bar.velocity, bar.strain};
    }

  private:
    double velocity_, length_, gap_;  ///< m/s, m
    double middle_;                   ///< where they meet, m
    double contact_time_;             ///< s
};

}  // namespace matpoint

MATPOINT_PLUGIN("bar_impact", "1.0.0") {
    registry.exact_solution<matpoint::BarImpact>("bar_impact");
}
