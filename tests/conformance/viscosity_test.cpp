// Artificial viscosity in runs: what it adds to the stress, and where its work goes.
#include "every_plugin.hpp"
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matpoint::conformance {
namespace {

constexpr double rate = 0.5, wave_speed = 10;  // 1/s, m/s

/// A block that a field of velocity compresses, or widens, evenly.
Json driven_block(const Json& velocity) {
    Json scene = Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [2, 1], "cell_size": [0.25, 0.125]},
        "time": {"end": 100, "step": 1e-3},
        "materials": {"rubber": {"type": "linear_elastic", "density": 2, "youngs_modulus": 200, "poissons_ratio": 0}},
        "bodies": {"block": {"material": "rubber", "artificial_viscosity": {"linear": 0.3, "quadratic": 1.5},
                             "geometry": {"type": "box", "min": [0.5, 0.25], "max": [1.5, 0.75]}}},
        "boundary_conditions": [{"type": "velocity", "on": {"type": "box", "min": [0, 0], "max": [2, 1]}}],
        "outputs": [{"type": "csv", "fields": ["stress", "total_stress", "volume"]}]
    })json");
    scene["boundary_conditions"][0]["velocity"] = scene["bodies"]["block"]["velocity"] = velocity;
    return scene;
}

TEST(ArtificialViscosity, IsAPressureBesideTheStressOfWhatIsCompressed) {
    for (const Json& integrator : every_plugin("integrator")) {
        SCOPED_TRACE(integrator.dump());
        Json scene = driven_block({"-0.3*x", "-0.2*y"});
        scene["integrator"] = integrator;
        Simulated run(scene);
        run.advance(4);  // the speed of sound falls as the density grows
        const double h = std::sqrt(0.25 * 0.125);
        const auto stress = run->column("block", "stress", 0),
                   total = run->column("block", "total_stress", 0),
                   across = run->column("block", "total_stress", 2),
                   normal = run->column("block", "stress", 2),
                   shear = run->column("block", "total_stress", 3),
                   volume = run->column("block", "volume", 0), mass = run->column("block", "mass", 0);
        for (std::size_t p = 0; p < stress.size(); ++p) {
            const double density = mass[p] / volume[p];
            const double q = density * (0.3 * wave_speed * h * rate + 1.5 * h * h * rate * rate);
            EXPECT_NEAR(stress[p] - total[p], q, 2e-3 * q);
            EXPECT_NEAR(normal[p] - across[p], q, 2e-3 * q);
            EXPECT_NEAR(shear[p], 0, 1e-9);
        }
    }
}

TEST(ArtificialViscosity, IsNotThereWhereNothingIsCompressed) {
    Simulated run(driven_block({"0.3*x", "-0.3*y"}));
    run.advance(20);
    for (int c = 0; c < 4; ++c) {
        const auto stress = run->column("block", "stress", c),
                   total = run->column("block", "total_stress", c);
        for (std::size_t p = 0; p < stress.size(); ++p)
            EXPECT_NEAR(total[p], stress[p], 1e-3);  // of 1.8: rounding of tr L, times c h rho
    }
}

// What the boundaries put in beyond the elastic energy is q's work, int q |D| V dt.
TEST(ArtificialViscosity, ItsWorkIsThatOfTheStresses) {
    const auto work = [](const Json& viscosity) {
        Json scene = driven_block({"-0.3*x", "-0.2*y"});
        if (viscosity.is_null())
            scene["bodies"]["block"].erase("artificial_viscosity");
        else
            scene["bodies"]["block"]["artificial_viscosity"] = viscosity;
        scene["outputs"][0]["fields"] = {"stress"};
        Simulated run(scene);
        run.advance(100);
        return run->energies().strain;
    };
    // rho V is the mass, so that q V = m (c1 c h |D| + ...) stays.
    const double h = std::sqrt(0.25 * 0.125), time = 0.1, mass = 1;
    const double expected = mass * rate * time * 0.3 * wave_speed * h * rate;
    EXPECT_NEAR(work({{"linear", 0.3}, {"quadratic", 0}}) - work(nullptr), expected, 0.02 * expected);
}

TEST(ArtificialViscosity, ShortensTheStep) {
    Json scene = driven_block({"-0.3*x", "-0.2*y"});
    scene["time"] = {{"end", 100}, {"cfl", 0.1}};
    Simulated with(scene);
    with.advance(2);
    scene["bodies"]["block"].erase("artificial_viscosity");
    scene["outputs"][0]["fields"] = {"stress"};
    Simulated without(scene);
    without.advance(2);
    const double q = 0.3 * wave_speed + 1.5 * std::sqrt(0.25 * 0.125) * rate;
    const double ratio = with->next_time_step() / without->next_time_step();
    EXPECT_NEAR(ratio, wave_speed / (q + std::hypot(q, wave_speed)), 0.02);
}

// A shock with noise and none without: the energy of the balance is kept by all schemes.
TEST(ArtificialViscosity, KeepsTheBalanceOfEnergyInAShock) {
    for (const char* form : {"landshoff", "chen_brannon"})
        for (const Json& integrator : every_plugin("integrator")) {
            SCOPED_TRACE(integrator.dump() + form);
            Json scene = driven_block({-1, 0});
            scene["grid"]["cell_size"] = 0.05;
            scene["integrator"] = integrator;
            scene["bodies"]["block"]["geometry"] = {{"type", "box"}, {"min", {0, 0}}, {"max", {1.5, 1}}};
            scene["bodies"]["block"]["artificial_viscosity"] = {
                {"form", form}, {"linear", 0.1}, {"quadratic", 0.3}};
            scene["time"] = {{"end", 100}, {"cfl", 0.2}};
            scene["boundary_conditions"] = {{{"type", "slip"}, {"on", {"x_min", "y_min", "y_max"}}}};
            Simulated run(scene);
            while (run->time() < 0.1) run.advance(1);
            EXPECT_LT(run->conservation().energy_drift, 0.02);
            EXPECT_LT(run->conservation().momentum_drift, 1e-12);
        }
}

TEST(ArtificialViscosity, ContinuesToTheSameBits) {
    Json scene = driven_block({"-0.3*x*x", "-0.2*y"});
    scene["bodies"]["block"]["artificial_viscosity"] = {
        {"form", "chen_brannon"}, {"linear", 0.1}, {"quadratic", 0.3}};
    scene["boundary_conditions"] = Json::array();
    scene["time"] = {{"end", 100}, {"cfl", 0.2}};
    Simulated whole(scene), first(scene), second(scene);
    whole.advance(40);
    first.advance(20);
    second->restore(first->state());
    second.advance(20);
    for (int c = 0; c < 4; ++c)
        EXPECT_EQ(second->column("block", "total_stress", c), whole->column("block", "total_stress", c));
    EXPECT_EQ(second->time(), whole->time());
}

}  // namespace
}  // namespace matpoint::conformance
