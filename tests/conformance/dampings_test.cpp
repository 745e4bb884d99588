#include "damping_conformance.hpp"

#include "every_plugin.hpp"
#include "plugins.hpp"
#include "simulated.hpp"

namespace matpoint::conformance {
namespace {

class EveryDamping : public testing::TestWithParam<Json> {};

TEST_P(EveryDamping, Conforms) {
    PluginCatalogue catalogue;
    const std::string type = GetParam().at("type");
    catalogue.find("damping", type);
    Json own = GetParam();
    if (type == "viscous") own["rate"] = 10.0;
    check_damping(catalogue.registry(), own);
}

INSTANTIATE_TEST_SUITE_P(Plugins, EveryDamping, testing::ValuesIn(every_plugin("damping")),
                         [](const auto& own) { return own.param.at("type").template get<std::string>(); });

TEST(Damping, ViscousIsExactOverAStep) {
    const auto viscous = make<Damping<Bar>>("damping", {{"type", "viscous"}, {"rate", 3.0}});
    const std::vector<double> v = {2, -5}, a = {0, 0};
    std::vector<double> slowed(2);
    viscous->resist(v, a, 0.7, slowed);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(v[i] + 0.7 * slowed[i], v[i] * std::exp(-2.1), 1e-12);
}

/// A square that falls, spins and is tied by a wall: what the damping took is in the balances.
void keeps_balances(const Json& damping) {
    Json scene = busy_scene();
    scene["damping"] = damping;
    scene.erase("outputs");
    Simulated run(scene);
    const double before = run->energies().total();
    run.advance(150);
    SCOPED_TRACE(damping.dump());
    const Energies e = run->energies();
    EXPECT_GT(e.damped, 0.2 * before);
    EXPECT_NEAR(e.total(), before, 0.02 * before);
    EXPECT_LT(run->conservation().momentum_drift, 1e-11);
}

TEST(Damping, IsCountedInEnergyAndMomentum) {
    keeps_balances({{"type", "local"}});
    keeps_balances({{"type", "viscous"}, {"rate", 5.0}});
    keeps_balances({{"type", "kinetic"}});
}

/// A mass on a spring, seen as a bar of one cell, keeps exp(-c t) of its energy.
TEST(Damping, ViscousTakesItsShareOfAVibration) {
    Json scene = Json::parse(R"json({
        "matpoint": 1, "space": {"dimension": 1},
        "grid": {"type": "uniform", "min": [0], "max": [1], "cell_size": 0.05},
        "time": {"end": 100, "cfl": 0.1},
        "materials": {"m": {"type": "linear_elastic", "density": 1, "youngs_modulus": 1, "strain": "small"}},
        "bodies": {"bar": {"material": "m", "particles_per_cell": 4, "velocity": ["1e-3*sin(pi*x)"],
                           "geometry": {"type": "box", "min": [0], "max": [1]}}},
        "boundary_conditions": [{"type": "fixed", "on": ["x_min", "x_max"]}],
        "damping": {"type": "viscous", "rate": 0.2}
    })json");
    Simulated run(scene);
    const double before = run->energies().kinetic;
    while (run->time() < 10) run.advance(1);  // five periods
    EXPECT_NEAR(run->energies().kinetic + run->energies().strain, before * std::exp(-0.2 * run->time()),
                0.03 * before * std::exp(-0.2 * run->time()));
}

/// A bar, fixed at one end, that is pulled at the other.
Json pulled_bar(const Json& history) {
    Json scene = Json::parse(R"json({
        "matpoint": 1, "space": {"dimension": 1},
        "grid": {"type": "uniform", "min": [0], "max": [1.5], "cell_size": 0.05},
        "time": {"end": 20, "until_at_rest": 1e-3},
        "materials": {"m": {"type": "linear_elastic", "density": 1, "youngs_modulus": 1, "strain": "small"}},
        "bodies": {"bar": {"material": "m", "geometry": {"type": "box", "min": [0], "max": [1]}}},
        "loads": [{"type": "traction", "body": "bar", "face": "x_max", "traction": [1e-3]}],
        "boundary_conditions": [{"type": "fixed", "on": "x_min"}],
        "damping": {"type": "kinetic"}
    })json");
    scene["loads"][0]["history"] = history;
    return scene;
}

/// Energy of strain, whose right value is 5e-7 of the load's square, when the run has ended at rest.
double strain_energy_at_rest(Simulated& run) {
    while (!run->finished()) run.advance(1);
    EXPECT_EQ(run->at_rest(), true);
    return run->energies().strain;
}

TEST(Rest, WaitsForEveryChangeOfALoad) {
    Simulated at_once(pulled_bar({{"type", "step"}}));
    EXPECT_NEAR(strain_energy_at_rest(at_once), 5e-7, 5e-9);
    EXPECT_LT(at_once->time(), 5);
    Simulated late(pulled_bar({{"type", "step"}, {"start", 8}}));
    EXPECT_NEAR(strain_energy_at_rest(late), 5e-7, 5e-9);
    EXPECT_GT(late->time(), 8);
    Simulated table(pulled_bar({{"type", "table"}, {"times", {0, 8, 8.001}}, {"values", {1, 1, 2}}}));
    EXPECT_NEAR(strain_energy_at_rest(table), 20e-7, 20e-9);
    Simulated ramp(pulled_bar({{"type", "ramp"}, {"duration", 6}}));
    EXPECT_NEAR(strain_energy_at_rest(ramp), 5e-7, 5e-9);
    Simulated pulse(pulled_bar({{"type", "pulse"}, {"duration", 8}}));
    EXPECT_NEAR(strain_energy_at_rest(pulse), 0, 5e-9);
    EXPECT_GT(pulse->time(), 8);
}

TEST(Rest, ARestartOfAnotherSceneIsNotAtRestYet) {
    Simulated first(pulled_bar({{"type", "step"}}));
    strain_energy_at_rest(first);
    Json doubled = pulled_bar({{"type", "step"}});
    doubled["loads"][0]["traction"] = {2e-3};
    Simulated second(doubled);
    second->restore(first->state());
    EXPECT_FALSE(second->finished());
    EXPECT_NEAR(strain_energy_at_rest(second), 20e-7, 20e-9);
    Simulated same(pulled_bar({{"type", "step"}}));
    same->restore(first->state());
    EXPECT_TRUE(same->finished());
}

TEST(Rest, WhatLeavesTheGridIsNoPeakOfTheEnergy) {
    Json scene = Json::parse(R"json({
        "matpoint": 1, "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [1, 1], "cell_size": 0.1},
        "time": {"end": 0.2},
        "materials": {"m": {"type": "linear_elastic", "density": 1, "youngs_modulus": 10}},
        "bodies": {"stays": {"material": "m", "geometry": {"type": "box", "min": [0.2, 0.6], "max": [0.4, 0.8]}},
                   "leaves": {"material": "m", "velocity": [4, 0], "geometry": {"type": "box", "min": [0.7, 0.2], "max": [0.9, 0.4]}}},
        "loads": [{"type": "gravity", "acceleration": [0, -1]}],
        "damping": {"type": "kinetic"}, "health": {"off_grid": "delete"}
    })json");
    Simulated run(scene);
    while (!run->finished()) run.advance(1);
    EXPECT_EQ(run->particle_count("leaves"), 0u);
    EXPECT_NEAR(run->momentum()[1], -0.04 * run->time(), 0.02 * 0.04 * run->time());  // falls freely
}

}  // namespace
}  // namespace matpoint::conformance
