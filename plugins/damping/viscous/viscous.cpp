#include <matpoint/damping.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

namespace matpoint {
namespace {

/// dv/dt = -c v, exactly over a step.
template <class S>
class Viscous final : public Damping<S> {
  public:
    using typename Damping<S>::Real;

    explicit Viscous(const Parameters& parameters) : rate_(parameters.number("rate")) {}

    static Schema schema() {
        return Schema(
                   "Nodes are slowed down in proportion to their velocity. A vibration of angular frequency "
                   "omega is damped most quickly, without swinging over, with a rate of 2 omega.")
            .number("rate", {.unit = "1/s", .doc = "c of dv/dt = -c v", .greater_than = 0});
    }

    void resist(std::span<const Real> velocity, std::span<const Real>, Real dt,
                std::span<Real> out) const override {
        // Of dv/dt = -c v over the whole step: stable at any rate.
        const auto share = static_cast<Real>(std::expm1(-rate_ * static_cast<double>(dt)));
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = share / dt * velocity[i];
    }

  private:
    double rate_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("viscous", "1.0.0") {
    registry.damping<matpoint::Viscous>("viscous");
}
