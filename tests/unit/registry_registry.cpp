// The registry itself: entries, and one factory for each space.

#include <matpoint/registry.hpp>

#include <gtest/gtest.h>

namespace matpoint {

namespace {

struct Probe : Component {
    int dimension = 0;
    bool single = false;
    std::string label;
};

template <class S>
struct SpaceProbe final : Probe {
    static Schema schema() { return Schema("Tells the space it was compiled for"); }
    explicit SpaceProbe(const Parameters& parameters) {
        dimension = S::dimension;
        single = sizeof(typename S::Real) == 4;
        label = parameters.text("label");
    }
};

}  // namespace

TEST(Registry, MakesTheComponentOfTheSpace) {
    Registry registry;
    registry.material<SpaceProbe>("probe");
    const auto make = [&](SpaceId space) {
        Parameters::Context context;
        context.space = space;
        return registry.make<Probe>("material", {{"type", "probe"}, {"label", "red"}}, context);
    };
    EXPECT_EQ(make({Mode::bar, false})->dimension, 1);
    EXPECT_EQ(make({Mode::axisymmetric, true})->dimension, 2);
    EXPECT_TRUE(make({Mode::axisymmetric, true})->single);
    EXPECT_EQ(make({Mode::solid, false})->dimension, 3);
    EXPECT_FALSE(make({Mode::solid, false})->single);
    EXPECT_EQ(make({Mode::plane_strain, false})->label, "red");
}

TEST(Registry, KeepsKindsApart) {
    Registry registry;
    registry.material<SpaceProbe>("probe");
    EXPECT_NE(registry.find("material", "probe"), nullptr);
    EXPECT_EQ(registry.find("load", "probe"), nullptr);
    registry.load<SpaceProbe>("probe");
    EXPECT_NE(registry.find("load", "probe"), nullptr);
}

TEST(Registry, NamesBothPluginsOfATypeRegisteredTwice) {
    Registry registry;
    registry.set_current_plugin("first", "1.0");
    registry.material<SpaceProbe>("probe");
    registry.set_current_plugin("second", "2.0");
    try {
        registry.material<SpaceProbe>("probe");
        FAIL() << "the second registration was taken";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(
            error.what(),
            "material \"probe\" is registered twice: by plugin \"first\" 1.0 and by plugin \"second\" 2.0");
    }
    EXPECT_EQ(registry.find("material", "probe")->plugin, "first");
}

}  // namespace matpoint
