// The registry itself: entries, and one factory for each space.

#include <matpoint/integrator.hpp>
#include <matpoint/load.hpp>

#include <gtest/gtest.h>

namespace matpoint {

namespace {

/// Tells the space it was compiled for.
template <class S>
struct SpaceProbe final : Load<S> {
    static Schema schema() { return Schema("Does nothing").text("label", {}); }
    explicit SpaceProbe(const Parameters& parameters) : label(parameters.text("label")) {}
    void apply(LoadContext<S>&) const override {}
    std::string label;
};

template <class S>
struct IntegratorProbe final : Integrator<S> {
    static Schema schema() { return Schema("Does nothing"); }
    explicit IntegratorProbe(const Parameters&) {}
    void step(Phases<S>&, typename S::Real) const override {}
};

}  // namespace

TEST(Registry, MakesTheComponentOfTheSpace) {
    Registry registry;
    registry.load<SpaceProbe>("probe");
    for (const SpaceId space : {SpaceId{Mode::bar, false}, SpaceId{Mode::plane_strain, false},
                                SpaceId{Mode::axisymmetric, true}, SpaceId{Mode::solid, false}}) {
        Parameters::Context context;
        context.space = space;
        const auto made = registry.make<Component>("load", {{"type", "probe"}, {"label", "red"}}, context);
        with_space(space, [&]<class S>() {
            const auto* probe = dynamic_cast<const SpaceProbe<S>*>(made.get());
            ASSERT_NE(probe, nullptr);
            EXPECT_EQ(probe->label, "red");
        });
    }
}

TEST(Registry, KeepsKindsApart) {
    Registry registry;
    registry.load<SpaceProbe>("probe");
    EXPECT_NE(registry.find("load", "probe"), nullptr);
    EXPECT_EQ(registry.find("integrator", "probe"), nullptr);
    registry.integrator<IntegratorProbe>("probe");
    EXPECT_NE(registry.find("integrator", "probe"), nullptr);
}

TEST(Registry, NamesBothPluginsOfATypeRegisteredTwice) {
    Registry registry;
    registry.set_current_plugin("first", "1.0");
    registry.load<SpaceProbe>("probe");
    registry.set_current_plugin("second", "2.0");
    try {
        registry.load<SpaceProbe>("probe");
        FAIL() << "the second registration was taken";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(
            error.what(),
            "load \"probe\" is registered twice: by plugin \"first\" 1.0 and by plugin \"second\" 2.0");
    }
    EXPECT_EQ(registry.find("load", "probe")->plugin, "first");
}

}  // namespace matpoint
