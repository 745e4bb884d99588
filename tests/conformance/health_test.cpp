// Breakdowns of the numbers are told, not run through.
#include "run/run.hpp"
#include "simulated.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

namespace matpoint::conformance {
namespace {

namespace fs = std::filesystem;

Json falling_block() {
    return Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [1, 1], "cell_size": 0.125},
        "time": {"end": 1},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}},
        "bodies": {"block": {"material": "rubber", "geometry": {"type": "box", "min": [0.25, 0.5], "max": [0.75, 0.75]}}},
        "loads": [{"type": "gravity", "acceleration": [0, -10]}],
        "checkpoint": {"every_steps": 7}
    })json");
}

class Health : public testing::Test {
  protected:
    Health() : folder_(fs::temp_directory_path() / ("matpoint_health_" + std::to_string(getpid()))) {}
    ~Health() override { fs::remove_all(folder_); }

    RunResult run(const Json& json) {
        PluginCatalogue catalogue;
        const Scene scene = load_scene(parse_document(json.dump(), "scene.json"), {}, catalogue);
        return run_scene(scene, catalogue, {.output = folder_, .quiet = true});
    }
    Json summary() const {
        std::ifstream file(folder_ / "summary.json");
        return Json::parse(file);
    }

    fs::path folder_;
};

TEST_F(Health, ParticleOffTheGridStopsTheRunAndSavesTheLastGoodState) {
    const RunResult result = run(falling_block());
    EXPECT_EQ(result.exit_status(), 1);
    EXPECT_EQ(summary().at("status"), "broke_down");
    EXPECT_NE(result.reason.find("body \"block\""), std::string::npos) << result.reason;
    EXPECT_NE(result.reason.find("left the grid"), std::string::npos) << result.reason;
    EXPECT_NE(result.reason.find("/health/off_grid"), std::string::npos) << result.reason;

    const fs::path saved = folder_ / "checkpoints";
    long last = -1;
    CheckpointData state;
    for (const auto& entry : fs::directory_iterator(saved))
        if (CheckpointData candidate = read_checkpoint(entry.path()); candidate.step > last) {
            last = candidate.step;
            state = std::move(candidate);
        }
    EXPECT_EQ(last, summary().at("steps").get<long>());
    for (const auto& body : state.bodies)
        for (const auto& column : body.columns)
            for (const double value : std::get<std::vector<double>>(column.values))
                EXPECT_TRUE(std::isfinite(value));
}

TEST_F(Health, ParticlesMayBeDeletedWithTheLostMassReported) {
    Json scene = falling_block();
    scene["health"] = {{"off_grid", "delete"}};
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::completed) << result.reason;
    EXPECT_NEAR(summary().at("/conservation/lost_mass"_json_pointer).get<double>(), 1000 * 0.5 * 0.25, 1e-9);
    EXPECT_LT(summary().at("/conservation/mass_drift"_json_pointer).get<double>(), 1e-12);
    EXPECT_EQ(summary().at("particles"), 0);
    EXPECT_FALSE(summary().at("warnings").empty());
}

TEST_F(Health, StepBeyondTheStableOneIsToldBeforeItIsTaken) {
    Json scene = falling_block();
    scene["time"]["step"] = 0.1;
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::broke_down);
    EXPECT_NE(result.reason.find("/health/unstable_step"), std::string::npos) << result.reason;
    EXPECT_EQ(summary().at("steps"), 0);
}

TEST_F(Health, InsideOutIsToldWithTheParticle) {
    Json scene = falling_block();
    scene["loads"] = Json::array();
    scene["bodies"]["block"]["velocity"] = {"-4000*(x-0.5)", 0};
    scene["health"] = {{"unstable_step", "ignore"}};
    scene["time"]["step"] = 1e-3;
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::broke_down);
    EXPECT_NE(result.reason.find("inside out"), std::string::npos) << result.reason;
}

TEST_F(Health, NotFiniteIsTold) {
    Json scene = falling_block();
    scene["loads"] = {{{"type", "body_force"}, {"acceleration", {"t > 0.05 ? 1/0 : 0", 0}}}};
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::broke_down);
    EXPECT_NE(result.reason.find("finite"), std::string::npos) << result.reason;
}

TEST_F(Health, NotFiniteIsToldOfAParticleThatIsNot) {
    Json scene = falling_block();
    scene["loads"] = {{{"type", "body_force"}, {"acceleration", {"x > 0.7 ? 1/0 : 0", 0}}}};
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::broke_down);
    const std::size_t place = result.reason.find("at (");
    ASSERT_NE(place, std::string::npos) << result.reason;
    EXPECT_GT(std::stod(result.reason.substr(place + 4)), 0.625) << result.reason;  // a cell off at most
}

TEST_F(Health, WarningsGoOnAndAreKept) {
    Json scene = falling_block();
    scene["loads"] = Json::array();
    scene["time"] = {{"end", 1.0}, {"step", 0.2}};
    scene["health"] = {{"unstable_step", "warn"}};
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::completed) << result.reason;
    EXPECT_EQ(summary().at("warnings").size(), 1U);
}

TEST_F(Health, StepThatDoesNotAdvanceTheTimeIsToldEvenUnguarded) {
    Json scene = falling_block();
    scene["bodies"]["block"]["velocity"] = {1e200, 0};
    scene["health"] = {{"enabled", false}};
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::broke_down);
    EXPECT_NE(result.reason.find("too short"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace matpoint::conformance
