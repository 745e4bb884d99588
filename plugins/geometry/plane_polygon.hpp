#pragma once

#include <matpoint/geometry.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace matpoint {

/// What polygon and extrusion share: their parameter `vertices`.
inline Schema& declare_vertices(Schema& schema, std::string doc) {
    return schema.add("vertices", ParameterType::any, {.unit = "m", .doc = std::move(doc)})
        .refuse("/vertices", "expected at least three points of two numbers: [[0, 0], [2, 0], [0, 1]]",
                [](const Json& own, const Json&) {
                    const Json& points = own.at("vertices");
                    return !points.is_array() || points.size() < 3 ||
                           std::ranges::any_of(points, [](const Json& point) {
                               return !point.is_array() || point.size() != 2 || !point[0].is_number() ||
                                      !point[1].is_number();
                           });
                });
}

/// The inside of a closed line of straight edges in a plane with coordinates u and v, m. Half open as a box
/// is: of two polygons that share an edge only one has it.
///
/// Between neighbouring coordinates v of its vertices, edges neither begin, end nor cross: there is one order
/// along u, and of each pair of neighbours the first begins the inside and the second ends it.
class PlanePolygon {
  public:
    using Point = Eigen::Vector2d;

    /// Throws std::invalid_argument if edges cross, touch or have no length, with their numbers from 0.
    explicit PlanePolygon(const Json& vertices) {
        for (const Json& point : vertices) vertices_.emplace_back(point[0], point[1]);
        min_ = max_ = vertices_[0];
        for (const Point& vertex : vertices_) {
            min_ = min_.cwiseMin(vertex);
            max_ = max_.cwiseMax(vertex);
        }
        refuse_degenerate();
        make_strips();
        double twice_area = 0;
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            twice_area += turn(vertices_[0], begin_of(i), end_of(i));
        turn_ = twice_area > 0 ? 1 : -1;
    }

    const Point& min() const { return min_; }
    const Point& max() const { return max_; }

    /// What the line at `v` has inside, along u.
    Intervals along_u(double v) const {
        Intervals inside;
        const Strip* const strip = strip_at(v);
        if (!strip) return inside;
        for (std::size_t k = 0; k + 1 < strip->edges.size(); k += 2) {
            const Interval part{strip->edges[k].u_at(v), strip->edges[k + 1].u_at(v)};
            if (part.begin < part.end) inside.push_back(part);  // else no wider than rounding
        }
        return inside;
    }

    bool contains(double u, double v) const {
        const Strip* const strip = strip_at(v);
        return strip &&
               std::ranges::count_if(strip->edges, [&](const Edge& edge) { return edge.u_at(v) <= u; }) % 2 ==
                   1;
    }

    /// Distance from the nearest edge, negative inside, and its gradient.
    std::pair<double, Point> signed_distance(const Point& point) const {
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity(), part = 0;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const Point along = end_of(i) - begin_of(i);
            const double at = part_along(point, begin_of(i), end_of(i));
            const double square = (point - begin_of(i) - at * along).squaredNorm();
            if (square < least) std::tie(least, nearest, part) = std::tuple(square, i, at);
        }
        if (part > 0 && part < 1) {
            const Point normal = normal_of(nearest);
            return {normal.dot(point - begin_of(nearest)), normal};
        }
        // Beyond the ends of both edges at a corner: outside if it is convex, and inside if it is not.
        const std::size_t before = part > 0 ? nearest : (nearest + vertices_.size() - 1) % vertices_.size();
        const Point middle = normal_of(before) + normal_of((before + 1) % vertices_.size());
        const Point away = point - end_of(before);
        const double distance = std::copysign(away.norm(), middle.dot(away));
        return {distance, distance != 0 ? Point(away / distance) : middle.normalized()};
    }

    /// Coordinates of the vertices along an axis of the plane.
    std::vector<double> corners(int axis) const {
        std::vector<double> all;
        for (const Point& vertex : vertices_) all.push_back(vertex[axis]);
        return all;
    }

    /// Where edges lie across an axis of the plane, and where it begins and ends.
    std::vector<double> flat_edges(int axis) const {
        std::vector<double> all{min_[axis], max_[axis]};
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            if (begin_of(i)[axis] == end_of(i)[axis]) all.push_back(begin_of(i)[axis]);
        return all;
    }

  private:
    struct Edge {
        Point low, high;  ///< by v, so that polygons on both sides of an edge reckon alike
        double u_at(double v) const {
            return low[0] + (v - low[1]) / (high[1] - low[1]) * (high[0] - low[0]);
        }
    };
    /// All edges over some coordinates v, in their order along u.
    struct Strip {
        double begin, end;
        std::vector<Edge> edges;
    };

    const Point& begin_of(std::size_t edge) const { return vertices_[edge]; }
    const Point& end_of(std::size_t edge) const { return vertices_[(edge + 1) % vertices_.size()]; }

    const Strip* strip_at(double v) const {
        const auto after = std::ranges::upper_bound(strips_, v, {}, &Strip::begin);
        return after == strips_.begin() || !(v < max_[1]) ? nullptr : &*(after - 1);
    }

    void make_strips() {
        std::vector<double> cuts = corners(1);
        std::ranges::sort(cuts);
        cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) strips_.push_back({cuts[i], cuts[i + 1], {}});
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const bool upward = begin_of(i)[1] < end_of(i)[1];
            const Edge edge = upward ? Edge{begin_of(i), end_of(i)} : Edge{end_of(i), begin_of(i)};
            for (auto strip = std::ranges::lower_bound(strips_, edge.low[1], {}, &Strip::begin);
                 strip != strips_.end() && strip->begin < edge.high[1]; ++strip)
                strip->edges.push_back(edge);
        }
        for (Strip& strip : strips_)
            std::ranges::sort(strip.edges, {}, [middle = (strip.begin + strip.end) / 2](const Edge& edge) {
                return edge.u_at(middle);
            });
    }

    /// Unit vector across an edge, out of the polygon.
    Point normal_of(std::size_t edge) const {
        const Point along = end_of(edge) - begin_of(edge);
        return turn_ * Point(along[1], -along[0]).normalized();
    }

    /// Where on an edge it is nearest to a point, from 0 to 1.
    static double part_along(const Point& point, const Point& begin, const Point& end) {
        const Point along = end - begin;
        return std::clamp(along.dot(point - begin) / along.squaredNorm(), 0.0, 1.0);
    }
    static double distance(const Point& point, const Point& begin, const Point& end) {
        return (point - begin - part_along(point, begin, end) * (end - begin)).norm();
    }

    static double turn(const Point& a, const Point& b, const Point& c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    bool cross(std::size_t i, std::size_t j) const {
        const Point &a = begin_of(i), &b = end_of(i), &c = begin_of(j), &d = end_of(j);
        return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
    }

    /// Smallest distance of an edge's end from the other edge. Neighbours have one end in common: the other
    /// two count.
    double distance(std::size_t i, std::size_t j) const {
        const Point &a = begin_of(i), &b = end_of(i), &c = begin_of(j), &d = end_of(j);
        if ((i + 1) % vertices_.size() == j) return std::min(distance(a, c, d), distance(d, a, b));
        if ((j + 1) % vertices_.size() == i) return std::min(distance(c, a, b), distance(b, c, d));
        return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
    }

    void refuse_degenerate() const {
        const double resolution = 1e-12 * std::max(min_.cwiseAbs().maxCoeff(), max_.cwiseAbs().maxCoeff());
        const std::size_t size = vertices_.size();
        for (std::size_t i = 0; i < size; ++i)
            if (!((end_of(i) - begin_of(i)).norm() > resolution))
                throw std::invalid_argument(
                    name(i) + " has no length" +
                    (i + 1 == size ? ": the last vertex needs not repeat the first" : ""));
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = i + 1; j < size; ++j) {
                if (apart(i, j, resolution)) continue;
                if (cross(i, j)) throw std::invalid_argument(name(i) + " crosses " + name(j));
                if (!(distance(i, j) > resolution))
                    throw std::invalid_argument(name(i) + " touches " + name(j));
            }
    }

    /// Whether the boxes around two edges are.
    bool apart(std::size_t i, std::size_t j, double resolution) const {
        const Point &a = begin_of(i), &b = end_of(i), &c = begin_of(j), &d = end_of(j);
        return ((a.cwiseMin(b) - c.cwiseMax(d)).array() > resolution).any() ||
               ((c.cwiseMin(d) - a.cwiseMax(b)).array() > resolution).any();
    }

    std::string name(std::size_t edge) const {
        std::ostringstream text;
        text << "edge " << edge << " of `vertices`, from [" << begin_of(edge)[0] << ", " << begin_of(edge)[1]
             << "] to [" << end_of(edge)[0] << ", " << end_of(edge)[1] << "],";
        return text.str();
    }

    std::vector<Point> vertices_;
    double turn_ = 1;  ///< 1: counterclockwise, -1: clockwise
    Point min_, max_;
    std::vector<Strip> strips_;  ///< ascending
};

}  // namespace matpoint
