// The law of plain_rubber.cpp without Packs: loops over the particles of a batch, one after the other.
#include <matpoint/elasticity.hpp>
#include <matpoint/material.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>

using namespace matpoint;

template <class Space>
class ScalarRubber final : public Material<Space> {
  public:
    using Real = typename Space::Real;
    using Batch = ParticleBatch<Space>;

    static Schema schema() {
        Schema schema("Neo-Hookean solid, a loop over particles", "[Wallstedt & Guilkey 2008]");
        return add_elastic_constants(schema);
    }
    explicit ScalarRubber(const Parameters& parameters)
        : Material<Space>(parameters),
          lame_(parameters.number("youngs_modulus"), parameters.number("poissons_ratio")) {}

    bool uses_deformation_gradient() const override { return true; }

    void update_stress(const Batch& batch, Real) const override {
        const auto I = Tensor<Space>::identity();
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const auto F = batch.deformation_gradient(p);
            const Real J = determinant(F);
            batch.set_stress(p, lame_.lambda * std::log(J) / J * I + lame_.mu / J * (F * transpose(F) - I));
        }
    }
    Real wave_speed(const Batch& batch) const override {
        Real fastest = 0;
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const auto F = batch.deformation_gradient(p);
            const Real J = determinant(F);
            const Real volumetric = lame_.lambda * (1 - std::log(J)) + lame_.mu;
            const Real stiffness = std::max(Real(0), volumetric) + lame_.mu * largest_squared_stretch(F);
            fastest = std::max(fastest, stiffness / (J * batch.density(p)));
        }
        return std::sqrt(fastest);
    }

  private:
    Lame<Space> lame_;
};

MATPOINT_PLUGIN("scalar_rubber", "1.0.0") {
    registry.material<ScalarRubber>("scalar_rubber");
}
