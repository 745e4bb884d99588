#include <matpoint/plugin.hpp>
#include <matpoint/transfer.hpp>
#include <matpoint/velocity_update.hpp>

namespace matpoint {
namespace {

template <class S>
class Fmpm final : public Transfer<S> {
  public:
    using typename Transfer<S>::Real;

    explicit Fmpm(const Parameters& parameters) : order_(static_cast<int>(parameters.integer("order"))) {}

    static Schema schema() {
        Schema schema(
            "Full mass matrix: particles take the velocity that its inverse, a series of `order` terms, "
            "makes "
            "of the nodes' momenta; damps the less the more terms there are.",
            "[Nairn & Hammerquist 2021]");
        schema.integer("order",
                       {.doc = "Terms k of the series (1: PIC); each beyond the first is another pass "
                               "to the particles and back",
                        .default_value = 2,
                        .at_least = 1,
                        .at_most = 100});
        return schema;
    }

    void declare(Particles<S>& particles) const override {
        if (order_ > 1) particles.require(Field::grid_velocity);
    }
    bool needs_acceleration() const override { return false; }
    Real grid_share() const override { return Real(1); }
    int order() const override { return order_; }

    /// v_p = sum S v_i [Nairn & Hammerquist 2021].
    void update(const ParticleBatch<S>& batch, Real) const override { mix_velocity(batch, Real(1)); }

  private:
    int order_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("fmpm", "1.0.0") {
    registry.transfer<matpoint::Fmpm>("fmpm");
}
