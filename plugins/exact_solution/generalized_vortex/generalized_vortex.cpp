#include <matpoint/exact_solution.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>
#include <numbers>

namespace matpoint {

/// A ring whose circles turn by angles of their own, at rest on its surfaces; manufactured, for large shear
/// [Kamojjala, Brannon, Sadeghirad & Guilkey 2015, section 6].
class GeneralizedVortex final : public ExactSolution {
  public:
    explicit GeneralizedVortex(const Parameters& parameters)
        : ExactSolution(parameters),
          material_(elastic_constants(parameters)),
          middle_((parameters.number("outer_radius") + parameters.number("inner_radius")) / 2),
          half_width_((parameters.number("outer_radius") - parameters.number("inner_radius")) / 2),
          amplitude_(parameters.number("amplitude")),
          frequency_(std::numbers::pi * parameters.number("rate")) {}

    static Schema schema() {
        Schema schema("Circles of a ring about the origin turn to and fro, those in its middle most",
                      "[Kamojjala et al. 2015]");
        schema.dimensions({2})
            .number("inner_radius", {.unit = "m", .doc = "Inner radius", .paper = "0.75", .at_least = 0})
            .number("outer_radius", {.unit = "m", .doc = "Outer radius", .paper = "1.25", .greater_than = 0})
            .number("amplitude", {.doc = "Largest angle of the middle circle, radians", .paper = "A"})
            .number("rate", {.unit = "1/s",
                             .doc = "c in the angle A sin(c pi t): it is back after 1/c",
                             .paper = "c",
                             .greater_than = 0})
            .refuse("/inner_radius", "must be less than the outer radius",
                    [](const Json& own, const Json&) {
                        return own.at("inner_radius").get<double>() >= own.at("outer_radius").get<double>();
                    })
            .refuse("", "is no solution in an axisymmetric space", [](const Json&, const Json& scene) {
                return scene.at("space").at("mode") == "axisymmetric";
            });
        refuse_other_materials(schema, {"neo_hookean"});
        return warn_without_body_force(schema);
    }

    /// x = Q(alpha) X
    Vector displacement(const Vector& reference, double time) const override {
        return turned(reference, time) - reference;
    }
    Vector velocity(const Vector& reference, double time) const override {
        const Vector x = turned(reference, time);
        return at(x, time).rate * Vector(-x[1], x[0], 0);
    }
    /// F = Q (I + gamma e_Theta e_R), gamma = R dalpha/dR
    Matrix deformation_gradient(const Vector& reference, double time) const override {
        const Angle angle = at(reference, time);
        const double cosine = std::cos(angle.value), sine = std::sin(angle.value);
        const double radius = reference.head<2>().norm();
        const Vector out(reference[0] / radius, reference[1] / radius, 0), around(-out[1], out[0], 0);
        Matrix turn;
        turn << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
        return turn * (Matrix::Identity() + angle.shear * around * out.transpose());
    }
    /// mu (B - I), as J = 1.
    Matrix stress(const Vector& reference, double time) const override {
        const Matrix f = deformation_gradient(reference, time);
        return material_.mu * (f * f.transpose() - Matrix::Identity());
    }
    /// From the balance of momentum in the present radius and around, with sigma_r = 0, sigma_rt = mu gamma,
    /// sigma_t = mu gamma^2 (README).
    Vector body_force(const Vector& reference, double time) const override {
        const Angle angle = at(reference, time);
        const double radius = reference.head<2>().norm(), stiffness = material_.mu / material_.density;
        const Vector x = turned(reference, time) / radius;
        const double outwards =
            stiffness * angle.shear * angle.shear / radius - radius * angle.rate * angle.rate;
        const double around =
            radius * angle.acceleration - stiffness * (angle.shear_slope + 2 * angle.shear / radius);
        return outwards * x + around * Vector(-x[1], x[0], 0);
    }

  private:
    struct Angle {
        double value, rate, acceleration;  ///< 1, 1/s, 1/s^2
        double shear, shear_slope;         ///< R dalpha/dR, and its derivative, 1/m
    };

    /// alpha = A sin(c pi t) (1 - s^2)^2, s = (R - R_m) / half of the width: with radii 0.75 and 1.25
    /// 1 - 32 (R - 1)^2 + 256 (R - 1)^4.
    Angle at(const Vector& place, double time) const {
        const double radius = place.head<2>().norm(), s = (radius - middle_) / half_width_;
        const double shape = (1 - s * s) * (1 - s * s), slope = -4 * s * (1 - s * s) / half_width_,
                     curvature = (12 * s * s - 4) / (half_width_ * half_width_);
        const double sine = amplitude_ * std::sin(frequency_ * time),
                     cosine = amplitude_ * frequency_ * std::cos(frequency_ * time);
        return {sine * shape, cosine * shape, -frequency_ * frequency_ * sine * shape, sine * radius * slope,
                sine * (slope + radius * curvature)};
    }

    Vector turned(const Vector& reference, double time) const {
        const double angle = at(reference, time).value, cosine = std::cos(angle), sine = std::sin(angle);
        return {cosine * reference[0] - sine * reference[1], sine * reference[0] + cosine * reference[1], 0};
    }

    ElasticConstants material_;
    double middle_, half_width_;  ///< m
    double amplitude_;            ///< radians
    double frequency_;            ///< 1/s
};

}  // namespace matpoint

MATPOINT_PLUGIN("generalized_vortex", "1.0.0") {
    registry.exact_solution<matpoint::GeneralizedVortex>("generalized_vortex");
}
