#include <matpoint/plugin.hpp>
#include <matpoint/transfer.hpp>

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

    /// v_p += sum S a dt [Wallstedt & Guilkey 2008, eq. 18], mixed with the grid's velocity.
    void update(const ParticleBatch<S>& batch, Real dt) const override {
        const Index count = batch.end() - batch.begin();
        for (int c = 0; c < S::dimension; ++c) {
            Real* v = batch.particles().column(Field::velocity, c) + batch.begin();
            const Real* a = batch.gathered().acceleration[static_cast<std::size_t>(c)].data();
            if constexpr (S::single) {
                // What rounding leaves out is added the next time: a dt may be far smaller than v.
                Real* rest = batch.particles().column(Field::velocity_remainder, c) + batch.begin();
                for (Index i = 0; i < count; ++i) {
                    const Real before = v[i], increment = rest[i] + a[i] * dt;
                    v[i] = before + increment;
                    rest[i] = increment - (v[i] - before);
                }
            } else {
                for (Index i = 0; i < count; ++i) v[i] += a[i] * dt;
            }
            if (pic_fraction_ == Real(0)) continue;
            const Real* grid = batch.gathered().velocity[static_cast<std::size_t>(c)].data();
            for (Index i = 0; i < count; ++i)
                v[i] = (Real(1) - pic_fraction_) * v[i] + pic_fraction_ * grid[i];
        }
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
