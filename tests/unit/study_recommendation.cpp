#include "study/recommendation.hpp"

#include <matpoint/geometry.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace matpoint {
namespace {

namespace fs = std::filesystem;

/// From 0 to its sides.
class Slab final : public Geometry {
  public:
    static Schema schema() { return Schema(); }
    explicit Slab(const Parameters& p) : sides_(p.vector("sides")) {}
    Bounds bounds() const override {
        return {Eigen::Vector3d::Zero(), Eigen::Vector3d(sides_[0], sides_[1], 0)};
    }
    bool contains(const Eigen::Vector3d&) const override { return true; }

  private:
    std::array<double, 3> sides_;
};

class StudyRecommendation : public ::testing::Test {
  protected:
    StudyRecommendation() {
        registry_.geometry<Slab>("slab");
        fs::create_directories(folder_);
        add("ring", R"({"title": "Ring", "about": {"dimension": 2, "mode": "plane_strain", "bodies": 1,
            "material": "neo_hookean", "exact_solution": "expanding_ring", "general": true},
            "front": [{"error": 0.1, "particle_steps": 1e3, "cells": 4, "settings": {"/integrator/type": "usl"}},
                      {"error": 0.01, "particle_steps": 1e5, "cells": 16, "settings": {"/integrator/type": "uvf"}}]})");
        add("square", R"({"title": "Square", "about": {"dimension": 2, "mode": "plane_strain", "bodies": 1,
            "material": "neo_hookean", "exact_solution": "axis_aligned_vibration", "general": false},
            "front": [{"error": 0.2, "particle_steps": 1e3, "cells": 8, "settings": {"/integrator/type": "usf"}}]})");
    }
    ~StudyRecommendation() override { fs::remove_all(folder_); }

    void add(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / (name + ".json")) << text;
    }
    std::string answer(const std::string& mode, const Json& accuracy, const char* solution = nullptr) const {
        Scene scene{};
        scene.document = parse_document("{}", "scene.json");
        scene.resolved = {{"space", {{"dimension", 2}, {"mode", mode}}},
                          {"materials", {{"rubber", {{"type", "neo_hookean"}}}}},
                          {"grid", {{"cell_size", {0.1, 0.2}}}},
                          {"bodies",
                           {{"block", {{"geometry", {{"type", "slab"}, {"sides", {3, 2}}}}}},
                            {"sheet", {{"geometry", {{"type", "slab"}, {"sides", {4, 0.8}}}}}}}}};
        scene.space = {.mode = Mode::plane_strain};
        if (!accuracy.is_null()) scene.resolved["accuracy"] = {{"target", accuracy}};
        if (solution) scene.resolved["exact_solution"] = {{"type", solution}};
        return recommendation(scene, registry_, folder_).value_or("nothing");
    }
    static bool says(const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    }

    Registry registry_;
    fs::path folder_ =
        fs::temp_directory_path() / ("matpoint_recommendation_test_" + std::to_string(getpid()));
};

TEST_F(StudyRecommendation, ASceneThatAsksForNothingGetsNothing) {
    EXPECT_EQ(answer("plane_strain", nullptr), "nothing");
}

TEST_F(StudyRecommendation, TheCheapestThatMeetsTheTargetIsNamed) {
    const std::string coarse = answer("plane_strain", 0.5), fine = answer("plane_strain", 0.02);
    EXPECT_TRUE(says(coarse, "\"Ring\"") && says(coarse, "usl") && !says(coarse, "uvf")) << coarse;
    EXPECT_TRUE(says(fine, "uvf") && says(fine, "16 cells")) << fine;
    EXPECT_TRUE(says(fine, "recommendation")) << fine;
}

TEST_F(StudyRecommendation, CellsAreThoseOfTheScenesThinnestBody) {
    const std::string mine =
        "/grid/cell_size = 0.05 for \"sheet\", whose smallest side is 0.8 m and has 8 cells now";
    EXPECT_TRUE(says(answer("plane_strain", 0.02), mine)) << answer("plane_strain", 0.02);
    EXPECT_TRUE(says(answer("plane_strain", 1e-9), mine)) << answer("plane_strain", 1e-9);
}

TEST_F(StudyRecommendation, TheStudyOfTheSameSolutionIsNearest) {
    const std::string text = answer("plane_strain", 0.5, "axis_aligned_vibration");
    EXPECT_TRUE(says(text, "\"Square\"") && says(text, "usf")) << text;
}

TEST_F(StudyRecommendation, ATargetOutOfReachIsSaid) {
    const std::string text = answer("plane_strain", 1e-9);
    EXPECT_TRUE(says(text, "no variant") && says(text, "0.01")) << text;
}

TEST_F(StudyRecommendation, NoStudyFitsAnotherSpace) {
    EXPECT_TRUE(says(answer("axisymmetric", 0.1), "no shipped study"));
}

}  // namespace
}  // namespace matpoint
