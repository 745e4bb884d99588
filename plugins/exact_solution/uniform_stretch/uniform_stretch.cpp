#include <matpoint/exact_solution.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>

namespace matpoint {

/// A body that is stretched along x, everywhere alike; see README.md.
class UniformStretch final : public ExactSolution {
  public:
    static Schema schema() {
        Schema schema("A body is stretched along x, everywhere alike: x = l(t) X, its sides held");
        schema.number("stretch", {.unit = "", .doc = "l at the end", .greater_than = 0})
            .number("duration", {.unit = "s", .doc = "Time in which l grows from 1 to it", .greater_than = 0})
            .choice("course", {.doc = "Whether l begins and ends without velocity and acceleration, or grows "
                                      "linearly in time",
                               .default_value = "smooth",
                               .choices = {"smooth", "linear"}});
        refuse_other_materials(schema, {"linear_elastic", "neo_hookean"});
        return warn_without_body_force(schema);
    }
    explicit UniformStretch(const Parameters& parameters)
        : ExactSolution(parameters),
          stretch_(parameters.number("stretch")),
          duration_(parameters.number("duration")),
          linear_(parameters.text("course") == "linear"),
          axisymmetric_(parameters.context().space.mode == Mode::axisymmetric),
          elastic_(elastic_constants(parameters)),
          law_(law_of(parameters)) {}

    Vector displacement(const Vector& reference, double time) const override {
        return {(at(time).stretch - 1) * reference[0], 0, 0};
    }
    Vector velocity(const Vector& reference, double time) const override {
        return {at(time).rate * reference[0], 0, 0};
    }
    Matrix deformation_gradient(const Vector&, double time) const override {
        const double l = at(time).stretch;
        return Eigen::Vector3d(l, 1, axisymmetric_ ? l : 1).asDiagonal();
    }
    Matrix stress(const Vector& reference, double time) const override {
        const Eigen::Array3d stretches = deformation_gradient(reference, time).diagonal();
        return principal_stresses(stretches).matrix().asDiagonal();
    }
    /// The stress is the same everywhere, so that the body force has to bring about all of the acceleration.
    Vector body_force(const Vector& reference, double time) const override {
        return {at(time).acceleration * reference[0], 0, 0};
    }

  private:
    enum class Law { neo_hookean, small_strain, rate };
    static Law law_of(const Parameters& parameters) {
        const Json& scene = *parameters.context().scene;
        const Json& body = scene.at("bodies").at(parameters.texts("body").front());
        const Json& material = scene.at("materials").at(body.at("material").get<std::string>());
        if (material.at("type") == "neo_hookean") return Law::neo_hookean;
        return material.at("strain") == "small" ? Law::small_strain : Law::rate;
    }

    /// l, dl/dt (1/s), d^2 l/dt^2 (1/s^2).
    struct Stretch {
        double stretch, rate, acceleration;
    };
    Stretch at(double time) const {
        const double s = std::clamp(time / duration_, 0.0, 1.0), grown = stretch_ - 1;
        if (linear_) return {1 + grown * s, grown / duration_, 0};
        return {1 + grown * s * s * s * (10 + s * (6 * s - 15)),
                grown / duration_ * 30 * s * s * (1 - s) * (1 - s),
                grown / (duration_ * duration_) * 60 * s * (1 - s) * (1 - 2 * s)};
    }

    /// Pa.
    Eigen::Array3d principal_stresses(const Eigen::Array3d& stretches) const {
        const double lambda = elastic_.lambda, mu = elastic_.mu, j = stretches.prod();
        if (law_ == Law::neo_hookean)  // [Wallstedt & Guilkey 2008, eq. 55]
            return (lambda * std::log(j) + mu * (stretches.square() - 1)) / j;
        if (law_ == Law::small_strain) return lambda * (stretches.sum() - 3) + 2 * mu * (stretches - 1);
        // Without spin, the integral of D is the logarithm of the stretch.
        return lambda * std::log(j) + 2 * mu * stretches.log();
    }

    double stretch_, duration_;  ///< -, s
    bool linear_;
    bool axisymmetric_;
    ElasticConstants elastic_;
    Law law_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("uniform_stretch", "1.0.0") {
    registry.exact_solution<matpoint::UniformStretch>("uniform_stretch");
}
