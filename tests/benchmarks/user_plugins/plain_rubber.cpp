// The law of the built-in `neo_hookean` as one writes it down: plain arithmetic on one particle.
#include <matpoint/elasticity.hpp>
#include <matpoint/plugin.hpp>
#include <matpoint/pointwise_material.hpp>

using namespace matpoint;

template <class Space>
class PlainRubber final : public PointwiseMaterial<Space, PlainRubber<Space>> {
  public:
    using Real = typename Space::Real;

    static Schema schema() {
        Schema schema("Neo-Hookean solid, a plain function of one particle", "[Wallstedt & Guilkey 2008]");
        return add_elastic_constants(schema);
    }
    explicit PlainRubber(const Parameters& parameters)
        : PointwiseMaterial<Space, PlainRubber<Space>>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")) {}

    bool uses_deformation_gradient() const override { return true; }

    template <class Point>
    auto update(const Point& p, Real) const {
        const auto F = p.deformation_gradient();
        const auto I = Tensor<Space, typename Point::Number>::identity();
        const auto J = determinant(F);
        const auto speed = squared_wave_speed(p);
        p.set_stress(lame_.lambda * log(J) / J * I + lame_.mu / J * (F * transpose(F) - I));
        return speed;
    }

    template <class Point>
    auto squared_wave_speed(const Point& p) const {
        const auto F = p.deformation_gradient();
        const auto J = determinant(F);
        const auto volumetric = lame_.lambda * (1 - log(J)) + lame_.mu;
        const auto stiffness = max(0, volumetric) + lame_.mu * largest_squared_stretch(F);
        return stiffness / (J * p.density());
    }

  private:
    Lame<Space> lame_;
};

MATPOINT_PLUGIN("plain_rubber", "1.0.0") {
    registry.material<PlainRubber>("plain_rubber");
}
