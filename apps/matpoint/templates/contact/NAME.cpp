#include <matpoint/contact.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

using namespace matpoint;

/// Friction that falls with the speed of sliding; see README.md.
template <class Space>
class {{Name}} final : public ContactLaw<Space> {
  public:
    using Real = typename Space::Real;
    using Vector = typename Space::Vector;

    static Schema schema() {
        Schema schema("Friction mu / (1 + |w_t| / v0)");
        schema.number("friction", {.doc = "mu, at rest", .at_least = 0})
            .number("speed", {.unit = "m/s", .doc = "v0, at which half of it is left", .greater_than = 0});
        ContactLaw<Space>::declare_pair(schema);
        return schema;
    }
    explicit {{Name}}(const Parameters& parameters)
        : friction_(Real(parameters.number("friction"))), speed_(Real(parameters.number("speed"))) {}

    void impulses(std::span<const ContactPoint<Space>> points, std::span<Vector> out) const override {
        for (std::size_t k = 0; k < points.size(); ++k) out[k] = impulse(points[k]);
    }

  private:
    Vector impulse(const ContactPoint<Space>& at) const {
        if (!(at.pressing > 0)) return Vector::Zero();
        const Real sliding = (at.velocity - at.normal * at.normal.dot(at.velocity)).norm();
        const Real most = friction_ / (1 + sliding / speed_) * at.pressing, size = at.sticking.norm();
        return at.pressing * at.normal + (size > most ? most / size : Real(1)) * at.sticking;
    }

    Real friction_, speed_;
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.contact<{{Name}}>("{{name}}"); }
