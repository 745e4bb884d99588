#include "../operands.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// The first of its geometries without the others; see README.md.
class Difference final : public Geometry {
  public:
    static Schema schema() {
        return operands_schema("The first of some geometries without the others",
                               "The geometry to keep, then those to cut out of it");
    }
    explicit Difference(const Parameters& parameters) : of_(make_operands(parameters)) {}

    Bounds bounds() const override { return of_[0].bounds(); }

    bool contains(const Eigen::Vector3d& point) const override {
        if (!of_[0].contains(point)) return false;
        for (std::size_t g = 1; g < of_.size(); ++g)
            if (of_[g].contains(point)) return false;
        return true;
    }

    std::vector<char> contains(std::span<const Eigen::Vector3d> points) const override {
        std::vector<char> inside = of_[0].contains(points);
        for (std::size_t g = 1; g < of_.size(); ++g) {
            const std::vector<char> cut = of_[g].contains(points);
            for (std::size_t i = 0; i < points.size(); ++i) inside[i] = inside[i] && !cut[i];
        }
        return inside;
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval within,
                                   double step) const override {
        return combine_along_x(of_, lines, within, step, [](const Intervals& a, const Intervals& b) {
            return common(a, complement(b));
        });
    }

    std::vector<double> breaks(int axis) const override { return breaks_of(of_, axis); }

    Eigen::Vector3d anchor() const override {
        return bounds().min.allFinite() && bounds().max.allFinite() ? Geometry::anchor() : of_[0].anchor();
    }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        SignedDistance most = of_[0].signed_distance(point);
        for (std::size_t g = 1; g < of_.size(); ++g) {
            const auto [distance, normal] = of_[g].signed_distance(point);
            most = std::max(most, {-distance, -normal}, by_distance);
        }
        return most;
    }

  private:
    std::vector<Operand> of_;
};

MATPOINT_PLUGIN("difference", "1.0.0") {
    registry.geometry<Difference>("difference");
}
