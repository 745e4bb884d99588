#pragma once

#include "registry/catalogue.hpp"

#include <gtest/gtest.h>
#include <matpoint/exact_solution.hpp>

#include <memory>
#include <string>

namespace matpoint {

/// Makes exact solutions from their plugins, for a scene with one body, "body".
class SolutionsTest : public testing::Test {
  protected:
    /// `own` and `material` with every parameter given.
    std::shared_ptr<ExactSolution> make(Json own, const Json& material, Mode mode = Mode::bar) {
        if (!catalogue.find("exact_solution", own.at("type").get<std::string>()))
            throw std::logic_error("no plugin for the exact solution " + own.at("type").dump());
        own["body"] = {"body"};
        scene = {{"grid", {{"cell_size", {0.1, 0.1, 0.1}}}},
                 {"materials", {{"stuff", material}}},
                 {"bodies", {{"body", {{"material", "stuff"}}}}}};
        return catalogue.registry().make<ExactSolution>("exact_solution", own,
                                                        {{mode, false}, ".", &catalogue.registry(), &scene});
    }

    static Json elastic(const std::string& type = "linear_elastic", const std::string& strain = "small") {
        Json material = {{"type", type}, {"density", 2}, {"youngs_modulus", 50}, {"poissons_ratio", 0.3}};
        if (type == "linear_elastic") material["strain"] = strain;
        return material;
    }
    static constexpr double modulus = 50, density = 2, c = 5;  ///< Pa, kg/m^3, m/s

    PluginCatalogue catalogue;
    Json scene;
};

}  // namespace matpoint
