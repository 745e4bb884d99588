#pragma once

#include "registry/catalogue.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <matpoint/output.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "in: " << (text)

/// A run whose every number the test sets.
class FakeRun final : public RunView {
  public:
    using Columns = std::vector<std::vector<double>>;

    std::string title() const override { return "fake"; }
    double time() const override { return now; }
    long step() const override { return steps; }
    double time_step() const override { return 0.1; }
    SpaceId space() const override { return id; }
    std::vector<std::string> bodies() const override {
        std::vector<std::string> names;
        for (const auto& entry : data) names.push_back(entry.first);
        return names;
    }
    std::size_t particle_count(const std::string& body) const override {
        return data.at(body).at("mass")[0].size();
    }
    std::vector<std::string> fields(const std::string& body) const override {
        std::vector<std::string> names;
        for (const auto& entry : data.at(body)) names.push_back(entry.first);
        return names;
    }
    int components(const std::string& body, const std::string& field) const override {
        return static_cast<int>(data.at(body).at(field).size());
    }
    std::vector<double> column(const std::string& body, const std::string& field,
                               int component) const override {
        return data.at(body).at(field).at(static_cast<std::size_t>(component));
    }
    Energies energies() const override { return {1.5, 2.5, 0.25, 0.125}; }
    double mass() const override { return 77; }
    std::array<double, 3> momentum() const override { return {7, 8, 9}; }
    std::array<double, 3> reaction(const std::string& name) const override {
        if (name != "wall") throw std::out_of_range(name);
        return {-1, -2, -3};
    }

    std::vector<std::string> contacts() const override { return contact_names; }
    ContactReport contact(const std::string& name) const override {
        if (std::ranges::find(contact_names, name) == contact_names.end()) throw std::out_of_range(name);
        ContactReport report;
        report.force = {4, 5, 6};
        return report;
    }
    SurfaceMesh tool_surface(const std::string& name) const override {
        return name == "pair" ? SurfaceMesh{} : SurfaceMesh{{0, 0, 0, 1, now, 0}, 2, {1, 0}};
    }
    double unbalanced_force() const override { return 0.01; }
    double noise() const override { return 0.02; }

    double now = 0;
    long steps = 0;
    std::vector<std::string> contact_names{"pair"};
    SpaceId id{Mode::plane_strain, false};
    std::map<std::string, std::map<std::string, Columns>> data;
};

/// Two bodies in plane strain, of three particles and of one; only `disk` has plastic strain.
inline FakeRun plane_strain_run() {
    FakeRun run;
    run.data["disk"] = {{"id", {{0, 1, 2}}},
                        {"mass", {{1, 2, 5}}},
                        {"volume", {{1, 1, 1}}},
                        {"position", {{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}}},
                        {"initial_position", {{0.0, 1.0, 2.0}, {0.0, 1.0, 2.0}}},
                        {"velocity", {{1.0 / 3, -2, 3}, {4, 5, 6e-300}}},
                        {"stress", {{11, 12, 13}, {21, 22, 23}, {31, 32, 33}, {41, 42, 43}}},
                        {"deformation_gradient", {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}}},
                        {"plastic_strain", {{0.5, 0.25, 0.125}}}};
    run.data["plane"] = {{"id", {{0}}},
                         {"mass", {{2}}},
                         {"position", {{9}, {8}}},
                         {"initial_position", {{9}, {8}}},
                         {"velocity", {{-7}, {-6}}},
                         {"stress", {{1}, {2}, {3}, {4}}}};
    return run;
}

/// Makes outputs from their plugins, in a folder of the test's own.
class OutputTest : public testing::Test {
  protected:
    OutputTest() {
        std::string name = (std::filesystem::temp_directory_path() / "matpoint_output_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~OutputTest() override { std::filesystem::remove_all(folder); }

    std::shared_ptr<Output> make(Json own) {
        fill_defaults(own);
        return catalogue.registry().make<Output>("output", own,
                                                 {run.id, folder, &catalogue.registry(), nullptr});
    }

    /// Reasons of the rules that refuse the object in the scene.
    std::vector<std::string> refusals(Json own, Json scene = Json::object()) {
        fill_defaults(own);
        scene.emplace("space", Json{{"dimension", 2}});
        scene.emplace("outputs", Json::array({own}));
        scene.emplace("boundary_conditions", Json::array({{{"type", "fixed"}, {"name", "wall"}}}));
        std::vector<std::string> reasons;
        for (const Rule& rule : schema_of(own).rules())
            if (rule.refuses && rule.applies(own, scene))
                reasons.push_back(rule.pointer + ": " + rule.reason);
        return reasons;
    }

    /// What the call throws; empty if it throws nothing.
    template <class Call>
    static std::string error_of(Call&& call) {
        try {
            call();
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    }

    void write_at(Output& output, double time, long step) {
        run.now = time;
        run.steps = step;
        output.write(run);
        output.flush();
    }

    std::string text_of(const std::string& file) const {
        std::ifstream stream(folder / file, std::ios::binary);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    }
    bool exists(const std::string& file) const { return std::filesystem::exists(folder / file); }

    FakeRun run = plane_strain_run();
    std::filesystem::path folder;
    PluginCatalogue catalogue;

  private:
    const Schema& schema_of(const Json& own) {
        const Schema* schema = catalogue.find("output", own.at("type").get<std::string>());
        if (!schema) throw std::logic_error("no plugin for the output " + own.at("type").dump());
        return *schema;
    }
    void fill_defaults(Json& own) {
        for (const Parameter& p : schema_of(own).parameters())
            if (p.default_value && !own.contains(p.name)) own[p.name] = *p.default_value;
    }
};

}  // namespace matpoint
