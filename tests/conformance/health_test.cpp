// Breakdowns of the numbers are told, not run through.
#include "run/run.hpp"
#include "simulated.hpp"
#include "verify/compare_states.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
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

    RunResult run(const Json& json, std::optional<CheckpointData> resume = {}) {
        PluginCatalogue catalogue;
        const Scene scene = load_scene(parse_document(json.dump(), "scene.json"), {}, catalogue);
        return run_scene(scene, catalogue,
                         {.output = folder_, .quiet = true, .keep_state = true, .resume = std::move(resume)});
    }
    std::string text(const char* file) const {
        std::ifstream in(folder_ / file);
        return {std::istreambuf_iterator<char>(in), {}};
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

/// A bar of dust, hardly stiff, whose halves fly apart.
Json halves(double end) {
    Json scene = Json::parse(R"json({
        "matpoint": 1, "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [2, 0.5], "cell_size": 0.05},
        "materials": {"dust": {"type": "neo_hookean", "density": 1, "youngs_modulus": 1e-6, "poissons_ratio": 0.3}},
        "bodies": {"bar": {"material": "dust", "velocity": ["x < 1 ? -1 : 1", 0],
                           "geometry": {"type": "box", "min": [0.7, 0.2], "max": [1.3, 0.3]}}}
    })json");
    scene["time"]["end"] = end;
    return scene;
}

TEST_F(Health, ATornBodyIsCalledTorn) {
    const RunResult apart = run(halves(0.3));
    EXPECT_EQ(apart.status, RunStatus::completed) << apart.reason;
    const std::string warnings = summary().at("warnings").dump();
    EXPECT_NE(warnings.find("\\\"bar\\\" is torn: it is in 2 parts (of 48, 48 particles)"), std::string::npos)
        << warnings;

    const RunResult off = run(halves(2));
    EXPECT_EQ(off.status, RunStatus::broke_down);
    EXPECT_NE(off.reason.find("is torn"), std::string::npos) << off.reason;
    EXPECT_NE(off.reason.find("particles_per_cell"), std::string::npos) << off.reason;
    EXPECT_LT(off.reason.find("is torn"), off.reason.find("Enlarge /grid")) << off.reason;
}

TEST_F(Health, BodiesOfSeveralPartsAreNotTorn) {
    Json scene = halves(0.05);
    scene["bodies"]["bar"]["velocity"] = {0, 0};
    scene["bodies"]["bar"]["geometry"] = Json::parse(R"json({"type": "union", "of": [
        {"type": "box", "min": [0.2, 0.2], "max": [0.4, 0.3]}, {"type": "box", "min": [1.2, 0.2], "max": [1.4, 0.3]}]})json");
    EXPECT_EQ(run(scene).status, RunStatus::completed);
    EXPECT_FALSE(summary().contains("warnings")) << summary().at("warnings").dump();
}

TEST_F(Health, AContiguousDomainThatTurnsIsTold) {
    Json scene = falling_block();
    scene["loads"] = Json::array();
    scene["bodies"]["block"]["velocity"] = {"-2*(y-0.625)", "2*(x-0.5)"};
    scene["shape_function"] = {{"type", "gimp"}};
    scene["time"]["end"] = 0.2;
    EXPECT_EQ(run(scene).status, RunStatus::completed);
    EXPECT_EQ(text("summary.json").find("stretched"), std::string::npos);
    scene["time"]["end"] = 0.75;  // 1.5 radians
    run(scene);
    EXPECT_NE(text("summary.json").find("Set /shape_function/domain to"), std::string::npos)
        << text("summary.json");
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
    for (Json& material : scene["materials"]) material["density"] = 1e6;  // the force overflows
    scene["loads"] = {{{"type", "body_force"}, {"acceleration", {"t > 0.05 ? 1e308 : 0", 0}}}};
    const RunResult result = run(scene);
    EXPECT_EQ(result.status, RunStatus::broke_down);
    EXPECT_NE(result.reason.find("finite"), std::string::npos) << result.reason;
}

TEST_F(Health, NotFiniteIsToldOfAParticleThatIsNot) {
    Json scene = falling_block();
    scene["shape_function"] = {{"type", "linear"}};  // sums with weights that are 0 are not numbers
    scene["transfer"] = {{"type", "flip"}};
    scene["integrator"] = {{"type", "musl"}};
    for (Json& material : scene["materials"]) material["density"] = 1e6;  // the force overflows
    scene["loads"] = {{{"type", "body_force"}, {"acceleration", {"x > 0.7 ? 1e308 : 0", 0}}}};
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

Json vibrating_bar() {
    return Json::parse(R"json({
        "matpoint": 1,
        "space": {"dimension": 1},
        "grid": {"type": "uniform", "min": [0], "max": [1], "cell_size": 0.0625},
        "shape_function": {"type": "gimp"},
        "integrator": {"type": "usl"},
        "time": {"end": 6, "step": 0.046875},
        "materials": {"rubber": {"type": "linear_elastic", "density": 1, "youngs_modulus": 1}},
        "bodies": {"bar": {"material": "rubber", "velocity": ["1e-6*sin(pi*x)"],
                           "geometry": {"type": "box", "min": [0], "max": [1]}}},
        "boundary_conditions": [{"type": "fixed", "on": ["x_min", "x_max"]}]
    })json");
}

TEST_F(Health, LimitOfTheStepKnowsIntegratorAndShapeFunction) {
    // Over a wave's time through a cell: omega dt < 2, or sqrt(2), at omega = c times the slope of the
    // shortest wave, 2 / h or, with quadratic splines and particles at quarters of cells, 1 / h; 1 at most.
    const auto part = [](const char* integrator, const Json& shape, int per_cell) {
        Json scene = vibrating_bar();
        scene["integrator"]["type"] = integrator;
        scene["shape_function"] = shape;
        scene["bodies"]["bar"]["particles_per_cell"] = per_cell;
        return Simulated(scene)->stable_step() / (0.0625 / (1 + 1e-6));
    };
    const Json linear = {{"type", "linear"}}, gimp = {{"type", "gimp"}}, quadratic = {{"type", "bspline"}};
    for (const char* integrator : {"usl", "central_difference"}) {
        for (const int per_cell : {1, 2, 4}) {
            EXPECT_NEAR(part(integrator, linear, per_cell), std::sqrt(0.5), 1e-6) << integrator;
            EXPECT_NEAR(part(integrator, gimp, per_cell), std::sqrt(0.5), 1e-6) << integrator;
        }
        EXPECT_NEAR(part(integrator, quadratic, 1), std::sqrt(0.5), 1e-6) << integrator;
        EXPECT_NEAR(part(integrator, quadratic, 2), 1, 1e-6) << integrator;
    }
    for (const char* integrator : {"usf", "musl", "uvf"})
        for (const Json& shape : {linear, gimp, quadratic})
            EXPECT_NEAR(part(integrator, shape, 2), 1, 1e-6) << integrator;
}

TEST_F(Health, UslAtThreeQuartersOfAWavesTimeIsToldAtOnce) {
    const RunResult result = run(vibrating_bar());
    EXPECT_EQ(result.status, RunStatus::broke_down);
    EXPECT_EQ(summary().at("steps"), 0);
    EXPECT_NE(result.reason.find("0.04419 s = 0.707 (of this integrator and shape function)"),
              std::string::npos)
        << result.reason;
}

TEST_F(Health, StepDoesNotDependOnTheEnd) {
    Json scene = falling_block();
    for (const double stiffness : {1e5, 1e-9, 0.0}) {
        scene["materials"]["rubber"]["youngs_modulus"] = stiffness;
        std::vector<double> steps;
        for (const double end : {0.02, 20.0}) {
            scene["time"]["end"] = end;
            Simulated run(scene);
            for (int k = 0; k < 3; ++k) {
                run.advance(1);
                steps.push_back(run->time_step());
            }
        }
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(steps[static_cast<std::size_t>(k)], steps[static_cast<std::size_t>(k) + 3])
                << stiffness;
    }
}

TEST_F(Health, StepOfWhatFallsIsItsTimeThroughACell) {
    Json scene = falling_block();
    scene["materials"]["rubber"]["youngs_modulus"] = 0;
    Simulated run(scene);
    EXPECT_NEAR(run->next_time_step(), 0.4 * std::sqrt(2 * 0.125 / 10), 1e-12);
}

TEST_F(Health, RunThatGoesOnToALaterEndEqualsTheWholeRun) {
    Json scene = falling_block();
    scene["boundary_conditions"] = {{{"type", "slip"}, {"on", {"y_min"}}}};
    scene["time"]["end"] = 0.04;
    const CheckpointData part = run(scene).final_state;
    scene["time"]["end"] = 0.12;
    const CheckpointData whole = run(scene).final_state;
    EXPECT_EQ(first_difference(whole, run(scene, part).final_state), "");
}

TEST_F(Health, RestartAtTheEndTellsWhatTheRunTold) {
    Json scene = falling_block();
    scene["time"]["end"] = 0.1;
    scene["boundary_conditions"] = {{{"type", "slip"}, {"on", {"y_min"}}, {"name", "floor"}}};
    scene["outputs"] = {{{"type", "probe"},
                         {"name", "force"},
                         {"quantity", "reaction"},
                         {"boundary_condition", "floor"},
                         {"component", "y"},
                         {"every", 1}}};
    for (const char* precision : {"double", "single"}) {
        scene["space"]["precision"] = precision;
        const RunResult ended = run(scene);
        const std::string force = text("force.csv");
        const RunResult again = run(scene, ended.final_state);
        EXPECT_EQ(again.summary.at("final"), ended.summary.at("final"));
        EXPECT_EQ(again.summary.at("conservation"), ended.summary.at("conservation"));
        EXPECT_EQ(text("force.csv"), force);
        EXPECT_TRUE(again.summary.at("nanoseconds_per_particle_step").is_null());
    }
}

}  // namespace
}  // namespace matpoint::conformance
