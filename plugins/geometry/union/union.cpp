#include "../operands.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// All that is in any of its geometries; see README.md.
class Union final : public Geometry {
  public:
    static Schema schema() {
        return operands_schema("What is in any of some geometries", "The geometries to join");
    }
    explicit Union(const Parameters& parameters) : of_(make_operands(parameters)) {}

    Bounds bounds() const override {
        Bounds all = of_[0].bounds();
        for (const Operand& geometry : of_) {
            all.min = all.min.cwiseMin(geometry.bounds().min);
            all.max = all.max.cwiseMax(geometry.bounds().max);
        }
        return all;
    }

    bool contains(const Eigen::Vector3d& point) const override {
        for (const Operand& geometry : of_)
            if (geometry.contains(point)) return true;
        return false;
    }

    std::vector<char> contains(std::span<const Eigen::Vector3d> points) const override {
        std::vector<char> inside(points.size(), 0);
        for (const Operand& geometry : of_) {
            const std::vector<char> in_one = geometry.contains(points);
            for (std::size_t i = 0; i < points.size(); ++i) inside[i] = inside[i] || in_one[i];
        }
        return inside;
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval within,
                                   double step) const override {
        return combine_along_x(of_, lines, within, step, [](const Intervals& a, const Intervals& b) {
            return complement(common(complement(a), complement(b)));
        });
    }

    std::vector<double> breaks(int axis) const override { return breaks_of(of_, axis); }

    Eigen::Vector3d anchor() const override {
        return bounds().min.allFinite() && bounds().max.allFinite() ? Geometry::anchor() : of_[0].anchor();
    }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        SignedDistance least = of_[0].signed_distance(point);
        for (std::size_t g = 1; g < of_.size(); ++g)
            least = std::min(least, of_[g].signed_distance(point), by_distance);
        return least;
    }

  private:
    std::vector<Operand> of_;
};

MATPOINT_PLUGIN("union", "1.0.0") {
    registry.geometry<Union>("union");
}
