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

}  // namespace
}  // namespace matpoint::conformance
