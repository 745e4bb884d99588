#include "../box_distance.hpp"
#include "../plane_polygon.hpp"

#include <matpoint/plugin.hpp>

using namespace matpoint;

/// A polygon, drawn along an axis; see README.md.
class Extrusion final : public Geometry {
  public:
    static Schema schema() {
        Schema schema("A plane polygon, drawn along an axis from one coordinate to another");
        declare_vertices(schema,
                         "Corners in their order around the section, either way: coordinates along the "
                         "other two axes, [y, z], [x, z] or [x, y]");
        return schema.choice("axis", {.doc = "Axis along which it is drawn", .choices = {"x", "y", "z"}})
            .number("from", {.unit = "m", .doc = "Coordinate along the axis where it begins"})
            .number("to", {.unit = "m", .doc = "Coordinate along the axis where it ends"})
            .dimensions({3})
            .refuse("/to", "\"to\" must be greater than \"from\"", [](const Json& own, const Json&) {
                return !(own.at("to").get<double>() > own.at("from").get<double>());
            });
    }
    explicit Extrusion(const Parameters& parameters)
        : section_(parameters.json().at("vertices")),
          axis_(parameters.text("axis")[0] - 'x'),
          u_(axis_ == 0 ? 1 : 0),
          v_(axis_ == 2 ? 1 : 2),
          from_(parameters.number("from")),
          to_(parameters.number("to")) {}

    Bounds bounds() const override {
        return {place(from_, section_.min()[0], section_.min()[1]),
                place(to_, section_.max()[0], section_.max()[1])};
    }

    /// Half open along the axis too.
    bool contains(const Eigen::Vector3d& point) const override {
        return is_between(point[axis_]) && section_.contains(point[u_], point[v_]);
    }

    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto [y, z] = std::pair(lines[i][0], lines[i][1]);
            if (axis_ == 0) {
                if (section_.contains(y, z)) found[i] = {{from_, to_}};
            } else if (is_between(axis_ == 1 ? y : z)) {
                found[i] = section_.along_u(axis_ == 1 ? z : y);
            }
        }
        return found;
    }

    /// Between corners a section's length along x is linear; across a line along x it is all or nothing, and
    /// all that can be told are flat faces.
    std::vector<double> breaks(int axis) const override {
        if (axis == axis_) return {from_, to_};
        const int of_section = axis == u_ ? 0 : 1;
        return axis_ == 0 ? section_.flat_edges(of_section) : section_.corners(of_section);
    }

    /// Over the distance from its section and the coordinate along the axis it is a half strip.
    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        const auto [from_section, across] = section_.signed_distance({point[u_], point[v_]});
        const auto [distance, normal] =
            box_distance({from_section, point[axis_], 0},
                         {-std::numeric_limits<double>::infinity(), from_, 0}, {0, to_, 0}, 2);
        return {distance, place(normal[1], normal[0] * across[0], normal[0] * across[1])};
    }

  private:
    bool is_between(double along) const { return along >= from_ && along < to_; }
    Eigen::Vector3d place(double along, double u, double v) const {
        Eigen::Vector3d point;
        point[axis_] = along;
        point[u_] = u;
        point[v_] = v;
        return point;
    }

    PlanePolygon section_;
    int axis_, u_, v_;  ///< the section's first and second coordinate are those along u and v
    double from_, to_;  ///< m
};

MATPOINT_PLUGIN("extrusion", "1.0.0") {
    registry.geometry<Extrusion>("extrusion");
}
