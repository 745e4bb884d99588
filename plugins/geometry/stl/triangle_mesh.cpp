#include "triangle_mesh.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace matpoint {

namespace {

using Triangle = TriangleMesh::Triangle;
using Verdict = TriangleMesh::Verdict;

bool lexicographically_less(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
}

/// Lines along one axis, through points: in rows of equal v, each row's in order of u.
struct Lines {
    std::vector<std::size_t> line_of;  ///< of each point
    std::vector<double> row_v;
    std::vector<std::size_t> row_begin;  ///< first line of each row, and the end of the last
    std::vector<double> line_u;

    Lines(std::span<const Eigen::Vector3d> points, int u, int v) : line_of(points.size()) {
        std::vector<std::size_t> order(points.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
            return std::tie(points[i][v], points[i][u]) < std::tie(points[j][v], points[j][u]);
        });
        for (const std::size_t i : order) {
            const bool new_row = row_v.empty() || points[i][v] != row_v.back();
            if (new_row) {
                row_v.push_back(points[i][v]);
                row_begin.push_back(line_u.size());
            }
            if (new_row || points[i][u] != line_u.back()) line_u.push_back(points[i][u]);
            line_of[i] = line_u.size() - 1;
        }
        row_begin.push_back(line_u.size());
    }
};

/// A triangle seen along an axis. Whether a line goes through it is put together from its edges: a ray
/// from the line in direction u crosses an odd number of them. Each edge is decided half open and by
/// arithmetic that does not depend on the order of its ends, so that the triangles on its two sides
/// decide alike, and a line that meets an edge or a corner never slips through.
class Projected {
  public:
    Projected(const Triangle& triangle, int axis, int u, int v)
        : corners_(triangle), axis_(axis), u_(u), v_(v) {
        const auto range = [&](int a) {
            return std::minmax({triangle[0][a], triangle[1][a], triangle[2][a]});
        };
        std::tie(u_min, u_max) = range(u);
        std::tie(v_min, v_max) = range(v);
        std::tie(depth_min_, depth_max_) = range(axis);
        normal_ = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    }

    bool meets(double u, double v) const {
        return crosses(corners_[0], corners_[1], u, v) ^ crosses(corners_[1], corners_[2], u, v) ^
               crosses(corners_[2], corners_[0], u, v);
    }

    /// Where the line meets the triangle's plane; within the triangle even if seen edge-on.
    double depth(double u, double v) const {
        if (normal_[axis_] == 0) return 0.5 * (depth_min_ + depth_max_);
        const Eigen::Vector3d& a = corners_[0];
        const double depth =
            a[axis_] - (normal_[u_] * (u - a[u_]) + normal_[v_] * (v - a[v_])) / normal_[axis_];
        return std::clamp(depth, depth_min_, depth_max_);
    }

    double u_min, u_max, v_min, v_max;

  private:
    bool crosses(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double u, double v) const {
        if ((p[v_] > v) == (q[v_] > v)) return false;
        const Eigen::Vector3d& low = p[v_] < q[v_] ? p : q;
        const Eigen::Vector3d& high = p[v_] < q[v_] ? q : p;
        return (u - low[u_]) * (high[v_] - low[v_]) < (high[u_] - low[u_]) * (v - low[v_]);
    }

    const Triangle& corners_;
    int axis_, u_, v_;
    double depth_min_, depth_max_;
    Eigen::Vector3d normal_;
};

/// Depths at which each line meets triangles: pairs of line and depth, ascending.
std::vector<std::pair<std::size_t, double>> crossings(const Lines& lines,
                                                      const std::vector<Triangle>& triangles, int axis, int u,
                                                      int v) {
    std::vector<std::pair<std::size_t, double>> found;
    for (const Triangle& corners : triangles) {
        const Projected triangle(corners, axis, u, v);
        auto row = std::lower_bound(lines.row_v.begin(), lines.row_v.end(), triangle.v_min);
        for (; row != lines.row_v.end() && *row <= triangle.v_max; ++row) {
            const auto r = static_cast<std::size_t>(row - lines.row_v.begin());
            const auto begin = lines.line_u.begin() + static_cast<std::ptrdiff_t>(lines.row_begin[r]);
            const auto end = lines.line_u.begin() + static_cast<std::ptrdiff_t>(lines.row_begin[r + 1]);
            for (auto line = std::lower_bound(begin, end, triangle.u_min);
                 line != end && *line <= triangle.u_max; ++line)
                if (triangle.meets(*line, *row))
                    found.emplace_back(line - lines.line_u.begin(), triangle.depth(*line, *row));
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Where lines along an axis, through points, meet triangles.
class Crossed {
  public:
    Crossed(std::span<const Eigen::Vector3d> points, const std::vector<Triangle>& triangles, int axis)
        : lines_(points, (axis + 1) % 3, (axis + 2) % 3),
          found_(crossings(lines_, triangles, axis, (axis + 1) % 3, (axis + 2) % 3)),
          first_(lines_.line_u.size() + 1, 0) {
        for (const auto& [line, depth] : found_) ++first_[line + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
    }
    /// Of a point's line: pairs of line and depth, ascending.
    auto of(std::size_t point) const {
        const std::size_t line = lines_.line_of[point];
        return std::span(found_).subspan(first_[line], first_[line + 1] - first_[line]);
    }

  private:
    Lines lines_;
    std::vector<std::pair<std::size_t, double>> found_;
    std::vector<std::size_t> first_;  ///< place in `found_` where each line's crossings begin
};

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    std::erase_if(triangles_, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    min_.setConstant(std::numeric_limits<double>::infinity());
    max_ = -min_;
    for (const Triangle& triangle : triangles_)
        for (const Eigen::Vector3d& corner : triangle) {
            min_ = min_.cwiseMin(corner);
            max_ = max_.cwiseMax(corner);
        }
    count_edges();
}

std::vector<std::array<std::size_t, 3>> TriangleMesh::corner_numbers() const {
    std::vector<Eigen::Vector3d> corners;
    for (const Triangle& triangle : triangles_)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    std::sort(corners.begin(), corners.end(), lexicographically_less);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    std::vector<std::array<std::size_t, 3>> numbers(triangles_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            numbers[t][i] = static_cast<std::size_t>(
                std::lower_bound(corners.begin(), corners.end(), triangles_[t][i], lexicographically_less) -
                corners.begin());
    return numbers;
}

void TriangleMesh::count_edges() {
    struct EdgeUse {
        std::size_t low, high;
        int direction;
    };
    std::vector<EdgeUse> uses;
    for (const auto& corners : corner_numbers())
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = corners[i], to = corners[(i + 1) % 3];
            uses.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
        }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    });
    for (std::size_t first = 0, last; first < uses.size(); first = last) {
        int turn = 0;
        for (last = first;
             last < uses.size() && uses[last].low == uses[first].low && uses[last].high == uses[first].high;
             ++last)
            turn += uses[last].direction;
        if ((last - first) % 2 == 1)
            ++open_edges_;
        else if (turn != 0)
            ++inconsistent_edges_;
    }
}

std::vector<Verdict> TriangleMesh::classify(std::span<const Eigen::Vector3d> points) const {
    std::vector<Verdict> verdicts = along(0, points);
    if (open_edges_ == 0) return verdicts;
    const std::vector<Verdict> y = along(1, points), z = along(2, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto votes = [&](Verdict v) { return (verdicts[i] == v) + (y[i] == v) + (z[i] == v); };
        const int inside = votes(Verdict::inside), outside = votes(Verdict::outside);
        verdicts[i] = inside > outside   ? Verdict::inside
                      : inside < outside ? Verdict::outside
                                         : Verdict::undecided;
    }
    return verdicts;
}

std::vector<Verdict> TriangleMesh::along(int axis, std::span<const Eigen::Vector3d> points) const {
    const Crossed crossed(points, triangles_, axis);
    std::vector<Verdict> verdicts(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto met = crossed.of(i);
        const auto before = std::ranges::upper_bound(met, points[i][axis], {},
                                                     [](const auto& crossing) { return crossing.second; });
        verdicts[i] = met.size() % 2 == 1               ? Verdict::undecided
                      : (before - met.begin()) % 2 == 1 ? Verdict::inside
                                                        : Verdict::outside;
    }
    return verdicts;
}

/// Between two crossings a line is inside or not: of a closed surface, in turn; of one with holes, as
/// at the middle.
std::vector<Intervals> TriangleMesh::along_x(std::span<const Eigen::Vector2d> lines) const {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector2d& line : lines) points.emplace_back(0, line[0], line[1]);
    const Crossed crossed(points, triangles_, 0);
    std::vector<Intervals> parts(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<double> ends;
        for (const auto& [line, depth] : crossed.of(i)) ends.push_back(depth);
        if (open_edges_ > 0) {
            ends.insert(ends.begin(), min_[0]);
            ends.push_back(max_[0]);
        }
        const std::size_t next = open_edges_ > 0 ? 1 : 2;
        for (std::size_t k = 0; k + 1 < ends.size(); k += next) parts[i].push_back({ends[k], ends[k + 1]});
    }
    if (open_edges_ > 0) keep_inside(lines, parts);
    return parts;
}

/// Of parts of lines, those whose middle is inside.
void TriangleMesh::keep_inside(std::span<const Eigen::Vector2d> lines, std::vector<Intervals>& parts) const {
    std::vector<Eigen::Vector3d> middles;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (const Interval& part : parts[i])
            middles.emplace_back((part.begin + part.end) / 2, lines[i][0], lines[i][1]);
    const std::vector<Verdict> verdicts = classify(middles);
    auto verdict = verdicts.begin();
    for (Intervals& all : parts) {
        Intervals inside;
        for (const Interval& part : all)
            if (*verdict++ == Verdict::inside) inside.push_back(part);
        all = std::move(inside);
    }
}

std::vector<double> TriangleMesh::flat_faces(int axis) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::map<double, double> areas;
    for (const Triangle& t : triangles_)
        if (t[0][axis] == t[1][axis] && t[1][axis] == t[2][axis])
            areas[t[0][axis]] += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
    const double least = 0.01 * (max_[u] - min_[u]) * (max_[v] - min_[v]);
    std::vector<double> faces{min_[axis], max_[axis]};
    for (const auto& [coordinate, area] : areas)
        if (area >= least) faces.push_back(coordinate);
    return faces;
}

}  // namespace matpoint
