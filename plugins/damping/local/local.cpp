#include <matpoint/damping.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

namespace matpoint {
namespace {

/// a_d = -alpha |a| sign(v), axis by axis [Cundall 1987].
template <class S>
class Local final : public Damping<S> {
  public:
    using typename Damping<S>::Real;

    explicit Local(const Parameters& parameters) : factor_(static_cast<Real>(parameters.number("factor"))) {}

    static Schema schema() {
        return Schema(
                   "A part of each node's unbalanced force acts against its velocity. Does nothing to what "
                   "is "
                   "in balance, and needs no knowledge of the scene's frequencies.",
                   "[Cundall 1987, Distinct element models of rock and soil structure]")
            .number("factor",
                    {.doc = "The part, alpha", .default_value = 0.8, .at_least = 0, .less_than = 1});
    }

    void resist(std::span<const Real> velocity, std::span<const Real> acceleration, Real,
                std::span<Real> out) const override {
        for (std::size_t i = 0; i < out.size(); ++i) {
            const Real against = velocity[i] > 0 ? Real(-1) : velocity[i] < 0 ? Real(1) : Real(0);
            out[i] = factor_ * std::abs(acceleration[i]) * against;
        }
    }

  private:
    Real factor_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("local", "1.0.0") {
    registry.damping<matpoint::Local>("local");
}
