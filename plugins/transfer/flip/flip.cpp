#include <matpoint/plugin.hpp>
#include <matpoint/transfer.hpp>
#include <matpoint/velocity_update.hpp>

namespace matpoint {
namespace {

template <class S>
class Flip final : public Transfer<S> {
  public:
    using typename Transfer<S>::Real;

    explicit Flip(const Parameters& parameters)
        : pic_fraction_(static_cast<Real>(parameters.number("pic_fraction"))),
          gradient_enhanced_(parameters.boolean("gradient_enhanced")) {}

    static Schema schema() {
        const auto enhanced = [](const Json& own) { return own.value("gradient_enhanced", false); };
        const auto type_is = [](const Json& scene, const char* section, const char* type) {
            return scene.contains(section) && scene.at(section).value("type", "") == type;
        };
        Schema schema(
            "Particles keep their velocity and add the grid's acceleration; a share may be replaced "
            "by the grid's velocity.",
            "[Wallstedt & Guilkey 2008, eq. 9, 18]");
        schema
            .number("pic_fraction",
                    {.doc = "Share of the velocity that the grid's replaces in each step (0: FLIP, 1: PIC); "
                            "damps noise, and motion with it.",
                     .default_value = 0,
                     .at_least = 0,
                     .at_most = 1})
            .boolean(
                "gradient_enhanced",
                {.doc =
                     "Whether particles extend their velocity to the nodes by its gradient, which projects "
                     "linear fields exactly.",
                 .paper = "[Wallstedt & Guilkey 2007, eq. 4.1-4.3]",
                 .default_value = false})
            .refuse("/gradient_enhanced",
                    "\"usf\" takes the stress's gradient before the forces act, a step older than the "
                    "velocity that it "
                    "would extend to the nodes, which is unstable; choose \"usl\", \"musl\" or "
                    "\"central_difference\"",
                    [=](const Json& own, const Json& scene) {
                        return enhanced(own) && type_is(scene, "integrator", "usf");
                    })
            .warn("/gradient_enhanced",
                  "has no effect with \"uvf\", which never reads the velocity that it projects first",
                  [=](const Json& own, const Json& scene) {
                      return enhanced(own) && type_is(scene, "integrator", "uvf");
                  })
            .warn("/gradient_enhanced",
                  "linear shape functions give gradients too poor for it: \"pathologically unstable\" "
                  "[Wallstedt & "
                  "Guilkey 2007, section 5.2]; choose \"gimp\" or \"bspline\"",
                  [=](const Json& own, const Json& scene) {
                      return enhanced(own) && type_is(scene, "shape_function", "linear");
                  });
        return schema;
    }

    void declare(Particles<S>& particles) const override {
        particles.require(Field::velocity_remainder);
        if (gradient_enhanced_) particles.require(Field::velocity_gradient);
    }
    /// v_ip = v_p - L (x_p - x_i) [Wallstedt & Guilkey 2007, eq. 4.1, 4.3].
    std::optional<Field> affine() const override {
        if (gradient_enhanced_) return Field::velocity_gradient;
        return {};
    }
    bool needs_acceleration() const override { return true; }
    Real grid_share() const override { return pic_fraction_; }

    /// The grid's acceleration is added [Wallstedt & Guilkey 2008, eq. 18], and its velocity mixed in.
    void update(const ParticleBatch<S>& batch, Real dt) const override {
        add_acceleration(batch, dt);
        mix_velocity(batch, pic_fraction_);
    }

  private:
    Real pic_fraction_;
    bool gradient_enhanced_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("flip", "1.0.0") {
    registry.transfer<matpoint::Flip>("flip");
}
