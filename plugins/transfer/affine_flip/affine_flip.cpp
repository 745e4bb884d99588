#include <matpoint/plugin.hpp>
#include <matpoint/transfer.hpp>
#include <matpoint/velocity_update.hpp>

namespace matpoint {
namespace {

template <class S>
class AffineFlip final : public Transfer<S> {
  public:
    using typename Transfer<S>::Real;

    explicit AffineFlip(const Parameters& parameters)
        : pic_fraction_(static_cast<Real>(parameters.number("pic_fraction"))) {}

    static Schema schema() {
        Schema schema(
            "Particles keep their velocity and add the grid's acceleration, as with flip, and take the "
            "affine "
            "part from the grid, as with apic: keeps angular momentum and hardly damps.",
            "[Fei et al. 2021]");
        schema.number("pic_fraction",
                      {.doc = "Share of the velocity that the grid's replaces in each step (1: APIC); quiets "
                              "what the grid doesn't see.",
                       .default_value = 0.01,
                       .at_least = 0,
                       .at_most = 1});
        return schema;
    }

    void declare(Particles<S>& particles) const override {
        particles.require(Field::velocity_remainder);
        particles.require(Field::affine_velocity);
    }
    std::optional<Field> affine() const override { return Field::affine_velocity; }
    bool needs_acceleration() const override { return true; }
    bool needs_affine() const override { return true; }
    Real grid_share() const override { return pic_fraction_; }

    /// v_p = (1 - f) (v_p + sum S a dt) + f sum S v_i, C_p = B_p D_p^-1 [Fei et al. 2021].
    void update(const ParticleBatch<S>& batch, Real dt) const override {
        add_acceleration(batch, dt);
        mix_velocity(batch, pic_fraction_);
        take_affine_velocity(batch);
    }

  private:
    Real pic_fraction_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("affine_flip", "1.0.0") {
    registry.transfer<matpoint::AffineFlip>("affine_flip");
}
