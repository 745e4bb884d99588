#include <matpoint/contact.hpp>
#include <matpoint/plugin.hpp>

#include <limits>

namespace matpoint {
namespace {

/// Bodies press, slide and let go: |J_t| <= mu J_n.
template <class S>
class Coulomb final : public ContactLaw<S> {
  public:
    using typename ContactLaw<S>::Real;
    using typename ContactLaw<S>::Vector;

    explicit Coulomb(const Parameters& parameters)
        : sticks_(parameters.json().at("friction").is_string()),
          friction_(sticks_ ? Real(0) : static_cast<Real>(parameters.number("friction"))) {}

    static Schema schema() {
        Schema schema(
            "Bodies push each other apart and rub, but don't pull. Within its limit, friction stops sliding "
            "at "
            "once.",
            "[Bardenhagen, Brackbill & Sulsky 2000, doi 10.1016/S0045-7825(99)00338-2]");
        schema.number("friction",
                      {.doc = "Coefficient mu; or \"stick\": bodies move as one wherever they share nodes",
                       .default_value = 0,
                       .at_least = 0,
                       .choices = {"stick"}});
        ContactLaw<S>::declare_pair(schema);
        return schema;
    }

    void impulses(std::span<const ContactPoint<S>> points, std::span<Vector> out) const override {
        for (std::size_t k = 0; k < points.size(); ++k)
            out[k] = sticks_ ? Vector(-points[k].mass * points[k].velocity) : impulse(points[k]);
    }

  private:
    Vector impulse(const ContactPoint<S>& at) const {
        if (!(at.pressing > 0)) return Vector::Zero();
        const Real most = friction_ * at.pressing, size = at.sticking.norm();
        const Vector across = size > most ? Vector(at.sticking * (most / size)) : at.sticking;
        return at.pressing * at.normal + across;
    }

    bool sticks_;
    Real friction_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("coulomb", "1.0.0") {
    registry.contact<matpoint::Coulomb>("coulomb");
}
