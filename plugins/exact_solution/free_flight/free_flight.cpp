#include <matpoint/exact_solution.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <optional>
#include <vector>

namespace matpoint {

/// Matter without stress: every point keeps its velocity; see README.md.
class FreeFlight final : public ExactSolution {
  public:
    static Schema schema() {
        Schema schema(
            "Matter without stress: every point flies on with the velocity that it has at the start",
            "[Wallstedt & Guilkey 2007, section 3]");
        schema
            .add("velocity", ParameterType::profiles,
                 {.unit = "m/s",
                  .doc = "Velocity by initial position: numbers or formulas of x, y, z",
                  .variables = "xyz"})
            .warn("/velocity",
                  "no stress is exact for a material with \"youngs_modulus\": 0 only, unless the "
                  "velocity is the same everywhere",
                  [](const Json& own, const Json& scene) {
                      const bool uniform = std::ranges::none_of(own.at("velocity"),
                                                                [](const Json& v) { return v.is_string(); });
                      return !uniform && std::ranges::any_of(own.at("body"), [&](const Json& name) {
                          const Json& body = scene.at("bodies").at(name.get<std::string>());
                          return scene.at("materials")
                                     .at(body.at("material").get<std::string>())
                                     .value("youngs_modulus", 1.0) != 0;
                      });
                  });
        return schema;
    }
    explicit FreeFlight(const Parameters& parameters)
        : ExactSolution(parameters),
          dimension_(parameters.context().space.dimension()),
          axisymmetric_(parameters.context().space.mode == Mode::axisymmetric) {
        for (const Json& component : parameters.json().at("velocity"))
            velocity_.push_back(component.is_null() ? std::nullopt : std::optional<Profile>(component));
        const auto cells = parameters.context().scene->at("grid").at("cell_size").get<std::vector<double>>();
        reach_ = 1e-3 * *std::ranges::min_element(cells);
    }

    Vector displacement(const Vector& reference, double time) const override {
        return time * velocity(reference, 0);
    }
    Vector velocity(const Vector& reference, double) const override {
        Vector v = Vector::Zero();
        for (std::size_t a = 0; a < velocity_.size(); ++a)
            if (velocity_[a])
                v[static_cast<Eigen::Index>(a)] =
                    (*velocity_[a])({reference[0], reference[1], reference[2]}, 0);
        return v;
    }
    Matrix deformation_gradient(const Vector& reference, double time) const override {
        Matrix f = Matrix::Identity();
        for (int a = 0; a < dimension_; ++a) {
            const Vector step = reach_ * Vector::Unit(a);
            f.col(a) += time / (2 * reach_) * (velocity(reference + step, 0) - velocity(reference - step, 0));
        }
        if (axisymmetric_)
            f(2, 2) = reference[0] > 0 ? 1 + displacement(reference, time)[0] / reference[0] : f(0, 0);
        return f;
    }
    Matrix stress(const Vector&, double) const override { return Matrix::Zero(); }

  private:
    int dimension_;
    bool axisymmetric_;
    std::vector<std::optional<Profile>> velocity_;
    double reach_;  ///< of the differences for grad v, m
};

}  // namespace matpoint

MATPOINT_PLUGIN("free_flight", "1.0.0") {
    registry.exact_solution<matpoint::FreeFlight>("free_flight");
}
