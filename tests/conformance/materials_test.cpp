#include "material_conformance.hpp"

#include "config/validate.hpp"
#include "plugins.hpp"

#include <filesystem>

namespace matpoint::conformance {
namespace {

class EveryMaterial : public testing::TestWithParam<std::string> {};

template <class S>
class InSinglePrecision : public testing::Test {};
using SinglePrecision = testing::Types<BarSingle, PlaneStrainSingle, AxisymmetricSingle, SolidSingle>;
TYPED_TEST_SUITE(InSinglePrecision, SinglePrecision);

/// With the parameters of the plugin's example.
TEST_P(EveryMaterial, Conforms) {
    const auto example = std::filesystem::path(PLUGIN_SOURCES) / "material" / GetParam() / "example.json";
    PluginCatalogue catalogue;
    const Document scene = read_document(example);
    Diagnostics mistakes;
    Validator validator(scene, catalogue, 3, mistakes);
    int checked = 0;
    for (const auto& [name, own] : scene.json.at("materials").items()) {
        if (own.at("type") != GetParam()) continue;
        const Json resolved = validator.component("material", own, "/materials/" + name);
        ASSERT_FALSE(mistakes.has_errors()) << mistakes.text();
        check_material(catalogue.registry(), resolved);
        ++checked;
    }
    EXPECT_GT(checked, 0) << example << " has no " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Plugins, EveryMaterial, testing::ValuesIn(PluginCatalogue().types("material")),
                         [](const auto& type) { return type.param; });

constexpr double e = 1e4, nu = 0.3, lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));

Json elastic(const char* type) {
    Json own = {{"type", type}, {"density", 1}, {"youngs_modulus", e}, {"poissons_ratio", nu}};
    if (own.at("type") == "linear_elastic") own["strain"] = "rate";
    return own;
}
Json small_strain() {
    Json own = elastic("linear_elastic");
    own["strain"] = "small";
    return own;
}
Json plastic(double yield_stress, double tangent_modulus) {
    Json own = elastic("j2_plasticity");
    own["yield_stress"] = yield_stress;
    own["tangent_modulus"] = tangent_modulus;
    return own;
}

template <class S>
Tensor<S> component(int row, int column, double value) {
    Tensor<S> t;
    t.plane(row, column) = static_cast<typename S::Real>(value);
    return t;
}

/// A step of logarithmic strain counts as 2 tanh(strain / 2) in rate form, less by at most this.
constexpr double missed(double strain) {
    return strain * strain * strain / 12;
}

TEST(LinearElastic, FollowsHookesLaw) {
    constexpr double strain = 1e-3;
    const auto material = make<Material<Solid>>("material", elastic("linear_elastic"));
    Specimen<Solid> stretched(*material), sheared(*material);
    stretched.step(straining(component<Solid>(0, 0, strain)));
    EXPECT_NEAR(stretched.stress().plane(0, 0), (lambda + 2 * mu) * strain,
                (lambda + 2 * mu) * missed(strain));
    EXPECT_NEAR(stretched.stress().plane(1, 1), lambda * strain, lambda * missed(strain));
    sheared.step(straining(component<Solid>(0, 1, strain) + component<Solid>(1, 0, strain)));
    EXPECT_NEAR(sheared.stress().plane(0, 1), 2 * mu * strain, 2 * mu * missed(strain));
    EXPECT_NEAR(sheared.stress().plane(0, 0), 0, 1e-12);

    const auto plane_strain = make<Material<PlaneStrain>>("material", elastic("linear_elastic"));
    Specimen<PlaneStrain> plane(*plane_strain);
    plane.step(straining(component<PlaneStrain>(0, 0, strain)));
    EXPECT_NEAR(plane.stress().normal, lambda * strain, lambda * missed(strain));
}

TEST(LinearElastic, BarIsUniaxial) {
    constexpr double strain = 1e-3;
    const auto material = make<Material<Bar>>("material", elastic("linear_elastic"));
    Specimen<Bar> bar(*material);
    EXPECT_NEAR(bar.wave_speed(), 100, 1e-12);
    bar.step(component<Bar>(0, 0, strain));
    EXPECT_NEAR(bar.stress().plane(0, 0), e * std::log(1 + strain), e * missed(strain));
    EXPECT_TRUE(has_rule(schema_of("material", "linear_elastic"), false, "/poissons_ratio",
                         elastic("linear_elastic"), {{"space", {{"dimension", 1}}}}));
}

/// The Jaumann rate's own solution, of which each step is right to the third order.
TEST(LinearElastic, SimpleShearIsOfSecondOrder) {
    const auto material = make<Material<PlaneStrain>>("material", elastic("linear_elastic"));
    const auto error = [&](int steps) {
        constexpr double shear = 1;
        Specimen<PlaneStrain> s(*material);
        for (int k = 0; k < steps; ++k) s.step(component<PlaneStrain>(0, 1, shear / steps));
        Eigen::Matrix2d exact;
        exact << 1 - std::cos(shear), std::sin(shear), std::sin(shear), std::cos(shear) - 1;
        return (s.stress().plane / mu - exact).norm();
    };
    EXPECT_LT(error(20), 1e-3);
    EXPECT_NEAR(error(20) / error(40), 4, 0.1);
}

template <class S>
class RateForm : public testing::Test {
  protected:
    Specimen<S> stressed() {
        Specimen<S> s(*material_);
        s.step(0.1 * random_tensor<S>(random_));
        return s;
    }
    static double norm(const Tensor<S>& t) { return std::sqrt(contract(t, t)); }

    std::mt19937 random_{5};

  private:
    std::shared_ptr<Material<S>> material_ = make<Material<S>>("material", elastic("linear_elastic"));
};
using Spaces = testing::Types<Bar, PlaneStrain, Axisymmetric, Solid>;
TYPED_TEST_SUITE(RateForm, Spaces);

TYPED_TEST(RateForm, TurnsExactlyHoweverFar) {
    for (const double angle : {1e-3, 0.3, -1.5, 3.0}) {
        Specimen<TypeParam> s = this->stressed();
        const auto stress = s.stress(), r = rotation<TypeParam>(angle);
        s.step(turn<TypeParam>(angle));
        EXPECT_LT(this->norm(s.stress() - r * stress * transpose(r)), 1e-12 * e) << angle;
    }
}

/// Whatever is strained and turned on the way, and however large the steps.
TYPED_TEST(RateForm, StepsTakenBackRestoreTheStress) {
    Specimen<TypeParam> s = this->stressed();
    const auto stress = s.stress(), identity = Tensor<TypeParam>::identity();
    std::vector<Tensor<TypeParam>> taken;
    for (int k = 0; k < 5; ++k) {
        taken.push_back(0.3 * random_tensor<TypeParam>(this->random_));
        s.step(taken.back());
    }
    ASSERT_GT(this->norm(s.stress() - stress), 1e-3 * e);
    for (; !taken.empty(); taken.pop_back()) {
        Tensor<TypeParam> back = identity + taken.back();
        back.plane = back.plane.inverse().eval();
        if constexpr (TypeParam::has_normal) back.normal = 1 / back.normal;
        s.step(back - identity);
    }
    EXPECT_LT(this->norm(s.stress() - stress), 1e-12 * e);
}

TEST(LinearElastic, SmallStrainConforms) {
    PluginCatalogue catalogue;
    ASSERT_NE(catalogue.find("material", "linear_elastic"), nullptr);
    check_material(catalogue.registry(), small_strain(), MaterialLaw::small_strain);
}

TEST(LinearElastic, SmallStrainIsThatOfTheDisplacementGradient) {
    const auto material = make<Material<Solid>>("material", small_strain());
    Specimen<Solid> s(*material);
    s.step(component<Solid>(0, 0, 0.2));
    s.step(component<Solid>(0, 1, 0.1) + component<Solid>(2, 2, -0.5));
    const double volumetric = 0.2 - 0.5;  // F = [[1.2, 0.1, 0], [0, 1, 0], [0, 0, 0.5]]
    EXPECT_NEAR(s.stress().plane(0, 0), lambda * volumetric + 2 * mu * 0.2, 1e-9);
    EXPECT_NEAR(s.stress().plane(1, 1), lambda * volumetric, 1e-9);
    EXPECT_NEAR(s.stress().plane(2, 2), lambda * volumetric - 2 * mu * 0.5, 1e-9);
    EXPECT_NEAR(s.stress().plane(0, 1), mu * 0.1, 1e-9);

    const auto axisymmetric = make<Material<Axisymmetric>>("material", small_strain());
    Specimen<Axisymmetric> ring(*axisymmetric);
    Tensor<Axisymmetric> hoop;
    hoop.normal = 0.2;
    ring.step(hoop);
    EXPECT_NEAR(ring.stress().normal, (lambda + 2 * mu) * 0.2, 1e-9);
}

/// However large the strain: sigma = E (F - 1), and since the area stays, waves in X run with sqrt(E / rho_0)
/// and those in x with F times that.
TEST(LinearElastic, SmallStrainBarHasALinearWaveEquation) {
    const auto material = make<Material<Bar>>("material", small_strain());
    for (const double f : {0.5, 0.9, 1.3, 2.0}) {
        Specimen<Bar> bar(*material);
        bar.step(component<Bar>(0, 0, f - 1));
        EXPECT_NEAR(bar.stress().plane(0, 0), e * (f - 1), 1e-9);
        EXPECT_NEAR(*bar.stored_energy(), e / 2 * (f - 1) * (f - 1), 1e-9);
        EXPECT_NEAR(bar.wave_speed(), f * 100, 1e-9);
    }
}

TEST(NeoHookean, FollowsTheFormula) {
    const auto material = make<Material<PlaneStrain>>("material", elastic("neo_hookean"));
    for (const double f : {0.5, 0.9, 1.3, 2.0}) {
        Specimen<PlaneStrain> s(*material);
        s.step(component<PlaneStrain>(0, 0, f - 1));
        EXPECT_NEAR(s.stress().plane(0, 0), lambda * std::log(f) / f + mu / f * (f * f - 1), 1e-8);
        EXPECT_NEAR(s.stress().plane(1, 1), lambda * std::log(f) / f, 1e-8);
        EXPECT_NEAR(s.stress().normal, lambda * std::log(f) / f, 1e-8);
    }
}

/// [Wallstedt & Guilkey 2008, eq. 28], and the wave speed that follows from it.
TEST(NeoHookean, BarIsUniaxial) {
    const auto material = make<Material<Bar>>("material", elastic("neo_hookean"));
    for (const double f : {0.5, 0.9, 1.3, 2.0}) {
        Specimen<Bar> bar(*material);
        bar.step(component<Bar>(0, 0, f - 1));
        EXPECT_NEAR(bar.stress().plane(0, 0), e / 2 * (f - 1 / f), 1e-8);
        EXPECT_NEAR(*bar.stored_energy(), e / 4 * (f * f - 1) - e / 2 * std::log(f), 1e-8);
        EXPECT_NEAR(bar.wave_speed(), std::sqrt(e / 2 * (f * f + 1)), 1e-8);
    }
}

/// In the plane the estimate is the fastest wave itself, whichever way the body has turned.
TEST(NeoHookean, WaveSpeedIsExactInThePlane) {
    const auto material = make<Material<PlaneStrain>>("material", elastic("neo_hookean"));
    for (const double stretch : {0.6, 1.0, 1.7}) {
        Specimen<PlaneStrain> s(*material);
        s.step(component<PlaneStrain>(0, 0, stretch - 1));
        s.step(component<PlaneStrain>(0, 1, 0.2));
        const double speed = s.wave_speed();
        double stiffest = 0;
        for (double angle = 0; angle < 3.15; angle += 0.005) {
            const Eigen::Vector2d n(std::cos(angle), std::sin(angle));
            stiffest = std::max(stiffest, MaterialChecks<PlaneStrain>::stiffness(s, n, n));
        }
        EXPECT_NEAR(s.density() * speed * speed / stiffest, 1, 1e-4);
        s.step(turn<PlaneStrain>(1.1));
        EXPECT_NEAR(s.wave_speed(), speed, 1e-10 * speed);
    }
}

TEST(J2Plasticity, BarFollowsTheUniaxialLaw) {
    constexpr double yield = 10, tangent = e / 4, hardening = e * tangent / (e - tangent), step = 2e-4;
    const auto material = make<Material<Bar>>("material", plastic(yield, tangent));
    Specimen<Bar> bar(*material);
    double strain = 0;
    for (int i = 0; i < 50; ++i) {
        bar.step(straining(component<Bar>(0, 0, step)));
        strain += step;
        EXPECT_NEAR(bar.stress().plane(0, 0), std::min(e * strain, yield + tangent * (strain - yield / e)),
                    e * 50 * missed(step));
    }
    const double plastic_strain = bar.state(0);
    EXPECT_NEAR(plastic_strain, strain - bar.stress().plane(0, 0) / e, 50 * missed(step) + 1e-14);
    // The other way it yields at the same, hardened stress: not before, and beyond with the tangent's slope.
    const double hardened = yield + hardening * plastic_strain, back = 2 * hardened / e;
    bar.step(straining(component<Bar>(0, 0, -0.999 * back)));
    EXPECT_NEAR(bar.stress().plane(0, 0), -0.998 * hardened, e * missed(back));
    EXPECT_EQ(bar.state(0), plastic_strain);
    bar.step(straining(component<Bar>(0, 0, -0.001 * back - step)));
    EXPECT_NEAR(bar.stress().plane(0, 0), -hardened - tangent * step, e * missed(back));
}

/// Sides are strained so that their stress stays zero, as in a tensile test.
TEST(J2Plasticity, TensileTestHasTheTangentModulus) {
    constexpr double yield = 10, tangent = e / 10, step = 5e-5;
    const auto material = make<Material<Solid>>("material", plastic(yield, tangent));
    Specimen<Solid> s(*material);
    double strain = 0;
    for (int i = 0; i < 60; ++i) {
        const auto strained = [&](double lateral) {
            Specimen<Solid> trial = s;
            Tensor<Solid> increment;
            increment.plane.diagonal() << step, lateral, lateral;
            trial.step(straining(increment));
            return trial;
        };
        double low = -step, high = step;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (strained(middle).stress().plane(1, 1) < 0 ? low : high) = middle;
        }
        s = strained(low);
        strain += step;
        EXPECT_NEAR(s.stress().plane(0, 0), std::min(e * strain, yield + tangent * (strain - yield / e)),
                    e * 60 * missed(step));
    }
}

TEST(J2Plasticity, YieldDoesNotDependOnPressure) {
    const auto material = make<Material<Solid>>("material", plastic(10, 0));
    for (const double volumetric : {0.0, -0.05, 0.05}) {
        Specimen<Solid> s(*material);
        s.step(volumetric * Tensor<Solid>::identity());
        EXPECT_EQ(s.state(0), 0);
        const auto shear = straining(component<Solid>(0, 1, 5e-4) + component<Solid>(1, 0, 5e-4));
        for (int i = 0; i < 20; ++i) s.step(shear);
        EXPECT_NEAR(s.stress().plane(0, 1), 10 / std::sqrt(3.0), 1e-10);
        EXPECT_GT(s.state(0), 0);
    }
}

TEST(J2Plasticity, WorksWithNoYieldStressAndWithAHugeOne) {
    const auto soft = make<Material<SolidSingle>>("material", plastic(0, 0));
    const auto hard = make<Material<SolidSingle>>("material", plastic(1e30, 0));
    const auto elastic_solid = make<Material<SolidSingle>>("material", elastic("linear_elastic"));
    Specimen<SolidSingle> yielding(*soft), rigid(*hard), reference(*elastic_solid);
    std::mt19937 random{3};
    for (int i = 0; i < 10; ++i) {
        const auto gradient = 0.01f * random_tensor<SolidSingle>(random);
        for (auto* s : {&yielding, &rigid, &reference}) s->step(gradient);
    }
    const auto stress = yielding.stress();
    EXPECT_NEAR(stress.plane(0, 1), 0, 1e-3);
    EXPECT_NEAR(stress.plane(0, 0), trace(stress) / 3, 1e-3);
    EXPECT_NEAR((rigid.stress() - reference.stress()).plane.norm(), 0, 1e-3);
    EXPECT_EQ(rigid.state(0), 0);
}

/// Stress and energy of the same displacement gradients in single and in double precision, relative to what
/// they are at most, however small the strains are.
template <class S>
void expect_digits_of_small_strains(const Json& own) {
    using Wide = Space<S::dimension, S::mode, double>;
    const auto material = make<Material<S>>("material", own);
    const auto reference = make<Material<Wide>>("material", own);
    std::mt19937 random{5};
    for (double size = 1e-10; size < 1e-2; size *= 10) {
        Specimen<S> s(*material);
        Specimen<Wide> exact(*reference);
        for (int k = 0; k < 4; ++k) {
            const Tensor<S> gradient = static_cast<float>(size) * random_tensor<S>(random);
            Tensor<Wide> wide;
            wide.plane = gradient.plane.template cast<double>();
            if constexpr (S::has_normal) wide.normal = gradient.normal;
            s.step(gradient);
            exact.step(wide);
        }
        const typename Wide::Matrix off = s.stress().plane.template cast<double>() - exact.stress().plane;
        EXPECT_LE(off.norm(), 1e-5 * exact.stress().plane.norm()) << own.at("type") << ", strain " << size;
        if (const auto energy = s.stored_energy()) {
            EXPECT_NEAR(*energy, *exact.stored_energy(), 1e-5 * *energy)
                << own.at("type") << ", strain " << size;
        }
    }
}

TYPED_TEST(InSinglePrecision, SmallStrainsKeepTheirDigits) {
    for (const Json& own :
         {elastic("neo_hookean"), elastic("linear_elastic"), small_strain(), plastic(1e10, 0)})
        expect_digits_of_small_strains<TypeParam>(own);
}

TEST(J2Plasticity, RefusesATangentSteeperThanTheElasticSlope) {
    const Schema schema = schema_of("material", "j2_plasticity");
    EXPECT_TRUE(has_rule(schema, true, "/tangent_modulus", plastic(1, e)));
    EXPECT_FALSE(has_rule(schema, true, "/tangent_modulus", plastic(1, 0.99 * e)));
}

}  // namespace
}  // namespace matpoint::conformance
