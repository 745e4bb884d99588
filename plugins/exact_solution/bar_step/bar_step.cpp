#include "../bar.hpp"

#include <matpoint/plugin.hpp>

namespace matpoint {

/// A fixed bar that is drawn by a step force; see README.md.
class BarStep final : public BarSolution {
  public:
    static Schema schema() {
        Schema schema("An elastic bar at rest, fixed at x = 0, is drawn at its other end from time 0 on",
                      "[Chen & Brannon 2002, figures 1 and 2]");
        schema.number("traction", {.unit = "Pa", .doc = "Force per area at x = length", .paper = "f"});
        add_bar_length(schema);
        schema.warn(
            "",
            "the bar moves like this under its traction only: add a load \"traction\", or \"manufactured\" "
            "with \"tractions_on\": [\"x_max\"]",
            [](const Json&, const Json& scene) { return scene.at("loads").empty(); });
        return bar_rules(schema);
    }
    explicit BarStep(const Parameters& parameters)
        : BarSolution(parameters),
          traction_(parameters.number("traction")),
          length_(parameters.number("length")) {}

    /// The static solution f x / E, less the vibration that starts from it: a triangle wave that is x on [0,
    /// L].
    BarMotion motion(double x, double time) const override {
        const TriangleWave wave(length_);
        const double c = wave_speed(), strain = traction_ / youngs_modulus();
        const double ahead = x + c * time - length_, behind = x - c * time - length_;
        return {strain * (x - length_ + (wave(ahead) + wave(behind)) / 2),
                strain * c / 2 * (wave.slope(ahead) - wave.slope(behind)),
                strain * (1 + (wave.slope(ahead) + wave.slope(behind)) / 2)};
    }

  private:
    double traction_, length_;  ///< Pa, m
};

}  // namespace matpoint

MATPOINT_PLUGIN("bar_step", "1.0.0") {
    registry.exact_solution<matpoint::BarStep>("bar_step");
}
