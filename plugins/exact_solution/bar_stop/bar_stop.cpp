#include "../bar.hpp"

#include <matpoint/plugin.hpp>

namespace matpoint {

/// A flying bar whose one end is stopped; see README.md.
class BarStop final : public BarSolution {
  public:
    static Schema schema() {
        Schema schema("An elastic bar that flies is stopped at x = 0 at time 0",
                      "[Wallstedt & Guilkey 2007, section 5.2]");
        schema.number("velocity", {.unit = "m/s", .doc = "Velocity of the flight", .paper = "v_0"});
        add_bar_length(schema);
        return bar_rules(schema);
    }
    explicit BarStop(const Parameters& parameters)
        : BarSolution(parameters),
          velocity_(parameters.number("velocity")),
          length_(parameters.number("length")) {}

    BarMotion motion(double x, double time) const override {
        return stopped_bar(length_, velocity_, wave_speed(), x, time);
    }

  private:
    double velocity_, length_;  ///< m/s, m
};

}  // namespace matpoint

MATPOINT_PLUGIN("bar_stop", "1.0.0") {
    registry.exact_solution<matpoint::BarStop>("bar_stop");
}
