// The same scene in other units of length, time and mass.
#include "simulated.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace matpoint::conformance {
namespace {

/// What one unit of the first scene is in those of the second.
struct Units {
    double length, time, mass;
    double velocity() const { return length / time; }
    double stress() const { return mass / (length * time * time); }
};

constexpr Units nanometres{1e-9, 1e-12, 1e-27}, kilometres{1e3, 3.15576e7, 1e12};
constexpr Units small_powers{0x1p-30, 0x1p-40, 0x1p-90}, large_powers{0x1p10, 0x1p25, 0x1p40};
constexpr long steps = 200;

/// busy_scene() in other units.
Json rescaled(Json scene, const Units& u) {
    const auto scale = [&](const char* pointer, double factor) {
        for (Json& number : scene.at(Json::json_pointer(pointer))) number = number.get<double>() * factor;
    };
    scale("/grid/min", u.length);
    scale("/grid/max", u.length);
    scale("/bodies/square/geometry/min", u.length);
    scale("/bodies/square/geometry/max", u.length);
    scale("/loads/0/acceleration", u.velocity() / u.time);
    scene["grid"]["cell_size"] = scene["grid"]["cell_size"].get<double>() * u.length;
    scene["time"]["end"] = scene["time"]["end"].get<double>() * u.time;
    for (auto& [name, value] : scene["materials"]["rubber"].items()) {
        if (name == "density") value = value.get<double>() * u.mass / std::pow(u.length, 3);
        if (name == "youngs_modulus" || name == "yield_stress") value = value.get<double>() * u.stress();
    }
    scene["bodies"]["square"]["velocity"] = {fmt::format("{}*(1 - 3*(y/{}-0.6))", u.velocity(), u.length),
                                             fmt::format("{}*(0.5 + 3*(x/{}-0.7))", u.velocity(), u.length)};
    return scene;
}

/// Largest deviation of a field of two runs, in the units of the first, over the field's largest value.
double deviation(const Simulated& a, const Simulated& b, const std::string& field, double factor) {
    double difference = 0, largest = 0;
    for (int c = 0; c < a.simulation->components("square", field); ++c) {
        const auto expected = a.simulation->column("square", field, c);
        const auto found = b.simulation->column("square", field, c);
        for (std::size_t p = 0; p < expected.size(); ++p) {
            const double off = std::abs(found[p] / factor - expected[p]);
            difference = std::isfinite(off) ? std::max(difference, off) : INFINITY;
            largest = std::max(largest, std::abs(expected[p]));
        }
    }
    EXPECT_GT(largest, 0);
    return difference / largest;
}

class EveryMaterial : public testing::TestWithParam<Json> {
  protected:
    /// Largest relative deviation of position, velocity and stress.
    static double deviation_in(const Units& units, const std::string& precision) {
        Json scene = busy_scene();
        scene["space"]["precision"] = precision;
        scene["materials"]["rubber"] = GetParam();
        Simulated given(rescaled(scene, {1, 1, 1})), other(rescaled(scene, units));
        given.advance(steps);
        other.advance(steps);
        return std::max({deviation(given, other, "position", units.length),
                         deviation(given, other, "velocity", units.velocity()),
                         deviation(given, other, "stress", units.stress())});
    }
};

TEST_P(EveryMaterial, PowersOfTwoChangeNoBit) {
    for (const Units& units : {small_powers, large_powers})
        for (const char* precision : {"double", "single"})
            EXPECT_EQ(deviation_in(units, precision), 0) << precision << ", length " << units.length;
}

TEST_P(EveryMaterial, NanometresAndYearsChangeRoundingOnly) {
    for (const Units& units : {nanometres, kilometres}) {
        EXPECT_LT(deviation_in(units, "double"), 1e-10) << "length " << units.length;
        EXPECT_LT(deviation_in(units, "single"), 1e-4) << "length " << units.length;
    }
}

/// busy_scene() away from the origin along both axes.
Json moved(double distance) {
    Json scene = busy_scene();
    for (const char* pointer :
         {"/grid/min", "/grid/max", "/bodies/square/geometry/min", "/bodies/square/geometry/max"})
        for (Json& number : scene.at(Json::json_pointer(pointer))) number = number.get<double>() + distance;
    scene["bodies"]["square"]["velocity"] = {fmt::format("1 - 3*(y-{}-0.6)", distance),
                                             fmt::format("0.5 + 3*(x-{}-0.7)", distance)};
    return scene;
}

class EveryShape : public testing::TestWithParam<Json> {};

/// In single precision a place is told from a node of its block, and what is rounded away is kept: 1e5 cells
/// from the origin is as good as there.
TEST_P(EveryShape, FarFromTheOriginIsNoFurtherInSinglePrecision) {
    Json here = moved(0), away = moved(1e4);
    for (Json* scene : {&here, &away}) {
        (*scene)["shape_function"] = GetParam();
        // Close to a node, moments of linear functions are next to nothing, and so is what is divided by
        // them.
        if (GetParam().at("type") == "linear") (*scene)["transfer"] = {{"type", "flip"}};
    }
    away["space"]["precision"] = "single";
    Simulated exact(here), single(away);
    exact.advance(steps);
    single.advance(steps);
    EXPECT_LT(deviation(exact, single, "velocity", 1), 1e-4);
    EXPECT_LT(deviation(exact, single, "stress", 1), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(FarFromTheOrigin, EveryShape,
                         testing::Values(Json{{"type", "linear"}}, Json{{"type", "gimp"}},
                                         Json{{"type", "bspline"}, {"order", 2}},
                                         Json{{"type", "bspline"}, {"order", 3}}),
                         [](const auto& shape) {
                             return shape.param.at("type").template get<std::string>() +
                                    (shape.param.contains("order") ? shape.param.at("order").dump() : "");
                         });

/// Positions are kept from the origin, so their rounding is that of the distance: in double precision 1e6 m
/// away 1e-10 m, a billionth of a cell. What that does to velocity and stress:
TEST(FarFromTheOrigin, CostsTheDigitsOfTheDistance) {
    Simulated here(moved(0)), away(moved(1e6));
    here.advance(steps);
    away.advance(steps);
    EXPECT_LT(deviation(here, away, "velocity", 1), 1e-7);
    EXPECT_LT(deviation(here, away, "stress", 1), 1e-7);
    EXPECT_GT(deviation(here, away, "stress", 1), 1e-14);  // it is another place
}

INSTANTIATE_TEST_SUITE_P(
    Units, EveryMaterial,
    testing::Values(
        Json{{"type", "neo_hookean"}, {"density", 1000}, {"youngs_modulus", 1e5}, {"poissons_ratio", 0.3}},
        Json{{"type", "linear_elastic"}, {"density", 1000}, {"youngs_modulus", 1e5}, {"poissons_ratio", 0.3}},
        Json{{"type", "j2_plasticity"},
             {"density", 1000},
             {"youngs_modulus", 1e5},
             {"poissons_ratio", 0.3},
             {"yield_stress", 2e3}}),
    [](const auto& material) { return material.param.at("type").template get<std::string>(); });

}  // namespace
}  // namespace matpoint::conformance
