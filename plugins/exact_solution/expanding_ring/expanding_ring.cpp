#include <matpoint/exact_solution.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matpoint {
namespace {

/// u(R) = T (c3 R^3 + c2 R^2 + c1 R) at T = 1 m [Wallstedt & Guilkey 2008, eq. 60, 61].
class RadialShape {
  public:
    RadialShape(double inner, double outer) {
        const double d = outer * outer * (outer - 3 * inner);
        c3_ = -2 / d;
        c2_ = 3 * (outer + inner) / d;
        c1_ = -6 * inner * outer / d;
    }

    double displacement(double r) const { return hoop(r) * r; }
    /// u / R
    double hoop(double r) const { return (c3_ * r + c2_) * r + c1_; }
    /// du/dR
    double slope(double r) const { return (3 * c3_ * r + 2 * c2_) * r + c1_; }
    /// d2u/dR2
    double curvature(double r) const { return 6 * c3_ * r + 2 * c2_; }
    /// (du/dR - u/R) / R
    double shear(double r) const { return 2 * c3_ * r + c2_; }

  private:
    double c1_, c2_, c3_;  ///< 1/m, 1/m^2, 1/m^3
};

/// Whether du/dR or u/R reaches -1 at T = -A or A, or is not a number. Both are parabolas in R.
bool turns_inside_out(const Json& own) {
    const double inner = own.at("inner_radius").get<double>(), outer = own.at("outer_radius").get<double>(),
                 amplitude = std::abs(own.at("amplitude").get<double>());
    const RadialShape shape(inner, outer);
    const double middle = (inner + outer) / 2;                               // where the slope is extreme
    const double vertex = std::clamp(0.75 * (inner + outer), inner, outer);  // where u / R is
    const bool sound =
        amplitude * std::abs(shape.slope(middle)) < 1 && amplitude * std::abs(shape.hoop(inner)) < 1 &&
        amplitude * std::abs(shape.hoop(outer)) < 1 && amplitude * std::abs(shape.hoop(vertex)) < 1;
    return !sound;
}

bool has_poissons_ratio(const Json& own, const Json& scene) {
    return std::ranges::any_of(own.at("body"), [&](const Json& body) {
        const Json& material = scene.at("bodies").at(body.get<std::string>()).at("material");
        return scene.at("materials").at(material.get<std::string>()).at("poissons_ratio") != 0;
    });
}

}  // namespace

/// A ring with free surfaces that breathes; manufactured, for large strains [Wallstedt & Guilkey 2008,
/// section 5.2].
class ExpandingRing final : public ExactSolution {
  public:
    explicit ExpandingRing(const Parameters& parameters)
        : ExactSolution(parameters),
          material_(elastic_constants(parameters)),
          shape_(parameters.number("inner_radius"), parameters.number("outer_radius")),
          amplitude_(parameters.number("amplitude")),
          frequency_(std::numbers::pi * material_.bar_speed() / parameters.number("length")) {}

    static Schema schema() {
        Schema schema(
            "Radial vibration of a ring about the origin whose surfaces are free, for Poisson's ratio 0",
            "[Wallstedt & Guilkey 2008, section 5.2]");
        schema.dimensions({2})
            .number("inner_radius",
                    {.unit = "m", .doc = "Inner radius at rest", .paper = "R_I, eq. 61", .at_least = 0})
            .number("outer_radius",
                    {.unit = "m", .doc = "Outer radius at rest", .paper = "R_0, eq. 61", .greater_than = 0})
            .number("amplitude",
                    {.unit = "m", .doc = "Largest displacement of the outer surface", .paper = "A, eq. 60"})
            .number("length", {.unit = "m",
                               .doc = "Length L in the angular frequency pi c / L",
                               .paper = "1 in eq. 60",
                               .default_value = 1.0,
                               .greater_than = 0})
            .refuse("/inner_radius", "must be less than the outer radius",
                    [](const Json& own, const Json&) {
                        return own.at("inner_radius").get<double>() >= own.at("outer_radius").get<double>();
                    })
            .refuse("/amplitude",
                    "turns the ring inside out: make it smaller, or move the outer radius away from three "
                    "times the inner one, where eq. 61 has no solution",
                    [](const Json& own, const Json&) { return turns_inside_out(own); })
            .refuse("/body", "is a solution for Poisson's ratio 0 only; that of the body's material is not",
                    has_poissons_ratio)
            .refuse("", "is no solution in an axisymmetric space", [](const Json&, const Json& scene) {
                return scene.at("space").at("mode") == "axisymmetric";
            });
        refuse_other_materials(schema, {"neo_hookean"});
        return warn_without_body_force(schema);
    }

    /// [Wallstedt & Guilkey 2008, eq. 62]
    Vector displacement(const Vector& reference, double time) const override {
        return factor(time) * shape_.displacement(radius(reference)) * outwards(reference);
    }
    Vector velocity(const Vector& reference, double time) const override {
        return -frequency_ * amplitude_ * std::sin(frequency_ * time) *
               shape_.displacement(radius(reference)) * outwards(reference);
    }
    /// Principal values 1 + du/dR outwards and 1 + u/R around.
    Matrix deformation_gradient(const Vector& reference, double time) const override {
        const double r = radius(reference);
        const Vector n = outwards(reference);
        Matrix f = Matrix::Identity();
        f.topLeftCorner<2, 2>().diagonal().array() += factor(time) * shape_.hoop(r);
        return f + factor(time) * r * shape_.shear(r) * n * n.transpose();
    }
    /// [Wallstedt & Guilkey 2008, eq. 55], lambda = 0
    Matrix stress(const Vector& reference, double time) const override {
        const double r = radius(reference), t = factor(time);
        const double radial = 1 + t * shape_.slope(r), hoop = 1 + t * shape_.hoop(r);
        const double mu = material_.mu / (radial * hoop);
        const Vector n = outwards(reference), around(-n[1], n[0], 0);
        return mu * (radial * radial - 1) * n * n.transpose() +
               mu * (hoop * hoop - 1) * around * around.transpose();
    }
    /// Along the radius, rho_0 b = rho_0 a - dP_r/dR - (P_r - P_h)/R with P = mu (F - 1/F) (README,
    /// derive.py).
    Vector body_force(const Vector& reference, double time) const override {
        const double r = radius(reference), t = factor(time);
        const double radial = 1 + t * shape_.slope(r), hoop = 1 + t * shape_.hoop(r);
        const double divergence =
            material_.mu * t *
            ((1 + 1 / (radial * radial)) * shape_.curvature(r) + (1 + 1 / (radial * hoop)) * shape_.shear(r));
        const double acceleration = -frequency_ * frequency_ * t * shape_.displacement(r);
        return (acceleration - divergence / material_.density) * outwards(reference);
    }

  private:
    static double radius(const Vector& reference) { return reference.head<2>().norm(); }
    /// Unit vector; zero in the centre, which a ring does not have.
    static Vector outwards(const Vector& reference) {
        return Vector(reference[0], reference[1], 0).normalized();
    }
    double factor(double time) const { return amplitude_ * std::cos(frequency_ * time); }

    ElasticConstants material_;
    RadialShape shape_;
    double amplitude_;  ///< m
    double frequency_;  ///< 1/s
};

}  // namespace matpoint

MATPOINT_PLUGIN("expanding_ring", "1.0.0") {
    registry.exact_solution<matpoint::ExpandingRing>("expanding_ring");
}
