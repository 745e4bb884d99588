#pragma once

#include <matpoint/exact_solution.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace matpoint {

/// What a bar does at a point X at a time.
struct BarMotion {
    double displacement;  ///< m
    double velocity;      ///< m/s
    double strain;        ///< du/dX
};

/// Solution of the wave equation u_tt = c^2 u_XX of a bar along x with sigma = E (F - 1), c = sqrt(E / rho).
class BarSolution : public ExactSolution {
  public:
    explicit BarSolution(const Parameters& parameters)
        : ExactSolution(parameters), elastic_(elastic_constants(parameters)) {}

    virtual BarMotion motion(double x, double time) const = 0;

    Vector displacement(const Vector& reference, double time) const final {
        return {motion(reference[0], time).displacement, 0, 0};
    }
    Vector velocity(const Vector& reference, double time) const final {
        return {motion(reference[0], time).velocity, 0, 0};
    }
    Matrix deformation_gradient(const Vector& reference, double time) const final {
        Matrix f = Matrix::Identity();
        f(0, 0) += motion(reference[0], time).strain;
        return f;
    }
    Matrix stress(const Vector& reference, double time) const final {
        Matrix stress = Matrix::Zero();
        stress(0, 0) = elastic_.youngs_modulus * motion(reference[0], time).strain;
        return stress;
    }

  protected:
    double youngs_modulus() const { return elastic_.youngs_modulus; }  // Pa
    double wave_speed() const { return elastic_.bar_speed(); }         // m/s

  private:
    ElasticConstants elastic_;
};

/// |s| for |s| <= 2 L, continued with the period 4 L: what starts linear in a bar of length L, held at one
/// end and free at the other, goes on by reflection as a triangle wave.
class TriangleWave {
  public:
    explicit TriangleWave(double length) : period_(4 * length) {}
    double operator()(double s) const { return std::abs(std::remainder(s, period_)); }
    double slope(double s) const {
        const double r = std::remainder(s, period_);
        return (r > 0 ? 1 : 0) - (r < 0 ? 1 : 0);
    }

  private:
    double period_;  ///< m
};

/// The bar on [0, L] that flies with velocity v (m/s) until its end x = 0 is stopped at time 0, by
/// d'Alembert's formula: u = (v / 2 c) (T(x + c t) - T(x - c t)).
inline BarMotion stopped_bar(double length, double v, double c, double x, double time) {
    const TriangleWave wave(length);
    const double ahead = x + c * time, behind = x - c * time;
    return {v / (2 * c) * (wave(ahead) - wave(behind)), v / 2 * (wave.slope(ahead) + wave.slope(behind)),
            v / (2 * c) * (wave.slope(ahead) - wave.slope(behind))};
}

/// What all solutions for bars ask of a scene.
inline Schema& bar_rules(Schema& schema) {
    schema.dimensions({1});
    refuse_other_materials(schema, {"linear_elastic"});
    return schema.warn("/body", "is exact for a material with \"strain\": \"small\", sigma = E (F - 1), only",
                       [](const Json& own, const Json& scene) {
                           return std::ranges::any_of(own.at("body"), [&](const Json& name) {
                               const Json& body = scene.at("bodies").at(name.get<std::string>());
                               const Json& material =
                                   scene.at("materials").at(body.at("material").get<std::string>());
                               return material.value("strain", "") != "small";
                           });
                       });
}

/// Warns of bodies that don't lie where the solution has its bar. Only geometries with `min` and `max` say
/// where that is; `wrong` gets these, m.
inline Schema& warn_of_extent(Schema& schema, std::string reason,
                              std::function<bool(const Json& own, double min, double max)> wrong) {
    return schema.warn("/body", std::move(reason), [=](const Json& own, const Json& scene) {
        return std::ranges::any_of(own.at("body"), [&](const Json& name) {
            const Json& geometry = scene.at("bodies").at(name.get<std::string>()).at("geometry");
            return geometry.contains("min") && geometry.contains("max") &&
                   wrong(own, geometry.at("min").at(0).get<double>(), geometry.at("max").at(0).get<double>());
        });
    });
}

/// Declares `length`: the bar is on [0, length].
inline Schema& add_bar_length(Schema& schema) {
    schema.number("length", {.unit = "m",
                             .doc = "Length of the bar, which lies on [0, length]",
                             .paper = "L",
                             .default_value = 1.0,
                             .greater_than = 0});
    return warn_of_extent(schema, "the bar of the solution lies on [0, length], and the body elsewhere",
                          [](const Json& own, double min, double max) {
                              const double length = own.at("length").get<double>(), slack = 1e-9 * length;
                              return std::abs(min) > slack || std::abs(max - length) > slack;
                          });
}

}  // namespace matpoint
