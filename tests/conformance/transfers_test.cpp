#include "transfer_conformance.hpp"

#include "every_plugin.hpp"
#include "plugins.hpp"

namespace matpoint::conformance {
namespace {

Json flip(double pic_fraction, bool gradient_enhanced) {
    return {{"type", "flip"}, {"pic_fraction", pic_fraction}, {"gradient_enhanced", gradient_enhanced}};
}

std::vector<Json> every_transfer() {
    std::vector<Json> transfers = every_plugin("transfer");
    for (const double pic_fraction : {0.0, 0.3, 1.0})
        for (const bool enhanced : {false, true}) transfers.push_back(flip(pic_fraction, enhanced));
    for (const int order : {1, 3, 6}) transfers.push_back({{"type", "fmpm"}, {"order", order}});
    return transfers;
}

class EveryTransfer : public testing::TestWithParam<Json> {};

TEST_P(EveryTransfer, Conforms) {
    PluginCatalogue catalogue;
    catalogue.find("transfer", GetParam().at("type"));
    check_transfer(catalogue.registry(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Plugins, EveryTransfer, testing::ValuesIn(every_transfer()));

/// Velocity after an update of a particle at speed 2, the grid having velocity 5 and acceleration 10.
double updated(const Json& own) {
    Particles<Bar> particles("body");
    const auto transfer = make<Transfer<Bar>>("transfer", own);
    transfer->declare(particles);
    particles.resize(1);
    particles.column(Field::velocity)[0] = 2;
    Gathered<Bar> gathered;
    gathered.velocity[0][0] = 5;
    gathered.acceleration[0][0] = 10;
    gathered.affine[0][0] = 7;
    transfer->update(ParticleBatch<Bar>(particles, 0, 1, gathered, -1), 0.1);
    return particles.column(Field::velocity)[0];
}

TEST(Flip, MixesTheGridsVelocity) {
    EXPECT_DOUBLE_EQ(updated(flip(0, false)), 3);
    EXPECT_DOUBLE_EQ(updated(flip(0.25, false)), 0.75 * 3 + 0.25 * 5);
    EXPECT_DOUBLE_EQ(updated(flip(1, false)), 5);
}

TEST(Apic, TakesTheGridsVelocity) {
    EXPECT_DOUBLE_EQ(updated({{"type", "apic"}}), 5);
}

TEST(AffineFlip, AddsTheAccelerationAndMixesTheGridsVelocity) {
    EXPECT_DOUBLE_EQ(updated({{"type", "affine_flip"}, {"pic_fraction", 0}}), 3);
    EXPECT_DOUBLE_EQ(updated({{"type", "affine_flip"}, {"pic_fraction", 0.25}}), 0.75 * 3 + 0.25 * 5);
}

TEST(Flip, KnowsWhatGradientEnhancementNeeds) {
    const Schema schema = schema_of("transfer", "flip");
    const auto scene = [](const char* integrator, const char* shape) {
        return Json{{"integrator", {{"type", integrator}}}, {"shape_function", {{"type", shape}}}};
    };
    const char* pointer = "/gradient_enhanced";
    EXPECT_TRUE(has_rule(schema, true, pointer, flip(0, true), scene("usf", "gimp")));
    EXPECT_TRUE(has_rule(schema, false, pointer, flip(0, true), scene("uvf", "gimp")));
    for (const char* integrator : {"usl", "musl", "uvf", "central_difference"})
        EXPECT_FALSE(has_rule(schema, true, pointer, flip(0, true), scene(integrator, "gimp"))) << integrator;
    EXPECT_FALSE(has_rule(schema, true, pointer, flip(0, false), scene("usf", "gimp")));
    EXPECT_TRUE(has_rule(schema, false, pointer, flip(0, true), scene("usl", "linear")));
    EXPECT_FALSE(has_rule(schema, false, pointer, flip(0, true), scene("usl", "gimp")));
    EXPECT_FALSE(has_rule(schema, false, pointer, flip(0, false), scene("usl", "linear")));
}

}  // namespace
}  // namespace matpoint::conformance
