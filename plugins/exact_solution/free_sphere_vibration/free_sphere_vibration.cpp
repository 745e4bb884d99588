#include "../free_vibration.hpp"

#include <matpoint/plugin.hpp>

namespace matpoint {
namespace {

bool nonzero(const Json& own, const char* name) {
    return own.contains(name) && own.at(name).at(0) != 0;
}

}  // namespace

/// A ball with a free surface in its lowest radial or torsional mode; see README.md.
class FreeSphereVibration final : public FreeVibration {
  public:
    explicit FreeSphereVibration(const Parameters& parameters)
        : FreeVibration(parameters), torsional_(parameters.text("mode") == "torsional") {
        if (torsional_) {
            set_frequency(bisect(torsional_traction, 0, 4), elastic().mu);
            scale_ = 2 / (radius() * radius() * bessel_series(2.5, wave_number() * radius()));
        } else {
            mode_ = RadialMode(dimension(), radius(), elastic());
            set_frequency(mode_.root(), elastic().lambda + 2 * elastic().mu);
        }
    }

    static Schema schema() {
        Schema schema("Small vibration of a ball whose surface is free, at rest or in flight", "[Lamb 1882]");
        schema.dimensions({2, 3})
            .choice("mode",
                    {.doc = "radial: in and out; torsional: its halves turn against each other about z",
                     .default_value = "radial",
                     .choices = {"radial", "torsional"}})
            .refuse(
                "", "is a solution in 3D and in an axisymmetric space; in the plane take free_disk_vibration",
                [](const Json&, const Json& scene) { return scene.at("space").at("mode") == "plane_strain"; })
            .refuse("/mode", "torsional needs 3D: nothing moves around the axis of an axisymmetric space",
                    [](const Json& own, const Json& scene) {
                        return own.at("mode") == "torsional" &&
                               scene.at("space").at("mode") == "axisymmetric";
                    })
            .refuse("/center", "must be on the axis x = 0 of an axisymmetric space",
                    [](const Json& own, const Json& scene) {
                        return scene.at("space").at("mode") == "axisymmetric" && nonzero(own, "center");
                    })
            .refuse("/drift", "must be along the axis y of an axisymmetric space",
                    [](const Json& own, const Json& scene) {
                        return scene.at("space").at("mode") == "axisymmetric" && nonzero(own, "drift");
                    });
        return add_free_vibration(schema);
    }

  private:
    /// r d/dr (U/r), but for a positive factor, of U = L_{5/2}(kr) z (-y, x, 0).
    static double torsional_traction(double x) {
        return bessel_series(2.5, x) - x * x / 7 * bessel_series(3.5, x);
    }

    Vector shape(const Vector& x) const override {
        if (!torsional_) return mode_.shape(x);
        return scale_ * bessel_series(2.5, wave_number() * x.norm()) * x[2] * around(x);
    }
    Matrix shape_gradient(const Vector& x) const override {
        if (!torsional_) return mode_.gradient(x);
        const double argument = wave_number() * x.norm();
        const double value = bessel_series(2.5, argument);
        Matrix gradient = -wave_number() * wave_number() / 7 * bessel_series(3.5, argument) * x[2] *
                          around(x) * x.transpose();
        gradient.col(2) += value * around(x);
        gradient(0, 1) -= value * x[2];
        gradient(1, 0) += value * x[2];
        return scale_ * gradient;
    }
    static Vector around(const Vector& x) { return {-x[1], x[0], 0}; }

    bool torsional_;
    RadialMode mode_;
    double scale_ = 0;  ///< 1/m^2
};

}  // namespace matpoint

MATPOINT_PLUGIN("free_sphere_vibration", "1.0.0") {
    registry.exact_solution<matpoint::FreeSphereVibration>("free_sphere_vibration");
}
