// Sheets whose thickness is free, against closed forms.
#include "material_conformance.hpp"

#include "every_plugin.hpp"
#include "run/plane_stress.hpp"
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace matpoint::conformance {
namespace {

constexpr double modulus = 70e9, poisson = 0.3, density = 2700, yield = 7e5;

Json elastic(const char* type) {
    Json own{{"type", type}, {"density", density}, {"youngs_modulus", modulus}, {"poissons_ratio", poisson}};
    if (type == std::string("linear_elastic")) own["strain"] = "rate";
    return own;
}
Json plastic(double tangent) {
    Json own = elastic("j2_plasticity");
    own["yield_stress"] = yield;
    own["tangent_modulus"] = tangent;
    return own;
}

template <class S>
std::shared_ptr<Material<S>> sheet_of(const Json& own) {
    PluginCatalogue catalogue;
    catalogue.find("material", own.at("type"));
    const Registry registry = with_plane_stress(catalogue.registry());
    const Parameters::Context context{SpaceId::of<S>(), ".", &registry, nullptr};
    return registry.make<Material<S>>("material", own, context);
}

/// A sheet, drawn along x; its thickness is the last of its variables.
template <class S>
struct Sheet {
    using Real = typename S::Real;
    std::shared_ptr<Material<S>> material;
    Specimen<S> specimen;
    double width = 1;  ///< stretch along y
    int states;

    explicit Sheet(const Json& own)
        : material(sheet_of<S>(own)),
          specimen(*material),
          states(static_cast<int>(material->state().size())) {}

    double stress(int a, int b) const { return static_cast<double>(specimen.stress().plane(a, b)); }
    double normal_stress() const { return static_cast<double>(specimen.stress().normal); }
    double thickness() const { return 1 + static_cast<double>(specimen.state(states - 1)); }

    Specimen<S> strained(double x, double y) const {
        Tensor<S> strain;
        strain.plane(0, 0) = static_cast<Real>(x);
        strain.plane(1, 1) = static_cast<Real>(y);
        Specimen<S> after = specimen;
        after.step(straining(strain));
        return after;
    }
    /// By `strain` in a step, with the width left free.
    void draw(double strain) {
        const auto sideways = [&](double y) {
            return static_cast<double>(strained(strain, y).stress().plane(1, 1));
        };
        double before = 0, y = -0.4 * strain, s_before = sideways(before), s = sideways(y);
        for (int k = 0; k < 40 && s != s_before && std::abs(y - before) > 1e-15; ++k) {
            const double next = y - s * (y - before) / (s - s_before);
            before = y, s_before = s;
            y = next, s = sideways(y);
        }
        specimen = strained(strain, y);
        width *= std::exp(y);
    }
};

TEST(PlaneStress, ElasticStripIsUniaxial) {
    for (const char* type : {"linear_elastic", "neo_hookean", "j2_plasticity"})
        for (const double strain : {1e-6, -1e-6}) {
            Sheet<PlaneStrain> strip(type == std::string("j2_plasticity") ? plastic(0) : elastic(type));
            for (int k = 0; k < 4; ++k) strip.draw(strain / 4);
            EXPECT_NEAR(strip.stress(0, 0) / (modulus * strain), 1, 5e-6) << type;
            EXPECT_NEAR((strip.thickness() - 1) / (-poisson * strain), 1, 5e-6) << type;
            EXPECT_NEAR((strip.width - 1) / (-poisson * strain), 1, 5e-6) << type;
            EXPECT_LT(std::abs(strip.normal_stress()), 1e-9 * modulus * std::abs(strain)) << type;
        }
}

TEST(PlaneStress, SinglePrecisionKeepsSmallStrains) {
    for (const char* type : {"linear_elastic", "neo_hookean"}) {
        Sheet<PlaneStrainSingle> sheet(elastic(type));
        Tensor<PlaneStrainSingle> strain;
        strain.plane(0, 0) = strain.plane(1, 1) = 1e-6f;
        sheet.specimen.step(strain);
        EXPECT_NEAR(sheet.stress(0, 0) / (modulus / (1 - poisson) * 1e-6), 1, 1e-5) << type;
        EXPECT_NEAR(sheet.specimen.state(0) / (-2 * poisson / (1 - poisson) * 1e-6), 1, 1e-5) << type;
    }
}

/// lambda ln J + mu (s^2 - 1) = 0 gives the stretch s of the sides, J = 1.5 s^2; then
/// sigma = (lambda ln J + mu (1.5^2 - 1)) / J.
TEST(PlaneStress, RubberStripAtHalfAsLongAgain) {
    const double lambda = modulus * poisson / ((1 + poisson) * (1 - 2 * poisson)),
                 mu = modulus / (2 * (1 + poisson));
    double low = 0.5, high = 1;
    for (int k = 0; k < 60; ++k) {
        const double s = (low + high) / 2;
        (lambda * std::log(1.5 * s * s) + mu * (s * s - 1) > 0 ? high : low) = s;
    }
    const double j = 1.5 * low * low, exact = (lambda * std::log(j) + mu * (1.5 * 1.5 - 1)) / j;
    for (const int steps : {1, 10}) {
        Sheet<PlaneStrain> strip(elastic("neo_hookean"));
        for (int k = 0; k < steps; ++k) strip.draw(std::log(1.5) / steps);
        EXPECT_NEAR(strip.stress(0, 0) / exact, 1, 1e-10);
        EXPECT_NEAR(strip.thickness(), low, 1e-10);
        EXPECT_NEAR(strip.width, low, 1e-10);
    }
}

/// Trials of the thickness leave no plastic strain behind.
TEST(PlaneStress, MetalStripYieldsAndHardens) {
    const double tangent = 0.1 * modulus, first = yield / modulus;
    Sheet<PlaneStrain> strip(plastic(tangent));
    for (int k = 1; k <= 60; ++k) {
        strip.draw(first / 20);
        const double strain = k * first / 20;
        const double exact = strain < first ? modulus * strain : yield + tangent * (strain - first);
        EXPECT_NEAR(strip.stress(0, 0) / yield, exact / yield, 2e-3) << strain / first;
        EXPECT_NEAR(static_cast<double>(strip.specimen.state(0)), strain - strip.stress(0, 0) / modulus,
                    2e-3 * first);
        EXPECT_LT(std::abs(strip.normal_stress()), 1e-8 * yield);
    }
}

TEST(PlaneStress, MetalSheetYieldsByVonMises) {
    const auto after = [](double x, double y, double xy) {
        Sheet<PlaneStrain> sheet(plastic(0));
        Tensor<PlaneStrain> gradient;
        gradient.plane(0, 0) = x, gradient.plane(1, 1) = y, gradient.plane(0, 1) = xy;
        for (int k = 0; k < 100; ++k) sheet.specimen.step((yield / modulus / 20) * gradient);
        return sheet;
    };
    EXPECT_NEAR(after(1, 1, 0).stress(0, 0) / yield, 1, 1e-4);
    EXPECT_NEAR(after(0, 0, 1).stress(0, 1) / yield, 1 / std::sqrt(3), 1e-4);
    // No strain sideways: in the end sigma_yy = sigma_xx / 2.
    const Sheet<PlaneStrain> wide = after(1, 0, 0);
    EXPECT_NEAR(wide.stress(0, 0) / yield, 2 / std::sqrt(3), 1e-3);
    EXPECT_NEAR(wide.stress(1, 1) / yield, 1 / std::sqrt(3), 0.05);
}

TEST(PlaneStress, WavesAreThoseOfASheet) {
    const double exact = std::sqrt(modulus / (density * (1 - poisson * poisson)));
    for (const char* type : {"linear_elastic", "neo_hookean"}) {
        EXPECT_NEAR(Sheet<PlaneStrain>(elastic(type)).specimen.wave_speed() / exact, 1, 1e-6) << type;
        EXPECT_NEAR(Sheet<PlaneStrainSingle>(elastic(type)).specimen.wave_speed() / exact, 1, 1e-3) << type;
    }
}

/// Turning, waves of stretched states, batches, numbers that are not finite.
TEST(PlaneStress, SheetsConformAsMaterials) {
    for (const char* type : {"linear_elastic", "neo_hookean"}) {
        SCOPED_TRACE(type);
        const auto check = [&]<class S>() {
            const auto material = sheet_of<S>(elastic(type));
            MaterialChecks<S> checks(*material);
            checks.zero_at_rest();
            checks.state_is_initialised();
            checks.rotation_turns_stress();
            checks.waves_are_not_faster();
            checks.survives_what_is_not_finite();
            checks.batches_are_independent();
        };
        check.template operator()<PlaneStrain>();
        check.template operator()<PlaneStrainSingle>();
    }
}

/// The stress is the derivative of the energy of a sheet, whose thickness gives none: dW = J sigma : D.
TEST(PlaneStress, StressIsTheDerivativeOfTheEnergy) {
    const double h = 1e-5;
    Sheet<PlaneStrain> sheet(elastic("neo_hookean"));
    std::mt19937 random(1);
    for (int k = 0; k < 10; ++k) {
        sheet.specimen.step(0.05 * random_tensor<PlaneStrain>(random));
        const Tensor<PlaneStrain> direction = random_tensor<PlaneStrain>(random);
        Specimen<PlaneStrain> plus = sheet.specimen, minus = sheet.specimen;
        plus.step(h * direction);
        minus.step(-h * direction);
        const double slope = (*plus.stored_energy() - *minus.stored_energy()) / (2 * h);
        const double volume = determinant(sheet.specimen.deformation()) * sheet.thickness();
        EXPECT_NEAR(slope / modulus, volume * contract(sheet.specimen.stress(), direction) / modulus, 1e-8);
    }
}

Json scene(const Json& material) {
    Json json = busy_scene();
    json["space"]["mode"] = "plane_stress";
    json["materials"]["rubber"] = material;
    return json;
}

TEST(PlaneStress, VolumeGrowsWithTheThickness) {
    Simulated run(scene(
        {{"type", "neo_hookean"}, {"density", 1000}, {"youngs_modulus", 1e5}, {"poissons_ratio", 0.3}}));
    const auto before = run->column("square", "volume", 0);
    run.advance(40);
    const auto after = run->column("square", "volume", 0),
               thickness = run->column("square", "thickness_strain", 0);
    double largest = 0;
    for (std::size_t p = 0; p < after.size(); ++p) {
        const auto f = [&](int c) {
            return (c % 3 == 0) + run->column("square", "displacement_gradient", c)[p];
        };
        const double area = f(0) * f(3) - f(1) * f(2);
        ASSERT_NEAR(after[p] / before[p], area * (1 + thickness[p]), 1e-12);
        largest = std::max(largest, std::abs(thickness[p]));
        if (p > 40) break;
    }
    EXPECT_GT(largest, 1e-4);
}

std::string told(const Json& json) {
    try {
        Simulated run(json);
    } catch (const std::exception& wrong) {
        return wrong.what();
    }
    return "";
}

TEST(PlaneStress, WhatCarriesNothingIsRefused) {
    const std::string dust = told(scene({{"type", "linear_elastic"}, {"density", 1}, {"youngs_modulus", 0}}));
    EXPECT_NE(dust.find("/materials/rubber: can't be in plane stress"), std::string::npos) << dust;
    Json exact = scene(elastic("neo_hookean"));
    exact["exact_solution"] = {{"type", "free_flight"}, {"body", "square"}, {"velocity", {1, 0}}};
    EXPECT_NE(told(exact).find("/exact_solution: there is none for plane stress"), std::string::npos)
        << told(exact);
}

}  // namespace
}  // namespace matpoint::conformance
