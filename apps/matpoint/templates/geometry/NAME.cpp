#include <matpoint/geometry.hpp>
#include <matpoint/plugin.hpp>

#include <cmath>

using namespace matpoint;

/// An ellipsoid (an ellipse in 2D) along the axes; see README.md.
class {{Name}} final : public Geometry {
  public:
    static Schema schema() {
        return Schema("Ellipsoid along the axes")
            .vector("center", {.unit = "m", .doc = "Its centre"})
            .vector("half_axes", {.unit = "m", .doc = "Half-lengths of its axes"})
            .refuse("/half_axes", "every half-axis must be greater than 0", [](const Json& own, const Json&) {
                for (const Json& length : own.at("half_axes"))
                    if (length.get<double>() <= 0) return true;
                return false;
            });
    }
    explicit {{Name}}(const Parameters& parameters)
        : center_(Eigen::Vector3d::Map(parameters.vector("center").data())),
          half_axes_(Eigen::Vector3d::Map(parameters.vector("half_axes").data())) {}

    Bounds bounds() const override { return {center_ - half_axes_, center_ + half_axes_}; }

    /// Axes that the space lacks have length zero and do not count.
    bool contains(const Eigen::Vector3d& point) const override {
        double sum = 0;
        for (int a = 0; a < 3; ++a)
            if (half_axes_[a] > 0) sum += std::pow((point[a] - center_[a]) / half_axes_[a], 2);
        return sum <= 1;
    }

  private:
    Eigen::Vector3d center_, half_axes_;  // m
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.geometry<{{Name}}>("{{name}}"); }
