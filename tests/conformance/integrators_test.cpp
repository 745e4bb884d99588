#include "integrator_conformance.hpp"

#include "every_plugin.hpp"
#include "plugins.hpp"

namespace matpoint::conformance {
namespace {

class EveryIntegrator : public testing::TestWithParam<Json> {};

/// Those that halve the first acceleration are of second order [Wallstedt & Guilkey 2008, section 4].
TEST_P(EveryIntegrator, Conforms) {
    PluginCatalogue catalogue;
    const std::string type = GetParam().at("type");
    catalogue.find("integrator", type);
    check_integrator(catalogue.registry(), GetParam(), type == "central_difference" || type == "uvf" ? 2 : 1);
}

INSTANTIATE_TEST_SUITE_P(Plugins, EveryIntegrator, testing::ValuesIn(every_plugin("integrator")),
                         [](const auto& own) { return own.param.at("type").template get<std::string>(); });

/// A spring released at extension 1 with speed 0.5, step 0.1; k = m = 1.
Oscillator<Bar> first_step(const char* type) {
    const auto integrator = make<Integrator<Bar>>("integrator", {{"type", type}});
    Oscillator<Bar> spring;
    spring.extension = 1;
    spring.velocity = 0.5;
    spring.step(*integrator, 0.1);
    return spring;
}

TEST(Integrators, DifferInTheOrderOfThePhases) {
    const auto usf = first_step("usf");  // strain first, from the old velocity
    EXPECT_DOUBLE_EQ(usf.extension, 1.05);
    EXPECT_DOUBLE_EQ(usf.velocity, 0.5 - 0.1 * 1.05);
    for (const char* type : {"usl", "musl"}) {  // force first, strain from the new velocity
        const auto spring = first_step(type);
        EXPECT_DOUBLE_EQ(spring.velocity, 0.4) << type;
        EXPECT_DOUBLE_EQ(spring.extension, 1.04) << type;
    }
    for (const char* type : {"uvf", "central_difference"}) {
        const auto spring = first_step(type);
        EXPECT_DOUBLE_EQ(spring.velocity, 0.45) << type;
        EXPECT_DOUBLE_EQ(spring.extension, 1.045) << type;
    }
}

/// Which nodal velocity moves particles and strains them.
class Listener final : public Phases<Bar> {
  public:
    NodeField position = NodeField::mass, stress = NodeField::mass;

    long step_number() const override { return 1; }
    void project(Projection) override {}
    void accelerate(double, double) override {}
    void remap() override {}
    void update(Update what, double) override {
        if (what.position) position = *what.position;
        if (what.stress) stress = *what.stress;
    }
};

TEST(Integrators, UseTheRemappedVelocityWhereTheyShould) {
    constexpr auto velocity = NodeField::velocity, remapped = NodeField::remapped_velocity;
    const std::tuple<const char*, NodeField, NodeField> expected[] = {
        {"usf", velocity, velocity},
        {"usl", velocity, velocity},
        {"musl", velocity, remapped},
        {"uvf", remapped, remapped},
        {"central_difference", velocity, velocity},
        {"usavg", velocity, velocity},
        {"lagged_strain", velocity, velocity},
    };
    for (const auto& [type, position, stress] : expected) {
        Listener phases;
        make<Integrator<Bar>>("integrator", {{"type", type}})->step(phases, 0.1);
        EXPECT_EQ(phases.position, position) << type;
        EXPECT_EQ(phases.stress, stress) << type;
    }
}

}  // namespace
}  // namespace matpoint::conformance
