#pragma once

#include "each_once.hpp"

#include <matpoint/exact_solution.hpp>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

/// What every exact solution must satisfy. Out of tree:
///
///     Registry registry;
///     matpoint_plugin_register(registry);
///     conformance::check_exact_solution(registry, scene, {.min = {0, 0, 0}, .max = {1, 0, 0}, .end = 0.02});
///
/// with the parts of a scene that a solution knows, every parameter given: `space` with `dimension` and
/// `mode`, `materials`, `bodies` with the material of each, and `exact_solution`.
namespace matpoint::conformance {

/// Where and when a solution is looked at.
struct Samples {
    Eigen::Vector3d min, max;                              ///< of the bodies, m
    double end;                                            ///< from 0 to it, s
    std::function<bool(const Eigen::Vector3d&)> within{};  ///< the bodies; by default all between min and max
    /// A solution for infinitesimal strains: terms of second order in the strain may be missing.
    bool infinitesimal = false;
};

inline Parameters::Context context_of(const Registry& registry, const Json& scene) {
    const auto mode = scene.at("space").at("mode").get<std::string>();
    const SpaceId space{mode == "bar"            ? Mode::bar
                        : mode == "plane_strain" ? Mode::plane_strain
                        : mode == "axisymmetric" ? Mode::axisymmetric
                                                 : Mode::solid};
    return {space, ".", &registry, &scene};
}

template <class Value>
struct Derivative {
    Value value;
    double error;
};

/// At 0, by Richardson's extrapolation from central differences over h and h/2: of fourth order, and so far
/// nearer than a hundredth of what it corrects.
template <class Function>
auto derivative(const Function& f, double h) {
    using Value = decltype(f(h));
    const Value coarse = (f(h) - f(-h)) / (2 * h), fine = (f(h / 2) - f(-h / 2)) / h;
    return Derivative<Value>{(4 * fine - coarse) / 3, 0.01 * (fine - coarse).norm() / 3};
}

class ExactSolutionChecks {
  public:
    using Vector = ExactSolution::Vector;
    using Matrix = ExactSolution::Matrix;

    ExactSolutionChecks(const ExactSolution& solution, const Registry& registry, const Json& scene,
                        const Samples& samples)
        : solution_(solution),
          infinitesimal_(samples.infinitesimal),
          space_(context_of(registry, scene).space),
          body_material_(material_of(solution, scene)) {
        const auto context = context_of(registry, scene);
        material_ = elastic_constants(Parameters(scene.at("exact_solution"), context));
        const Vector size = samples.max - samples.min;
        length_ = size.head(space_.dimension()).minCoeff();
        h_ = 1e-3 * length_;
        const double c = material_.bar_speed();
        dt_ = 1e-3 * (c > 0 ? std::min(length_ / c, samples.end) : samples.end);
        phase_ = 1 + std::numbers::pi * c * samples.end / length_;
        choose_points(samples);
    }

    void all() const {
        fronts_are_few();
        velocity_is_rate_of_displacement();
        deformation_gradient_is_derivative();
        stress_follows_from_deformation();
        momentum_is_balanced();
    }

    /// Most points are where the solution is smooth and finite, and the bodies not turned inside out.
    void fronts_are_few() const {
        EXPECT_GE(points_.size(), 0.8 * drawn) << "is smooth at too few points";
        Worst worst("determinant of F");
        for (const Point& p : points_)
            worst.add(solution_.deformation_gradient(p.x, p.time).determinant() > 0 ? 0 : 2, 1, p);
        worst.report();
    }

    /// v = du/dt
    void velocity_is_rate_of_displacement() const {
        Worst worst("velocity");
        for (const Point& p : points_) {
            const auto rate =
                derivative([&](double s) { return solution_.displacement(p.x, p.time + s); }, dt_);
            const Vector v = solution_.velocity(p.x, p.time);
            worst.add((v - rate.value).norm(), rounding * phase_ * displacement_ / dt_ + rate.error, p);
        }
        worst.report();
    }

    /// F = I + du/dX, and u/R around an axis.
    void deformation_gradient_is_derivative() const {
        Worst worst("deformation gradient");
        for (const Point& p : points_) {
            Matrix expected = Matrix::Identity();
            double error = rounding * (phase_ * displacement_ + length_) / h_;
            for (int a = 0; a < space_.dimension(); ++a) {
                const auto slope =
                    along(p, a, [&](const Vector& x) { return solution_.displacement(x, p.time); });
                expected.col(a) += slope.value;
                error += slope.error;
            }
            if (axisymmetric()) expected(2, 2) += solution_.displacement(p.x, p.time)[0] / p.x[0];
            worst.add((solution_.deformation_gradient(p.x, p.time) - expected).norm(), error, p);
        }
        worst.report();
    }

    /// The material's law. Left out for materials other than the two that come with the framework.
    void stress_follows_from_deformation() const {
        const auto type = body_material_.at("type").get<std::string>();
        if (type != "neo_hookean" && type != "linear_elastic") return;
        Worst worst("stress");
        const double error = rounding * (stress_ + modulus()) + (infinitesimal_ ? 10 * quadratic() : 0);
        for (const Point& p : points_) {
            const Matrix f = solution_.deformation_gradient(p.x, p.time);
            const Matrix expected = type == "neo_hookean" ? neo_hookean(f)
                                    : body_material_.value("strain", "") == "small"
                                        ? hooke((f + f.transpose()) / 2 - one())
                                        : logarithmic(f);
            worst.add((solution_.stress(p.x, p.time) - expected).norm(), error, p);
        }
        worst.report();
    }

    /// Div P + rho_0 b = rho_0 a, P = J sigma F^-T [Wallstedt & Guilkey 2008, eq. 52].
    void momentum_is_balanced() const {
        Worst worst("momentum");
        const double rho = material_.density;
        for (const Point& p : points_) {
            const auto a = derivative([&](double s) { return solution_.velocity(p.x, p.time + s); }, dt_);
            Vector residual = rho * (solution_.body_force(p.x, p.time) - a.value);
            double error = rho * (rounding * phase_ * speed_ / dt_ + a.error);
            for (int axis = 0; axis < space_.dimension(); ++axis) {
                const auto slope =
                    along(p, axis, [&](const Vector& x) -> Vector { return nominal(x, p.time).col(axis); });
                residual += slope.value;
                error += rounding * (phase_ * stress_ + modulus()) / h_ + slope.error;
            }
            if (axisymmetric()) {
                const Matrix stress = nominal(p.x, p.time);
                residual += (stress.col(0) - stress(2, 2) * Vector::UnitX()) / p.x[0];
            }
            if (infinitesimal_) error += 10 * std::numbers::pi / length_ * quadratic();
            worst.add(residual.norm(), error, p);
        }
        worst.report();
    }

  private:
    static constexpr int drawn = 300;
    static constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();

    struct Point {
        Vector x;
        double time;
    };

    /// The point where a deviation is largest in units of what is allowed, so that a check fails once.
    class Worst {
      public:
        explicit Worst(std::string what) : what_(std::move(what)) {}
        void add(double deviation, double allowed, const Point& point) {
            const double excess = deviation / (allowed + std::numeric_limits<double>::min());
            if (excess <= excess_ || std::isnan(excess_)) return;
            excess_ = excess, deviation_ = deviation, allowed_ = allowed, point_ = point;
        }
        void report() const {
            EXPECT_LE(excess_, 1) << what_ << " is off by " << deviation_ << ", where " << allowed_
                                  << " is allowed, at X = " << point_.x.transpose()
                                  << ", t = " << point_.time;
        }

      private:
        std::string what_;
        double excess_ = 0, deviation_ = 0, allowed_ = 0;
        Point point_{Vector::Zero(), 0};
    };

    Derivative<Vector> along(const Point& p, int axis,
                             const std::function<Vector(const Vector&)>& function) const {
        return derivative([&](double s) -> Vector { return function(p.x + s * Vector::Unit(axis)); }, h_);
    }

    static Matrix one() { return Matrix::Identity(); }
    bool axisymmetric() const { return space_.mode == Mode::axisymmetric; }
    double modulus() const { return material_.lambda + 2 * material_.mu; }
    /// Bound of what is quadratic in strains: a product of strain and stress.
    double quadratic() const { return modulus() * stretch_ * stretch_; }

    Matrix nominal(const Vector& x, double time) const {
        const Matrix f = solution_.deformation_gradient(x, time);
        return f.determinant() * solution_.stress(x, time) * f.inverse().transpose();
    }

    /// [Wallstedt & Guilkey 2008, eq. 54] as the stress that eq. 55 follows from.
    Matrix neo_hookean(const Matrix& f) const {
        const Matrix inverse = f.inverse();
        const Matrix p = material_.lambda * std::log(f.determinant()) * inverse.transpose() +
                         material_.mu * (f - inverse.transpose());
        return p * f.transpose() / f.determinant();
    }
    Matrix hooke(const Matrix& strain) const {
        return material_.lambda * strain.trace() * one() + 2 * material_.mu * strain;
    }
    /// The integral of the stress rate where nothing turns; to first order in any motion.
    Matrix logarithmic(const Matrix& f) const {
        const Eigen::SelfAdjointEigenSolver<Matrix> squared(f * f.transpose());
        const Vector logarithm = squared.eigenvalues().array().log() / 2;
        return hooke(squared.eigenvectors() * logarithm.asDiagonal() * squared.eigenvectors().transpose());
    }

    static Json material_of(const ExactSolution& solution, const Json& scene) {
        const Json& body = scene.at("bodies").at(solution.bodies().front());
        return scene.at("materials").at(body.at("material").get<std::string>());
    }

    /// Random points and times at which no front crosses the differences; and how large things are.
    void choose_points(const Samples& samples) {
        std::mt19937 random{1};
        std::uniform_real_distribution<double> fraction(0, 1);
        std::vector<Point> points;
        for (int tries = 0; points.size() < drawn && tries < 100 * drawn; ++tries) {
            Point p{Vector::Zero(), dt_ + fraction(random) * (samples.end - 2 * dt_)};
            for (int a = 0; a < space_.dimension(); ++a)
                p.x[a] = samples.min[a] + h_ + fraction(random) * (samples.max[a] - samples.min[a] - 2 * h_);
            if (!samples.within || samples.within(p.x)) points.push_back(p);
        }
        for (const Point& p : points) {
            displacement_ = std::max(displacement_, solution_.displacement(p.x, p.time).norm());
            speed_ = std::max(speed_, solution_.velocity(p.x, p.time).norm());
            const Matrix f = solution_.deformation_gradient(p.x, p.time);
            gradient_ = std::max(gradient_, (f - one()).norm());
            stretch_ = std::max(stretch_, (f.transpose() * f - one()).norm() / 2);
            stress_ = std::max(stress_, nominal(p.x, p.time).norm());
        }
        std::ranges::copy_if(points, std::back_inserter(points_),
                             [&](const Point& p) { return is_smooth(p); });
    }

    /// Velocity and F change by less than a tenth of their largest values.
    bool is_smooth(const Point& p) const {
        const auto near = [&](const Vector& x, double time) {
            return (solution_.velocity(x, time) - solution_.velocity(p.x, p.time)).norm() <= 0.1 * speed_ &&
                   (solution_.deformation_gradient(x, time) - solution_.deformation_gradient(p.x, p.time))
                           .norm() <= 0.1 * gradient_;
        };
        bool smooth = near(p.x, p.time - dt_) && near(p.x, p.time + dt_);
        for (int a = 0; a < space_.dimension(); ++a)
            smooth = smooth && near(p.x - h_ * Vector::Unit(a), p.time) &&
                     near(p.x + h_ * Vector::Unit(a), p.time);
        return smooth;
    }

    const ExactSolution& solution_;
    bool infinitesimal_;
    SpaceId space_;
    Json body_material_;
    ElasticConstants material_{};
    double length_;  ///< least size of the bodies, m
    double h_, dt_;  ///< steps of differences, m and s
    double phase_;   ///< radians of a wave until the end, whose rounding counts so often
    double displacement_ = 0, speed_ = 0, stress_ = 0;  ///< largest; m, m/s, Pa
    double gradient_ = 0, stretch_ = 0;  ///< largest of F - I, and of Green's strain, which turning leaves 0
    std::vector<Point> points_;
};

/// Runs all checks.
inline void check_exact_solution(const Registry& registry, const Json& scene, const Samples& samples) {
    const Json& own = scene.at("exact_solution");
    SCOPED_TRACE(own.dump());
    const auto solution = registry.make<ExactSolution>("exact_solution", own, context_of(registry, scene));
    each_failure_once([&] { ExactSolutionChecks(*solution, registry, scene, samples).all(); });
}

}  // namespace matpoint::conformance
