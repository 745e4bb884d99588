#include "../bar.hpp"

#include <matpoint/plugin.hpp>

#include <numbers>

namespace matpoint {

/// A standing wave in a bar that is fixed at both ends; see README.md.
class BarWave final : public BarSolution {
  public:
    static Schema schema() {
        Schema schema("A standing wave in an elastic bar that is fixed at both ends",
                      "[Wallstedt & Guilkey 2007, section 5.2]");
        schema
            .number("amplitude",
                    {.unit = "m", .doc = "Displacement at the start", .paper = "A", .default_value = 0.01})
            .integer("mode", {.doc = "Number of half waves along the bar",
                              .paper = "n",
                              .default_value = 1,
                              .at_least = 1});
        add_bar_length(schema);
        schema.refuse("/amplitude",
                      "turns the bar inside out: its magnitude must be less than length / (mode pi)",
                      [](const Json& own, const Json&) {
                          return std::abs(own.at("amplitude").get<double>()) * own.at("mode").get<double>() *
                                     std::numbers::pi >=
                                 own.at("length").get<double>();
                      });
        return bar_rules(schema);
    }
    explicit BarWave(const Parameters& parameters)
        : BarSolution(parameters),
          amplitude_(parameters.number("amplitude")),
          wave_number_(static_cast<double>(parameters.integer("mode")) * std::numbers::pi /
                       parameters.number("length")) {}

    BarMotion motion(double x, double time) const override {
        const double k = wave_number_, omega = k * wave_speed();
        return {amplitude_ * std::sin(k * x) * std::cos(omega * time),
                -omega * amplitude_ * std::sin(k * x) * std::sin(omega * time),
                k * amplitude_ * std::cos(k * x) * std::cos(omega * time)};
    }

  private:
    double amplitude_, wave_number_;  ///< m, 1/m
};

}  // namespace matpoint

MATPOINT_PLUGIN("bar_wave", "1.0.0") {
    registry.exact_solution<matpoint::BarWave>("bar_wave");
}
