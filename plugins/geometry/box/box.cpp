#include "../box_distance.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// A box along the axes; see README.md.
class Box final : public Geometry {
  public:
    static Schema schema() {
        return Schema("Box along the axes: a rectangle in 2D, an interval in 1D")
            .vector("min", {.unit = "m", .doc = "Corner with the smallest coordinates"})
            .vector("max", {.unit = "m", .doc = "Corner with the largest coordinates"})
            .refuse("/max", "every coordinate of \"max\" must be greater than that of \"min\"",
                    [](const Json& own, const Json&) {
                        for (std::size_t a = 0; a < own.at("min").size(); ++a)
                            if (!(own.at("max").at(a).get<double>() > own.at("min").at(a).get<double>()))
                                return true;
                        return false;
                    });
    }
    explicit Box(const Parameters& parameters)
        : dimension_(parameters.context().space.dimension()),
          min_(Eigen::Vector3d::Map(parameters.vector("min").data())),
          max_(Eigen::Vector3d::Map(parameters.vector("max").data())) {}

    Bounds bounds() const override { return {min_, max_}; }

    /// Half open, so that of two boxes that share a face only one has a point on it.
    bool contains(const Eigen::Vector3d& point) const override {
        for (int a = 0; a < dimension_; ++a)
            if (point[a] < min_[a] || point[a] >= max_[a]) return false;
        return true;
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (contains({min_[0], lines[i][0], lines[i][1]})) found[i] = {{min_[0], max_[0]}};
        return found;
    }

    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        return box_distance(point, min_, max_, dimension_);
    }

  private:
    int dimension_;
    Eigen::Vector3d min_, max_;  // m
};

MATPOINT_PLUGIN("box", "1.0.0") {
    registry.geometry<Box>("box");
}
