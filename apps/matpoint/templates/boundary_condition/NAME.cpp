#include <matpoint/boundary_condition.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>
#include <numbers>

using namespace matpoint;

/// A wall that swings along its normal; see README.md.
template <class Space>
class {{Name}} final : public BoundaryCondition<Space> {
  public:
    using Real = typename Space::Real;
    using Vector = typename Space::Vector;
    using Position = typename Space::Position;

    static Schema schema() {
        return Schema("Velocity A w sin(w t), w = 2 pi f, along every prescribed axis")
            .number("amplitude", {.unit = "m", .doc = "A, half of the whole way", .at_least = 0})
            .number("frequency", {.unit = "Hz", .doc = "f", .greater_than = 0});
    }
    explicit {{Name}}(const Parameters& parameters)
        : A_(parameters.number("amplitude")), w_(2 * std::numbers::pi * parameters.number("frequency")) {}

    /// A face lets things slide along it; a region takes them along in all directions.
    std::array<bool, 3> prescribes(int axis) const override { return {axis <= 0, axis == 1 || axis < 0, axis == 2 || axis < 0}; }

    Vector velocity(const Position&, double time) const override {
        return Vector::Constant(Real(A_ * w_ * std::sin(w_ * time)));
    }

  private:
    double A_, w_;  // m, 1/s
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.boundary_condition<{{Name}}>("{{name}}"); }
