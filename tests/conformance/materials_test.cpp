#include "material_conformance.hpp"

#include "config/validate.hpp"
#include "plugins.hpp"

#include <filesystem>

namespace matpoint::conformance {
namespace {

class EveryMaterial : public testing::TestWithParam<std::string> {};

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
    return {{"type", type}, {"density", 1}, {"youngs_modulus", e}, {"poissons_ratio", nu}};
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

TEST(LinearElastic, FollowsHookesLaw) {
    const auto material = make<Material<Solid>>("material", elastic("linear_elastic"));
    Specimen<Solid> stretched(*material), sheared(*material);
    stretched.step(component<Solid>(0, 0, 1e-3));
    EXPECT_NEAR(stretched.stress().plane(0, 0), (lambda + 2 * mu) * 1e-3, 1e-10);
    EXPECT_NEAR(stretched.stress().plane(1, 1), lambda * 1e-3, 1e-10);
    sheared.step(component<Solid>(0, 1, 1e-3));
    EXPECT_NEAR(sheared.stress().plane(0, 1), mu * 1e-3, 1e-10);

    const auto plane_strain = make<Material<PlaneStrain>>("material", elastic("linear_elastic"));
    Specimen<PlaneStrain> plane(*plane_strain);
    plane.step(component<PlaneStrain>(0, 0, 1e-3));
    EXPECT_NEAR(plane.stress().normal, lambda * 1e-3, 1e-10);
}

TEST(LinearElastic, BarIsUniaxial) {
    const auto material = make<Material<Bar>>("material", elastic("linear_elastic"));
    Specimen<Bar> bar(*material);
    EXPECT_NEAR(bar.wave_speed(), 100, 1e-12);
    bar.step(component<Bar>(0, 0, 1e-3));
    EXPECT_NEAR(bar.stress().plane(0, 0), e * 1e-3, 1e-12);
    EXPECT_TRUE(has_rule(schema_of("material", "linear_elastic"), false, "/poissons_ratio",
                         elastic("linear_elastic"), {{"space", {{"dimension", 1}}}}));
}

TEST(LinearElastic, SpinTurnsStressTheRightWay) {
    const auto material = make<Material<PlaneStrain>>("material", elastic("linear_elastic"));
    Specimen<PlaneStrain> s(*material);
    s.step(component<PlaneStrain>(0, 0, 1e-3));
    const auto before = s.stress();
    const double w = 1e-4;
    s.step(component<PlaneStrain>(1, 0, w) - component<PlaneStrain>(0, 1, w));
    EXPECT_NEAR(s.stress().plane(0, 1), w * (before.plane(0, 0) - before.plane(1, 1)), 1e-9);
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
        s.step(spin<PlaneStrain>(1.1), rotation<PlaneStrain>(1.1));
        EXPECT_NEAR(s.wave_speed(), speed, 1e-10 * speed);
    }
}

TEST(J2Plasticity, BarFollowsTheUniaxialLaw) {
    constexpr double yield = 10, tangent = e / 4, hardening = e * tangent / (e - tangent), step = 2e-4;
    const auto material = make<Material<Bar>>("material", plastic(yield, tangent));
    Specimen<Bar> bar(*material);
    double strain = 0;
    for (int i = 0; i < 50; ++i) {
        bar.step(component<Bar>(0, 0, step));
        strain += step;
        EXPECT_NEAR(bar.stress().plane(0, 0), std::min(e * strain, yield + tangent * (strain - yield / e)),
                    1e-10);
    }
    const double plastic_strain = strain - bar.stress().plane(0, 0) / e;
    EXPECT_NEAR(bar.state(0), plastic_strain, 1e-14);
    // The other way it yields at the same, hardened stress.
    const double hardened = yield + hardening * plastic_strain;
    bar.step(component<Bar>(0, 0, -2 * hardened / e));
    EXPECT_NEAR(bar.stress().plane(0, 0), -hardened, 1e-10);
    EXPECT_NEAR(bar.state(0), plastic_strain, 1e-14);
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
            Tensor<Solid> gradient;
            gradient.plane.diagonal() << step, lateral, lateral;
            trial.step(gradient);
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
                    1e-9);
    }
}

TEST(J2Plasticity, YieldDoesNotDependOnPressure) {
    const auto material = make<Material<Solid>>("material", plastic(10, 0));
    for (const double volumetric : {0.0, -0.05, 0.05}) {
        Specimen<Solid> s(*material);
        s.step(volumetric * Tensor<Solid>::identity());
        EXPECT_EQ(s.state(0), 0);
        for (int i = 0; i < 20; ++i) s.step(component<Solid>(0, 1, 5e-4) + component<Solid>(1, 0, 5e-4));
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

TEST(J2Plasticity, RefusesATangentSteeperThanTheElasticSlope) {
    const Schema schema = schema_of("material", "j2_plasticity");
    EXPECT_TRUE(has_rule(schema, true, "/tangent_modulus", plastic(1, e)));
    EXPECT_FALSE(has_rule(schema, true, "/tangent_modulus", plastic(1, 0.99 * e)));
}

}  // namespace
}  // namespace matpoint::conformance
