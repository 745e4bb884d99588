#pragma once

#include "ball.hpp"

#include <cmath>
#include <numbers>

namespace matpoint {

/// L_n(x) = Gamma(n + 1) J_n(x) / (x/2)^n, by its power series: L_n(0) = 1, L_n' = -x L_{n+1} / (2 (n + 1)).
/// Spherical Bessel functions are those of half-integer n: j_1(x) = x L_{3/2}(x) / 3 [Abramowitz & Stegun
/// 1964, 9.1.10, 10.1.1].
inline double bessel_series(double n, double x) {
    double term = 1, sum = 1;
    for (int k = 1; std::abs(term) > 1e-17 * std::abs(sum) || k < x; ++k) {
        term *= -x * x / (4 * k * (n + k));
        sum += term;
    }
    return sum;
}

/// Where a function that is positive at `low` and not at `high` changes its sign.
template <class Function>
double bisect(const Function& function, double low, double high) {
    for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
        (function(middle) > 0 ? low : high) = middle;
    return high;
}

/// A ball (a disk in the plane) with a free surface in one of its modes, for small strains:
/// u = A U(X - X_0) sin(w t) + V t, where the largest displacement U of the surface is 1.
class FreeVibration : public ExactSolution {
  public:
    explicit FreeVibration(const Parameters& parameters)
        : ExactSolution(parameters),
          elastic_(elastic_constants(parameters)),
          dimension_(parameters.context().space.mode == Mode::plane_strain ? 2 : 3),
          radius_(parameters.number("radius")),
          amplitude_(parameters.number("amplitude")) {
        if (parameters.has("center")) center_ = Vector::Map(parameters.vector("center").data());
        if (parameters.has("drift")) drift_ = Vector::Map(parameters.vector("drift").data());
    }

    Vector displacement(const Vector& reference, double time) const final {
        return amplitude_ * std::sin(frequency_ * time) * shape(reference - center_) + time * drift_;
    }
    Vector velocity(const Vector& reference, double time) const final {
        return amplitude_ * frequency_ * std::cos(frequency_ * time) * shape(reference - center_) + drift_;
    }
    Matrix deformation_gradient(const Vector& reference, double time) const final {
        return Matrix::Identity() + displacement_gradient(reference, time);
    }
    /// Hooke's law.
    Matrix stress(const Vector& reference, double time) const final {
        const Matrix gradient = displacement_gradient(reference, time);
        return elastic_.lambda * gradient.trace() * Matrix::Identity() +
               elastic_.mu * (gradient + gradient.transpose());
    }

  protected:
    /// U and its gradient at x = X - X_0.
    virtual Vector shape(const Vector& x) const = 0;
    virtual Matrix shape_gradient(const Vector& x) const = 0;

    /// Sets w by kR and the modulus rho c^2 (Pa) of the waves that the mode is made of.
    void set_frequency(double root, double modulus) {
        wave_number_ = root / radius_;
        frequency_ = wave_number_ * std::sqrt(modulus / elastic_.density);
    }
    const ElasticConstants& elastic() const { return elastic_; }
    int dimension() const { return dimension_; }         ///< of the ball: 3 in an axisymmetric space
    double radius() const { return radius_; }            // m
    double wave_number() const { return wave_number_; }  // 1/m

  private:
    Matrix displacement_gradient(const Vector& reference, double time) const {
        return amplitude_ * std::sin(frequency_ * time) * shape_gradient(reference - center_);
    }

    ElasticConstants elastic_;
    int dimension_;
    double radius_;                   ///< m
    double amplitude_;                ///< A, m
    Vector center_ = Vector::Zero();  ///< X_0, m
    Vector drift_ = Vector::Zero();   ///< V, m/s
    double wave_number_ = 0;          ///< k, 1/m
    double frequency_ = 0;            ///< w, 1/s
};

/// The lowest radial mode, of longitudinal waves: U = X L_n(kr) / (R L_n(kR)) with n = d/2 in d dimensions.
class RadialMode {
  public:
    RadialMode() = default;
    RadialMode(int dimension, double radius, const ElasticConstants& elastic)
        : dimension_(dimension), order_(dimension / 2.0) {
        root_ = bisect([&](double x) { return traction(x, elastic); }, 0, first_zero_of_the_rest());
        wave_number_ = root_ / radius;
        scale_ = 1 / (radius * bessel_series(order_, root_));
    }
    double root() const { return root_; }

    ExactSolution::Vector shape(const ExactSolution::Vector& x) const {
        return scale_ * bessel_series(order_, wave_number_ * x.norm()) * x;
    }
    ExactSolution::Matrix gradient(const ExactSolution::Vector& x) const {
        ExactSolution::Matrix one = ExactSolution::Matrix::Identity();
        if (dimension_ == 2) one(2, 2) = 0;
        const double argument = wave_number_ * x.norm();
        return scale_ * (bessel_series(order_, argument) * one -
                         wave_number_ * wave_number_ / (2 * order_ + 2) *
                             bessel_series(order_ + 1, argument) * x * x.transpose());
    }

  private:
    /// (lambda + 2 mu) dU/dr + (d - 1) lambda U/r, but for a positive factor.
    double traction(double x, const ElasticConstants& elastic) const {
        const double hoop = bessel_series(order_, x);
        const double slope = hoop - x * x / (2 * order_ + 2) * bessel_series(order_ + 1, x);
        return (elastic.lambda + 2 * elastic.mu) * slope + (dimension_ - 1) * elastic.lambda * hoop;
    }
    /// Of div U, L_{n-1}: J_0, or sin(x)/x. There the traction is -2 (d - 1) mu U/r.
    double first_zero_of_the_rest() const { return dimension_ == 2 ? 2.404825557695773 : std::numbers::pi; }

    int dimension_ = 0;
    double order_ = 0;        ///< n
    double root_ = 0;         ///< kR
    double wave_number_ = 0;  ///< k, 1/m
    double scale_ = 0;        ///< 1/m
};

/// Parameters and rules of all of them.
inline Schema& add_free_vibration(Schema& schema) {
    add_ball(schema)
        .number("amplitude",
                {.unit = "m", .doc = "Largest displacement A of the surface; small against `radius`"})
        .vector("drift", {.unit = "m/s",
                          .doc = "Velocity V with which the body flies meanwhile; without it none",
                          .optional = true})
        .warn("/amplitude", "is more than 1 % of `radius`: this is a solution for small strains",
              [](const Json& own, const Json&) {
                  return std::abs(own.at("amplitude").get<double>()) > 0.01 * own.at("radius").get<double>();
              });
    return refuse_other_materials(schema, {"linear_elastic", "neo_hookean"});
}

}  // namespace matpoint
