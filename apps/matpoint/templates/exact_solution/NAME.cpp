#include <matpoint/exact_solution.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>
#include <numbers>

using namespace matpoint;

/// A bar that is fixed at X = 0 and breathes, large strains allowed; see README.md.
class {{Name}} final : public ExactSolution {
  public:
    static Schema schema() {
        Schema schema("Bar, fixed at one end, that breathes under a manufactured body force");
        schema.dimensions({1})
            .number("amplitude", {.unit = "m", .doc = "A, largest displacement of the free end"})
            .number("length", {.unit = "m", .doc = "L: the bar is on [0, L]", .default_value = 1.0, .greater_than = 0})
            .number("period", {.unit = "s", .doc = "T", .greater_than = 0})
            .refuse("/amplitude", "turns the bar inside out: it must be less than half the length",
                    [](const Json& own, const Json&) {
                        return 2 * std::abs(own.at("amplitude").get<double>()) >= own.at("length").get<double>();
                    });
        refuse_other_materials(schema, {"neo_hookean"});
        return warn_without_body_force(schema);
    }

    explicit {{Name}}(const Parameters& parameters)
        : ExactSolution(parameters),
          material_(elastic_constants(parameters)),
          A_(parameters.number("amplitude")),
          L_(parameters.number("length")),
          omega_(2 * std::numbers::pi / parameters.number("period")) {}

    Vector displacement(const Vector& X, double t) const override {
        return {A_ * shape(X) * std::cos(omega_ * t), 0, 0};
    }
    Vector velocity(const Vector& X, double t) const override {
        return {-omega_ * A_ * shape(X) * std::sin(omega_ * t), 0, 0};
    }
    Matrix deformation_gradient(const Vector& X, double t) const override {
        return Vector(stretch(X, t), 1, 1).asDiagonal();
    }
    /// The material's law
    Matrix stress(const Vector& X, double t) const override {
        const double F = stretch(X, t);
        return Vector(material_.mu * (F - 1 / F), 0, 0).asDiagonal();
    }
    /// b = a - P' / rho
    Vector body_force(const Vector& X, double t) const override {
        const double F = stretch(X, t);
        const double curvature = -2 * A_ / (L_ * L_) * std::cos(omega_ * t);  // u'', 1/m
        const double acceleration = -omega_ * omega_ * displacement(X, t)[0];
        return {acceleration - material_.mu / material_.density * (1 + 1 / (F * F)) * curvature, 0, 0};
    }

  private:
    double shape(const Vector& X) const { return X[0] / L_ * (2 - X[0] / L_); }
    double stretch(const Vector& X, double t) const {
        return 1 + 2 * A_ / L_ * (1 - X[0] / L_) * std::cos(omega_ * t);
    }

    ElasticConstants material_;  // mu = E/2 in a bar
    double A_, L_, omega_;       // m, m, 1/s
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.exact_solution<{{Name}}>("{{name}}"); }
