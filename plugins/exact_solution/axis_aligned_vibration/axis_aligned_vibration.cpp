#include <matpoint/exact_solution.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>
#include <numbers>

namespace matpoint {

/// Every coordinate vibrates by itself; manufactured, for large strains [Wallstedt & Guilkey 2008,
/// section 5.1].
class AxisAlignedVibration final : public ExactSolution {
  public:
    explicit AxisAlignedVibration(const Parameters& parameters)
        : ExactSolution(parameters),
          dimension_(parameters.context().space.dimension()),
          material_(elastic_constants(parameters)),
          amplitude_(parameters.number("amplitude")),
          wave_number_(std::numbers::pi / parameters.number("length")),
          frequency_(wave_number_ * material_.bar_speed()) {}

    static Schema schema() {
        Schema schema(
            "Vibration of a bar, square or cube along its axes, u_i = A sin(pi X_i / L) cos(c pi t / L + "
            "phase)",
            "[Wallstedt & Guilkey 2008, section 5.1]");
        schema
            .number("amplitude",
                    {.unit = "m", .doc = "Largest displacement along an axis", .paper = "A, eq. 56"})
            .number("length", {.unit = "m",
                               .doc = "Side L of the body, which begins at the origin",
                               .paper = "1 in eq. 56",
                               .default_value = 1.0,
                               .greater_than = 0})
            .refuse("/amplitude", "turns the body inside out: its size must be less than length / pi",
                    [](const Json& own, const Json&) {
                        return std::abs(own.at("amplitude").get<double>()) * std::numbers::pi >=
                               own.at("length").get<double>();
                    })
            .refuse("", "is no solution in an axisymmetric space", [](const Json&, const Json& scene) {
                return scene.at("space").at("mode") == "axisymmetric";
            });
        refuse_other_materials(schema, {"neo_hookean"});
        return warn_without_body_force(schema);
    }

    /// [Wallstedt & Guilkey 2008, eq. 56]
    Vector displacement(const Vector& reference, double time) const override {
        Vector u = Vector::Zero();
        for (int a = 0; a < dimension_; ++a) u[a] = shape(reference[a]) * std::cos(angle(a, time));
        return u;
    }
    Vector velocity(const Vector& reference, double time) const override {
        Vector v = Vector::Zero();
        for (int a = 0; a < dimension_; ++a)
            v[a] = -frequency_ * shape(reference[a]) * std::sin(angle(a, time));
        return v;
    }
    Matrix deformation_gradient(const Vector& reference, double time) const override {
        return stretches(reference, time).asDiagonal();
    }
    /// [Wallstedt & Guilkey 2008, eq. 55]
    Matrix stress(const Vector& reference, double time) const override {
        const Vector f = stretches(reference, time);
        const double j = f.prod();
        const Vector sigma = (material_.lambda * std::log(j) + material_.mu * (f.array().square() - 1)) / j;
        return sigma.asDiagonal();
    }
    /// [Wallstedt & Guilkey 2008, eq. 59]
    Vector body_force(const Vector& reference, double time) const override {
        const Vector f = stretches(reference, time), u = displacement(reference, time);
        const double log_j = std::log(f.prod());
        Vector b = Vector::Zero();
        for (int a = 0; a < dimension_; ++a) {
            const double square = f[a] * f[a];
            b[a] = wave_number_ * wave_number_ * u[a] / material_.density *
                   (material_.lambda * (1 - log_j) / square + material_.mu * (1 + 1 / square) -
                    material_.youngs_modulus);
        }
        return b;
    }

  private:
    double shape(double x) const { return amplitude_ * std::sin(wave_number_ * x); }
    /// The paper's cos for x and sin for y; z lies between them.
    double angle(int axis, double time) const {
        constexpr double phases[] = {0, -std::numbers::pi / 2, -std::numbers::pi / 4};
        return frequency_ * time + phases[axis];
    }
    /// The diagonal of F [Wallstedt & Guilkey 2008, eq. 57].
    Vector stretches(const Vector& reference, double time) const {
        Vector f = Vector::Ones();
        for (int a = 0; a < dimension_; ++a)
            f[a] +=
                amplitude_ * wave_number_ * std::cos(wave_number_ * reference[a]) * std::cos(angle(a, time));
        return f;
    }

    int dimension_;
    ElasticConstants material_;
    double amplitude_;    ///< m
    double wave_number_;  ///< 1/m
    double frequency_;    ///< 1/s
};

}  // namespace matpoint

MATPOINT_PLUGIN("axis_aligned_vibration", "1.0.0") {
    registry.exact_solution<matpoint::AxisAlignedVibration>("axis_aligned_vibration");
}
