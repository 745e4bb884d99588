#include <matpoint/damping.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

using namespace matpoint;

/// Resistance that grows with the square of speed; see README.md.
template <class Space>
class {{Name}} final : public Damping<Space> {
  public:
    using Real = typename Space::Real;

    static Schema schema() {
        return Schema("Resistance, dv/dt = -k |v| v").number("resistance", {.unit = "1/m", .doc = "k", .at_least = 0});
    }
    explicit {{Name}}(const Parameters& parameters) : resistance_(Real(parameters.number("resistance"))) {}

    void resist(std::span<const Real> velocity, std::span<const Real>, Real dt, std::span<Real> out) const override {
        // v -> v / (1 + k |v| dt), exactly over a step
        for (std::size_t i = 0; i < out.size(); ++i) {
            const Real size = resistance_ * std::abs(velocity[i]);
            out[i] = -size * velocity[i] / (1 + size * dt);
        }
    }

  private:
    Real resistance_;
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.damping<{{Name}}>("{{name}}"); }
