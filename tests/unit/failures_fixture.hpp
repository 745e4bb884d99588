#pragma once

#include "config/diagnostics.hpp"
#include "run/run.hpp"

#include <matpoint/parallel.hpp>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "in: " << (text)

namespace fs = std::filesystem;

/// Runs scenes with components of the plugin `faulty`, on two threads.
class Failures : public testing::Test {
  protected:
    Failures() {
        std::string name = (fs::temp_directory_path() / "matpoint_failures_XXXXXX").string();
        folder = mkdtemp(name.data());
        set_threads(2);
    }
    ~Failures() override {
        set_threads(1);
        fs::remove_all(folder);
    }

    /// 1200 particles of a bar that moves with 1 m/s, by steps of 1 ms. The last begins at x = 3.09875 m.
    static Json bar() {
        return Json::parse(R"({
            "matpoint": 1, "space": {"dimension": 1},
            "grid": {"type": "uniform", "min": [0], "max": [4], "cell_size": 0.01},
            "time": {"end": 0.02, "step": 0.001},
            "materials": {"stuff": {"type": "faulty_material", "density": 1000, "stiffness": 1000}},
            "bodies": {"bar": {"material": "stuff", "velocity": [1], "particles_per_cell": 4,
                               "geometry": {"type": "box", "min": [0.1], "max": [3.1]}}}})");
    }

    Scene scene(const Json& text) {
        return resolve_scene(parse_document(text.dump(1), folder / "bar.json"), catalogue);
    }
    RunResult run(const Json& text, std::optional<long> steps = {}) {
        fs::remove_all(folder / "out");
        RunOptions options;
        options.output = folder / "out";
        options.quiet = true;
        options.stop_after_steps = steps;
        return run_scene(scene(text), catalogue, options);
    }
    /// The mistakes that a scene is refused for.
    std::vector<Diagnostic> refused(const Json& text) {
        try {
            Simulation::create(scene(text), catalogue);
        } catch (const InputError& error) {
            return error.diagnostics().all();
        }
        ADD_FAILURE() << "not refused";
        return {};
    }
    /// The one state that the run has saved.
    CheckpointData saved() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder / "out" / "checkpoints"))
            files.push_back(entry.path());
        EXPECT_EQ(files.size(), 1U);
        return read_checkpoint(files.at(0));
    }

    static PluginCatalogue with_faulty() {
        PluginCatalogue made;
        made.open_file(fs::path(TEST_PLUGINS) / "faulty" / "faulty.so");
        return made;
    }

    fs::path folder;
    PluginCatalogue catalogue = with_faulty();
};

}  // namespace matpoint
