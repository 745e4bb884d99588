#include <matpoint/damping.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {
namespace {

/// Stops all motion whenever the kinetic energy has passed a peak [Cundall 1976].
template <class S>
class Kinetic final : public Damping<S> {
  public:
    explicit Kinetic(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "All motion stops whenever the kinetic energy of the scene has passed a peak: bodies swing "
            "through "
            "their state of rest then. Has no parameter to choose.",
            "[Cundall 1976, Explicit finite-difference methods in geomechanics; Barnes 1999]");
    }

    bool stops(double energy_before, double energy) const override { return energy < energy_before; }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("kinetic", "1.0.0") {
    registry.damping<matpoint::Kinetic>("kinetic");
}
