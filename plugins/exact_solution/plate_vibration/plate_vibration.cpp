#include <matpoint/exact_solution.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>
#include <numbers>

namespace matpoint {

/// Free vibration of a square in its plane, of linear elasticity [Wallstedt & Guilkey 2007, section 5.3].
class PlateVibration final : public ExactSolution {
  public:
    explicit PlateVibration(const Parameters& parameters)
        : ExactSolution(parameters),
          material_(elastic_constants(parameters)),
          sign_(parameters.text("mode") == "shear" ? -1 : 1),
          amplitude_(parameters.number("amplitude")),
          wave_number_(std::numbers::pi / parameters.number("length")),
          frequency_(wave_number_ * std::sqrt(2 * modulus() / material_.density)) {}

    static Schema schema() {
        Schema schema(
            "Small vibration of a square plate in its plane, sides free to move along their normals only",
            "[Wallstedt & Guilkey 2007, section 5.3]");
        schema.dimensions({2})
            .number("amplitude", {.unit = "m", .doc = "Largest displacement; small against `length`"})
            .choice("mode", {.doc = "dilatation: no rotation; shear: no change of volume",
                             .default_value = "dilatation",
                             .choices = {"dilatation", "shear"}})
            .number("length", {.unit = "m",
                               .doc = "Side L of the plate, whose corner is at the origin",
                               .default_value = 1.0,
                               .greater_than = 0})
            .refuse(
                "", "is no solution in an axisymmetric space",
                [](const Json&, const Json& scene) { return scene.at("space").at("mode") == "axisymmetric"; })
            .warn("/amplitude", "is more than 1 % of `length`: this is a solution for small strains",
                  [](const Json& own, const Json&) {
                      return std::abs(own.at("amplitude").get<double>()) >
                             0.01 * own.at("length").get<double>();
                  });
        return refuse_other_materials(schema, {"linear_elastic", "neo_hookean"});
    }

    Vector displacement(const Vector& reference, double time) const override {
        return std::cos(frequency_ * time) * shape(reference);
    }
    Vector velocity(const Vector& reference, double time) const override {
        return -frequency_ * std::sin(frequency_ * time) * shape(reference);
    }
    Matrix deformation_gradient(const Vector& reference, double time) const override {
        return Matrix::Identity() + displacement_gradient(reference, time);
    }
    /// Hooke's law.
    Matrix stress(const Vector& reference, double time) const override {
        const Matrix gradient = displacement_gradient(reference, time);
        return material_.lambda * gradient.trace() * Matrix::Identity() +
               material_.mu * (gradient + gradient.transpose());
    }

  private:
    /// rho c^2 of the waves that the mode is made of, Pa.
    double modulus() const { return sign_ < 0 ? material_.mu : material_.lambda + 2 * material_.mu; }
    Vector shape(const Vector& reference) const {
        const double x = wave_number_ * reference[0], y = wave_number_ * reference[1];
        return amplitude_ * Vector(std::cos(x) * std::sin(y), sign_ * std::sin(x) * std::cos(y), 0);
    }
    Matrix displacement_gradient(const Vector& reference, double time) const {
        const double x = wave_number_ * reference[0], y = wave_number_ * reference[1];
        const double normal = -std::sin(x) * std::sin(y), shear = std::cos(x) * std::cos(y);
        Matrix gradient = Matrix::Zero();
        gradient.topLeftCorner<2, 2>() << normal, shear, sign_ * shear, sign_ * normal;
        return amplitude_ * wave_number_ * std::cos(frequency_ * time) * gradient;
    }

    ElasticConstants material_;
    double sign_;         ///< s: of the displacement along y against that along x
    double amplitude_;    ///< m
    double wave_number_;  ///< 1/m
    double frequency_;    ///< 1/s
};

}  // namespace matpoint

MATPOINT_PLUGIN("plate_vibration", "1.0.0") {
    registry.exact_solution<matpoint::PlateVibration>("plate_vibration");
}
