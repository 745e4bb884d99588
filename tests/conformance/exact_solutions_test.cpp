#include "exact_solution_conformance.hpp"

#include "made_solution.hpp"
#include "verify/load_scene.hpp"

#include <matpoint/geometry.hpp>

#include <gtest/gtest-spi.h>

#include <filesystem>
#include <utility>

namespace matpoint::conformance {
namespace {

namespace fs = std::filesystem;
const fs::path plugins = fs::path(PLUGIN_SOURCES) / "exact_solution";

bool for_small_strains(const std::string& type) {
    constexpr const char* types[] = {"plate_vibration", "free_disk_vibration", "free_sphere_vibration",
                                     "spinning_disk"};
    return std::ranges::find(types, type) != std::end(types);
}

/// The bodies of a resolved scene, until its end.
Samples samples_of(const Json& scene, const Registry& registry) {
    std::vector<std::shared_ptr<Geometry>> geometries;
    Geometry::Bounds bounds{Eigen::Vector3d::Constant(1e300), Eigen::Vector3d::Constant(-1e300)};
    for (const auto& [name, body] : scene.at("bodies").items()) {
        const Json& own = body.at("geometry");
        geometries.push_back(registry.make<Geometry>("geometry", own, context_of(registry, scene)));
        bounds.min = bounds.min.cwiseMin(geometries.back()->bounds().min);
        bounds.max = bounds.max.cwiseMax(geometries.back()->bounds().max);
    }
    const auto within = [geometries](const Eigen::Vector3d& x) {
        return std::ranges::any_of(geometries, [&](const auto& geometry) {
            return geometry->points() || geometry->contains(x);  // single points contain nothing
        });
    };
    return {.min = bounds.min,
            .max = bounds.max,
            .end = scene.at("time").at("end").get<double>(),
            .within = within,
            .infinitesimal = for_small_strains(scene.at("exact_solution").at("type").get<std::string>())};
}

class EveryExactSolution : public testing::TestWithParam<std::string> {
  protected:
    /// The example's first material: where it is, and what.
    static std::pair<std::string, Json> material() {
        const Json scene = read_document(plugins / GetParam() / "example.json").json;
        const auto first = scene.at("materials").begin();
        return {"/materials/" + first.key(), first.value()};
    }
    /// The plugin's example, changed by the assignments.
    void check(const std::vector<std::string>& assignments) {
        PluginCatalogue catalogue;
        const Scene scene = load_scene(plugins / GetParam() / "example.json", assignments, catalogue);
        check_exact_solution(catalogue.registry(), scene.resolved,
                             samples_of(scene.resolved, catalogue.registry()));
    }
};

TEST_P(EveryExactSolution, Conforms) {
    check({});
}

TEST_P(EveryExactSolution, ConformsForOtherConstants) {
    const auto& [pointer, own] = material();
    check({pointer + "/density=7.8",
           pointer + "/youngs_modulus=" + std::to_string(3 * own.at("youngs_modulus").get<double>())});
    check({pointer + "/density=1200"});
}

/// Those that are for one of Poisson's ratios say so.
TEST_P(EveryExactSolution, ConformsForOtherPoissonsRatiosOrRefusesThem) {
    const std::string pointer = material().first;
    for (const char* ratio : {"-0.2", "0.45"}) {
        SCOPED_TRACE(ratio);
        try {
            check({pointer + "/poissons_ratio=" + ratio});
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("Poisson's ratio 0 only"), std::string::npos)
                << error.what();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Plugins, EveryExactSolution,
                         testing::ValuesIn(PluginCatalogue().types("exact_solution")),
                         [](const auto& type) { return type.param; });

using Vector = Eigen::Vector3d;

/// A solution with one thing wrong by a factor.
class Wrong final : public ExactSolution {
  public:
    Wrong(const Made& made, double body_force, double velocity, double strain, double stress)
        : ExactSolution(
              Parameters(made.scene.at("exact_solution"), context_of(made.catalogue.registry(), made.scene))),
          right_(made.solution),
          body_force_(body_force),
          velocity_(velocity),
          strain_(strain),
          stress_(stress) {}
    Vector displacement(const Vector& x, double t) const override { return right_->displacement(x, t); }
    Vector velocity(const Vector& x, double t) const override { return velocity_ * right_->velocity(x, t); }
    Matrix deformation_gradient(const Vector& x, double t) const override {
        const Matrix one = Matrix::Identity();
        return one + strain_ * (right_->deformation_gradient(x, t) - one);
    }
    Matrix stress(const Vector& x, double t) const override { return stress_ * right_->stress(x, t); }
    Vector body_force(const Vector& x, double t) const override {
        return body_force_ * right_->body_force(x, t);
    }

  private:
    std::shared_ptr<ExactSolution> right_;
    double body_force_, velocity_, strain_, stress_;
};

TEST(ExactSolutionKit, SeesWhatIsWrong) {
    constexpr double off = 1 + 1e-7;
    const Samples samples{.min = Vector::Zero(), .max = Vector(1, 1, 0), .end = 0.02};
    const Made made("plane_strain", rubber("neo_hookean", 1, 1e4, 0.3), axis_aligned(0.1));
    const Wrong sign(made, -1, 1, 1, 1), force(made, off, 1, 1, 1), velocity(made, 1, off, 1, 1),
        strain(made, 1, 1, off, 1), stress(made, 1, 1, 1, off);
    EXPECT_NONFATAL_FAILURE(made.checks(sign, samples).all(), "momentum is off");
    EXPECT_NONFATAL_FAILURE(made.checks(force, samples).all(), "momentum is off");
    EXPECT_NONFATAL_FAILURE(made.checks(velocity, samples).velocity_is_rate_of_displacement(),
                            "velocity is off");
    EXPECT_NONFATAL_FAILURE(made.checks(strain, samples).deformation_gradient_is_derivative(),
                            "gradient is off");
    EXPECT_NONFATAL_FAILURE(made.checks(stress, samples).stress_follows_from_deformation(), "stress is off");
    EXPECT_NONFATAL_FAILURE(made.checks(stress, samples).momentum_is_balanced(), "momentum is off");
}

/// Also where terms of second order are allowed to be missing, and where it is not smooth or not finite.
TEST(ExactSolutionKit, SeesWhatIsWrongInSolutionsForSmallStrains) {
    const Samples samples{.min = Vector::Zero(), .max = Vector(1, 1, 0), .end = 0.1, .infinitesimal = true};
    const Made made("plane_strain", rubber("linear_elastic", 1, 1000, 0.3), plate(1e-5, "shear"));
    const Wrong stress(made, 1, 1, 1, 1.01), infinite(made, 1, 1, 1e300, 1);
    EXPECT_NONFATAL_FAILURE(made.checks(stress, samples).momentum_is_balanced(), "momentum is off");
    EXPECT_NONFATAL_FAILURE(made.checks(stress, samples).stress_follows_from_deformation(), "stress is off");
    EXPECT_NONFATAL_FAILURE(made.checks(infinite, samples).deformation_gradient_is_derivative(),
                            "gradient is off");
}

}  // namespace
}  // namespace matpoint::conformance
