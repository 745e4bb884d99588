#pragma once

#include "motion.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace matpoint {

/// Impulses by which bodies neither enter a tool nor slide on it more than friction lets them: at each point
///
///     w_n >= target, J_n >= 0, (w_n - target) J_n = 0; |J_t| <= mu J_n, and J_t is against w_t where it
///     slides
///
/// with w the velocity of the body at the point less that of the tool. It is found by projected Gauss-Seidel
/// [Jean 1999, The non-smooth contact dynamics method]: point by point, always with the velocities that the
/// others have left, until none changes. Points may be more than the velocities that they see (two rows of
/// particles in a row of cells): then the points' impulses are not unique, but what the nodes get is.
template <int D>
class Impulses {
  public:
    using Vector = Eigen::Matrix<double, D, 1>;

    /// A node of a body. Components that boundary conditions set have no `ease`.
    struct Node {
        std::size_t body;
        int place;
        Vector velocity;                  ///< m/s, as far as is known
        Vector ease;                      ///< 1/kg, 1 / m in each component
        Vector impulse = Vector::Zero();  ///< N s
    };
    /// What of a point's velocity, and impulse, is a node's, in each component.
    struct Part {
        int node;
        Vector weight;
    };
    struct Point {
        std::size_t begin, end;             ///< of its parts
        Vector place;                       ///< m, of the tool's surface
        Vector normal;                      ///< out of the tool
        double target;                      ///< m/s
        Vector impulse = Vector::Zero();    ///< N s, on the body; at first a guess
        Vector approach = Vector::Zero();   ///< m/s, w without contact
        double ease = 0, sliding_ease = 0;  ///< 1/kg
    };

    void clear() {
        nodes.clear();
        parts.clear();
        points.clear();
    }

    std::vector<Node> nodes;
    std::vector<Part> parts;
    std::vector<Point> points;

    Vector velocity(const Point& point, const Motion& tool) const {
        Vector w = -tool.velocity_at(full(point.place)).template head<D>();
        for (std::size_t k = point.begin; k < point.end; ++k)
            w += parts[k].weight.cwiseProduct(nodes[static_cast<std::size_t>(parts[k].node)].velocity);
        return w;
    }

    /// Starts from the points' impulses; a tool that moves freely is pushed by the opposite ones.
    void solve(Motion& tool, double friction) {
        double scale = 0;
        for (Point& point : points) {
            prepare(point, tool);
            scale = std::max({scale, point.approach.norm(), std::abs(point.target)});
        }
        for (Point& point : points) {
            const Vector guess = admissible(point, point.impulse, friction);
            point.impulse.setZero();
            give(point, guess, tool);
        }
        for (int sweep = 0; sweep < most_sweeps; ++sweep) {
            double change = 0;
            for (Point& point : points) change = std::max(change, relax(point, friction, tool));
            if (change <= tolerance * scale) break;
        }
    }

    static Eigen::Vector3d full(const Vector& v) {
        Eigen::Vector3d all = Eigen::Vector3d::Zero();
        all.template head<D>() = v;
        return all;
    }

  private:
    static constexpr int most_sweeps = 1000;
    static constexpr double tolerance = 1e-10;

    void prepare(Point& point, const Motion& tool) {
        point.approach = velocity(point, tool);
        Vector by_axis = Vector::Zero();
        for (std::size_t k = point.begin; k < point.end; ++k) {
            const Node& node = nodes[static_cast<std::size_t>(parts[k].node)];
            by_axis += parts[k].weight.cwiseAbs2().cwiseProduct(node.ease);
        }
        point.ease = by_axis.dot(point.normal.cwiseAbs2());
        point.sliding_ease = by_axis.maxCoeff();
        if (tool.is_free()) {
            const Eigen::Vector3d normal = full(point.normal), place = full(point.place);
            point.ease += tool.ease(place, normal);
            // Along no direction is it moved more easily than this.
            point.sliding_ease +=
                tool.ease(place, Eigen::Vector3d(normal.unitOrthogonal())) + tool.ease(place, normal);
        }
    }

    static Vector admissible(const Point& point, const Vector& impulse, double friction) {
        const double pressing = std::max(0.0, impulse.dot(point.normal));
        Vector sliding = impulse - impulse.dot(point.normal) * point.normal;
        const double most = friction * pressing, size = sliding.norm();
        if (size > most) sliding *= most / size;
        return pressing * point.normal + sliding;
    }

    /// The velocity that the point's impulse changes by, about.
    double relax(Point& point, double friction, Motion& tool) {
        if (!(point.ease > 0)) return 0;
        const Vector before = point.impulse;
        Vector w = velocity(point, tool);
        const double pressing =
            std::max(0.0, before.dot(point.normal) + (point.target - w.dot(point.normal)) / point.ease);
        const Vector sliding = before - before.dot(point.normal) * point.normal;
        give(point, pressing * point.normal + sliding, tool);
        if (friction > 0 && (pressing > 0 || !sliding.isZero(0))) {
            w = velocity(point, tool);
            const Vector across = w - w.dot(point.normal) * point.normal;
            const Vector wanted = pressing * point.normal + sliding - across / point.sliding_ease;
            give(point, admissible(point, wanted, friction), tool);
        }
        return (point.impulse - before).norm() * point.ease;
    }

    void give(Point& point, const Vector& impulse, Motion& tool) {
        const Vector more = impulse - point.impulse;
        point.impulse = impulse;
        for (std::size_t k = point.begin; k < point.end; ++k) {
            Node& node = nodes[static_cast<std::size_t>(parts[k].node)];
            const Vector own = parts[k].weight.cwiseProduct(more);
            node.impulse += own;
            node.velocity += own.cwiseProduct(node.ease);
        }
        if (tool.is_free()) tool.push(full(point.place), -full(more));
    }
};

}  // namespace matpoint
