// Same scene, same bits: across a restart, any number of threads, and the resolved scene.
#include "every_plugin.hpp"
#include "run/checkpoint_file.hpp"
#include "simulated.hpp"
#include "verify/compare_states.hpp"

#include <matpoint/parallel.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

namespace matpoint::conformance {
namespace {

constexpr long steps = 40;

/// Every integrator with every transfer, in a scene that suits both, for every material.
std::vector<Json> combinations() {
    std::vector<Json> scenes;
    const auto with = [](const Json& integrator, const Json& transfer) {
        Json scene = busy_scene();
        scene["integrator"] = integrator;
        scene["transfer"] = transfer;
        return scene;
    };
    std::vector<Json> transfers = every_plugin("transfer");
    transfers.push_back({{"type", "flip"}, {"pic_fraction", 0.2}, {"gradient_enhanced", true}});
    for (const Json& integrator : every_plugin("integrator"))
        for (const Json& transfer : transfers) {
            if (integrator.at("type") == "usf" && transfer.value("gradient_enhanced", false)) continue;
            scenes.push_back(with(integrator, transfer));
        }
    PluginCatalogue catalogue;
    for (const std::string& type : catalogue.types("material")) {
        std::ifstream example(std::string(PLUGIN_SOURCES) + "/material/" + type + "/example.json");
        const Json materials = Json::parse(example, nullptr, true, true).at("materials");
        Json scene = busy_scene();
        scene["materials"]["rubber"] = *materials.begin();
        scenes.push_back(scene);
    }
    for (const Json& shape : every_plugin("shape_function")) {
        Json scene = busy_scene();
        scene["shape_function"] = shape;
        scenes.push_back(scene);
    }
    Json ring = busy_scene();
    ring["space"]["mode"] = "axisymmetric";
    ring["space"]["precision"] = "single";
    scenes.push_back(ring);
    return scenes;
}

class EveryCombination : public testing::TestWithParam<Json> {};

TEST_P(EveryCombination, RestartEqualsTheUninterruptedRun) {
    Simulated whole(GetParam());
    whole.advance(steps);
    const auto file =
        std::filesystem::temp_directory_path() / ("matpoint_restart_" + std::to_string(getpid()) + ".h5");
    {
        Simulated half(GetParam());
        half.advance(steps / 2);
        write_checkpoint(file, half->state());
    }
    Simulated rest(GetParam());
    rest->restore(read_checkpoint(file));
    rest.advance(steps - steps / 2);
    std::filesystem::remove(file);
    EXPECT_EQ(first_difference(whole->state(), rest->state()), "");
}

TEST_P(EveryCombination, TheNumberOfThreadsChangesNoBit) {
    Simulated alone(GetParam());
    alone.advance(steps);
    for (const int count : {2, 3, 8}) {
        set_threads(count);
        Simulated shared(GetParam());
        shared.advance(steps);
        set_threads(1);
        EXPECT_EQ(first_difference(alone->state(), shared->state()), "") << count << " threads";
    }
}

TEST_P(EveryCombination, TheResolvedSceneRunsToTheSameBits) {
    Simulated given(GetParam());
    Simulated resolved(given.scene.resolved);
    EXPECT_EQ(first_difference(given.advance(steps)->state(), resolved.advance(steps)->state()), "");
}

TEST_P(EveryCombination, MomentumBalancesWithLoadsAndWalls) {
    Simulated run(GetParam());
    run.advance(steps);
    const bool single = run->space().single;
    EXPECT_LT(run->conservation().momentum_drift, single ? 2e-5 : 1e-12);
    EXPECT_EQ(run->conservation().mass_drift, 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryCombination, testing::ValuesIn(combinations()),
                         [](const auto& test) { return "scene_" + std::to_string(test.index); });

}  // namespace
}  // namespace matpoint::conformance
