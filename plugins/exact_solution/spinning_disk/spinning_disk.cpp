#include "../ball.hpp"

#include <matpoint/plugin.hpp>

#include <cmath>

namespace matpoint {
namespace {

/// (w R)^2 rho / (lambda + 2 mu), of the first body; not finite without stiffness.
double squared_mach_number(const Json& own, const Json& scene) {
    const Json& body = scene.at("bodies").at(own.at("body").at(0).get<std::string>());
    const Json& material = scene.at("materials").at(body.at("material").get<std::string>());
    const double nu = material.value("poissons_ratio", 0.0);
    const double modulus =
        material.value("youngs_modulus", 0.0) * (1 - nu) / ((1 + nu) * (1 - 2 * nu));  // lambda + 2 mu, Pa
    const double speed = own.at("angular_velocity").get<double>() * own.at("radius").get<double>();
    return material.at("density").get<double>() * speed * speed / modulus;
}

}  // namespace

/// A disk with a free rim that turns steadily, widened by its spin, in plane strain; see README.md.
class SpinningDisk final : public ExactSolution {
  public:
    explicit SpinningDisk(const Parameters& parameters)
        : ExactSolution(parameters),
          elastic_(elastic_constants(parameters)),
          rate_(parameters.number("angular_velocity")) {
        if (parameters.has("center")) center_ = Vector::Map(parameters.vector("center").data());
        const double radius = parameters.number("radius");
        cubic_ = elastic_.density * rate_ * rate_ / (8 * (elastic_.lambda + 2 * elastic_.mu));
        linear_ = (3 - 2 * elastic_.poissons_ratio) * radius * radius * cubic_;
    }

    static Schema schema() {
        Schema schema("Steady rotation of a disk whose rim is free, with the widening that its spin makes",
                      "[Timoshenko & Goodier 1951, section 30]");
        schema.dimensions({2})
            .number("angular_velocity", {.unit = "rad/s", .doc = "Angular velocity w, from x to y"})
            .refuse(
                "", "is no solution in an axisymmetric space",
                [](const Json&, const Json& scene) { return scene.at("space").at("mode") == "axisymmetric"; })
            .refuse("/body", "needs a material with stiffness, which holds the disk together",
                    [](const Json& own, const Json& scene) {
                        return !std::isfinite(squared_mach_number(own, scene));
                    })
            .warn("/angular_velocity",
                  "moves the rim faster than a tenth of the speed of sound: this is a solution for small "
                  "strains",
                  [](const Json& own, const Json& scene) { return squared_mach_number(own, scene) > 0.01; });
        return refuse_other_materials(add_ball(schema), {"neo_hookean"});
    }

    Vector displacement(const Vector& reference, double time) const override {
        const Vector x = reference - center_;
        return rotation(time) * widened(x) - x;
    }
    Vector velocity(const Vector& reference, double time) const override {
        const Vector x = rotation(time) * widened(reference - center_);
        return rate_ * Vector(-x[1], x[0], 0);
    }
    Matrix deformation_gradient(const Vector& reference, double time) const override {
        return rotation(time) * (Matrix::Identity() + gradient(reference - center_));
    }
    /// Hooke's law, turned.
    Matrix stress(const Vector& reference, double time) const override {
        const Matrix strain = gradient(reference - center_), turn = rotation(time);
        return elastic_.lambda * strain.trace() * Matrix::Identity() +
               2 * elastic_.mu * turn * strain * turn.transpose();
    }

  private:
    Matrix rotation(double time) const {
        const double c = std::cos(rate_ * time), s = std::sin(rate_ * time);
        Matrix turn = Matrix::Identity();
        turn.topLeftCorner<2, 2>() << c, -s, s, c;
        return turn;
    }
    /// x + u(r) x / r, u = a r - b r^3
    Vector widened(const Vector& x) const { return (1 + linear_ - cubic_ * x.squaredNorm()) * x; }
    /// Of u(r) x / r; symmetric.
    Matrix gradient(const Vector& x) const {
        Matrix one = Matrix::Identity();
        one(2, 2) = 0;
        return (linear_ - cubic_ * x.squaredNorm()) * one - 2 * cubic_ * x * x.transpose();
    }

    ElasticConstants elastic_;
    double rate_;                     ///< w, rad/s
    double linear_, cubic_;           ///< a; b, 1/m^2
    Vector center_ = Vector::Zero();  ///< m
};

}  // namespace matpoint

MATPOINT_PLUGIN("spinning_disk", "1.0.0") {
    registry.exact_solution<matpoint::SpinningDisk>("spinning_disk");
}
