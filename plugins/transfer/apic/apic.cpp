#include <matpoint/plugin.hpp>
#include <matpoint/transfer.hpp>
#include <matpoint/velocity_update.hpp>

namespace matpoint {
namespace {

template <class S>
class Apic final : public Transfer<S> {
  public:
    using typename Transfer<S>::Real;

    explicit Apic(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Affine particle in cell: particles take the grid's velocity and its affine part, which keeps "
            "angular momentum; no noise, little damping.",
            "[Jiang et al. 2015]");
    }

    void declare(Particles<S>& particles) const override { particles.require(Field::affine_velocity); }
    std::optional<Field> affine() const override { return Field::affine_velocity; }
    bool needs_acceleration() const override { return false; }
    bool needs_affine() const override { return true; }
    Real grid_share() const override { return Real(1); }

    /// v_p = sum S v_i, C_p = B_p D_p^-1 [Jiang et al. 2015].
    void update(const ParticleBatch<S>& batch, Real) const override {
        mix_velocity(batch, Real(1));
        take_affine_velocity(batch);
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("apic", "1.0.0") {
    registry.transfer<matpoint::Apic>("apic");
}
