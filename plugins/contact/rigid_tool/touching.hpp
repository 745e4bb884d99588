#pragma once

#include "impulses.hpp"
#include "motion.hpp"

#include <matpoint/contact.hpp>
#include <matpoint/domain_box.hpp>
#include <matpoint/geometry.hpp>
#include <matpoint/parallel.hpp>
#include <matpoint/spline.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace matpoint {

/// Where bodies are about to touch a tool, as points of Impulses: particles or nodes.
template <class S>
class Touching {
  public:
    static constexpr int D = S::dimension;
    using Vector = typename S::Position;
    using Coordinates = typename Patch<S>::Coordinates;

    /// What a point is, beside what Impulses knows of it.
    struct Origin {
        std::size_t body;
        Index particle;  ///< -1: a node
        double gap;      ///< m, at the start of the step
        double cell;     ///< m, the smallest edge of those around
    };

    Touching(std::shared_ptr<const Geometry> geometry) : geometry_(std::move(geometry)) {}

    double distance(const Vector& place, const Motion& tool) const { return surface(place, tool).distance; }
    /// Of a place, from the tool's surface as it is now.
    SignedDistance signed_distance(const Eigen::Vector3d& place, const Motion& tool) const {
        const SignedDistance found = guarded(
            *geometry_, "signed_distance", [&] { return geometry_->signed_distance(tool.to_start(place)); });
        return {found.distance, tool.from_start(found.normal)};
    }
    Impulses<D>& impulses() { return impulses_; }
    const std::vector<Origin>& origins() const { return origins_; }

    /// Forgets all points, and begins a step.
    void begin(const ToolContext<S>& context) {
        for (const auto& node : impulses_.nodes) number_of_[static_cast<std::size_t>(node.place)] = -1;
        impulses_.clear();
        origins_.clear();
        number_of_.resize(static_cast<std::size_t>(context.nodes[0]->node_count()), -1);
    }

    /// Visits particles near the tool: visit(p, x, surface, gap), x their place and gap between the surfaces,
    /// m.
    template <class Visit>
    void for_gaps(const Patch<S>& patch, const Particles<S>& particles, const Motion& tool,
                  const Visit& visit) {
        for_near(patch, particles, tool, D * patch.cell_size().maxCoeff(), [&](Index p) {
            const Vector x = particles.position(p);
            const Surface found = surface(x, tool);
            visit(p, x, found, found.distance - half_width(particles, p, found.normal));
        });
    }

    /// A body's particles that may reach the tool in the step; those that overlap it are pushed out by a
    /// tenth of that. `guess(p)`: impulse on particle p, N s; `allowed(p, gap)`: what it may overlap, m.
    template <class Guess, class Allowed>
    void add_particles(const ToolContext<S>& context, std::size_t body, const Motion& tool,
                       const Guess& guess, const Allowed& allowed) {
        constexpr double pushed_out = 0.1;
        const Particles<S>& particles = context.bodies[body];
        const Patch<S>& coarsest = *context.nodes[body];
        const double near = 0.1 * coarsest.cell_size().minCoeff();
        const bool sized = particles.has(Field::half_size);
        for_gaps(
            coarsest, particles, tool, [&](Index p, const Vector& x, const Surface& found, double apart) {
                const auto& [distance, normal] = found;
                const double gap = apart + allowed(p, apart);
                const Vector relative = particles.velocity(p).template cast<double>() - velocity_of(tool, x);
                const Patch<S>& patch = context.nodes_at(body, x);
                if (gap > std::max(std::ldexp(near, -patch.level()), 2 * relative.norm() * context.dt))
                    return;
                const auto half =
                    sized ? particles.vector(Field::half_size, p) : typename S::Vector(S::Vector::Zero());
                const auto stencil = context.shape.stencil(patch, x, half);
                const std::size_t first = impulses_.parts.size();
                for (std::size_t k = 0; k < stencil.nodes.size(); ++k)
                    if (stencil.weights[k] > 0)
                        add_part(context, body, patch, stencil.nodes[k],
                                 static_cast<double>(stencil.weights[k]) * Vector::Ones());
                impulses_.points.push_back({.begin = first,
                                            .end = impulses_.parts.size(),
                                            .place = x - distance * normal,
                                            .normal = normal,
                                            .target = -(gap > 0 ? gap : pushed_out * gap) / context.dt,
                                            .impulse = guess(p)});
                origins_.push_back({body, p, gap, patch.cell_size().minCoeff()});
            });
    }

    /// A body's nodes that the tool reaches as well, with gaps by the moments of what is around them.
    void add_nodes(const ToolContext<S>& context, std::size_t body, const Motion& tool) {
        if (!spline_) spline_.emplace(spline_degree(*context.nodes[body], context.shape));
        for (int level = 0; level < context.levels(); ++level)
            add_nodes(context, body, context.nodes_of(body, level), tool);
    }

    /// Half of what a particle's deformed domain measures along a direction, m: of a box with the same second
    /// moment along it. That of a box's corner would lift a body which turns, and press it in at once by the
    /// tip of a wedge as far as by a flat punch.
    static double half_width(const Particles<S>& particles, Index p, const Vector& along) {
        const auto f = ParticleBatch<S>::load_deformation_gradient(particles, p);
        double square = 0;
        for (int b = 0; b < D; ++b) {
            const double half = along.dot(f.plane.col(b).template cast<double>()) *
                                static_cast<double>(particles.column(Field::initial_half_size, b)[p]);
            square += half * half;
        }
        return std::sqrt(square);
    }

  private:
    /// What of a body is around a node.
    struct Surroundings {
        int place;
        Vector position;                 ///< m
        double distance;                 ///< m, from the tool
        Vector normal;                   ///< of the tool
        double size = 0;                 ///< O, in cells
        Vector moment = Vector::Zero();  ///< M / O is the centroid, m
    };
    static constexpr Index chunk = 64;

    /// Those of a level, around which particles of all levels are.
    void add_nodes(const ToolContext<S>& context, std::size_t body, const Patch<S>& patch,
                   const Motion& tool) {
        const Particles<S>& particles = context.bodies[body];
        for (const Surroundings& node : surroundings_)
            surroundings_of_[static_cast<std::size_t>(node.place)] = -1;
        surroundings_.clear();
        surroundings_of_.resize(static_cast<std::size_t>(patch.node_count()), -1);
        const double reach = (2 * spline_->reach() + 1) * patch.cell_size().norm();
        for_near(patch, particles, tool, reach, [&](Index p) {
            const DomainBox<S> own(patch, particles, p);
            visit_images(
                patch, own, 2 * spline_->reach(),
                [&](int axis, int side) { return mirrors(context, patch, own, axis, side); },
                [&](const DomainBox<S>& box) { measure(context, patch, box, tool); });
        });
        for (const Surroundings& node : surroundings_) add_node(context, body, patch, node, tool);
    }

    struct Surface {
        double distance;
        Vector normal;
    };
    Surface surface(const Vector& place, const Motion& tool) const {
        const SignedDistance found = signed_distance(Impulses<D>::full(place), tool);
        return {found.distance, found.normal.template head<D>()};
    }
    static Vector velocity_of(const Motion& tool, const Vector& place) {
        return tool.velocity_at(Impulses<D>::full(place)).template head<D>();
    }

    /// Visits the particles that are in groups of which one may be as near as `reach` (m).
    template <class Visit>
    void for_near(const Patch<S>&, const Particles<S>& particles, const Motion& tool, double reach,
                  const Visit& visit) {
        const Index chunks = (particles.size() + chunk - 1) / chunk;
        near_.resize(static_cast<std::size_t>(chunks));
        parallel_for(chunks, particles.size(), [&](Index k) {
            const Index begin = k * chunk, count = std::min(chunk, particles.size() - begin);
            Vector middle, half;
            for (int a = 0; a < D; ++a) {
                const auto x = Eigen::Map<const Eigen::Array<typename S::Real, Eigen::Dynamic, 1>>(
                    particles.column(Field::position, a) + begin, count);
                const auto low = static_cast<double>(x.minCoeff()), high = static_cast<double>(x.maxCoeff());
                middle[a] = (low + high) / 2;
                half[a] = (high - low) / 2;
            }
            near_[static_cast<std::size_t>(k)] = surface(middle, tool).distance <= half.norm() + reach;
        });
        for (Index k = 0; k < chunks; ++k) {
            if (!near_[static_cast<std::size_t>(k)]) continue;
            const Index end = std::min(particles.size(), (k + 1) * chunk);
            for (Index p = k * chunk; p < end; ++p) visit(p);
        }
    }

    static bool is_prescribed(const ToolContext<S>& context, int place, int component) {
        return (context.prescribed[static_cast<std::size_t>(place)] >> component & 1) != 0;
    }

    /// A node's part in the last point. Ghosts beyond a face of the grid stand for nodes within, as the walls
    /// fill them: odd about what is prescribed, 2 v_0 - v_1, and even otherwise, v_1; an open face
    /// extrapolates. Nodes that follow from others stand for these.
    void add_part(const ToolContext<S>& context, std::size_t body, const Patch<S>& patch,
                  const Coordinates& node, const Vector& weight) {
        for (std::size_t a = 0; a < D; ++a) {
            const int last = patch.cells()[a];
            if (node[a] >= 0 && node[a] <= last) continue;
            add_ghost(context, body, patch, node, a, weight);
            return;
        }
        const int place = patch.node_index(node);
        if (place < 0 || weight.isZero(0)) return;
        if (context.parents)
            if (const auto parents = (*context.parents)(place); !parents.empty()) {
                const Patch<S>& coarser = context.nodes_of(body, patch.level() - 1);
                for (const auto& parent : parents)
                    add_part(context, body, coarser, coarser.node_coordinates(parent.node),
                             static_cast<double>(parent.weight) * weight);
                return;
            }
        int& number = number_of_[static_cast<std::size_t>(place)];
        if (number < 0) {
            number = static_cast<int>(impulses_.nodes.size());
            const auto mass = static_cast<double>(patch.column(NodeField::mass)[place]);
            Vector ease;
            for (int c = 0; c < D; ++c)
                ease[c] = mass > 0 && !is_prescribed(context, place, c) ? 1 / mass : 0;
            impulses_.nodes.push_back(
                {body, place, context.velocity(body, place).template cast<double>(), ease});
        }
        impulses_.parts.push_back({number, weight});
    }

    /// One beyond the grid along an axis. Where nodes are at the middles of cells, none is at the face.
    void add_ghost(const ToolContext<S>& context, std::size_t body, const Patch<S>& patch,
                   const Coordinates& node, std::size_t axis, const Vector& weight) {
        const int last = patch.cells()[axis];
        Coordinates edge = node, inner = node;
        edge[axis] = node[axis] < 0 ? 0 : last;
        inner[axis] = node[axis] < 0 ? 1 : last - 1;
        const int place = patch.node_index(edge);
        const bool wall = place >= 0 && context.prescribed[static_cast<std::size_t>(place)] != 0;
        Vector of_edge = 2 * weight, of_inner = -weight;
        for (int c = 0; c < D; ++c)
            if (wall && !is_prescribed(context, place, c)) of_edge[c] = 0, of_inner[c] = weight[c];
        add_part(context, body, patch, edge, of_edge);
        add_part(context, body, patch, inner, of_inner);
    }

    /// Whether a face of the grid does beside a domain: it prescribes what goes through it there.
    static bool mirrors(const ToolContext<S>& context, const Patch<S>& patch, const DomainBox<S>& own,
                        int axis, int side) {
        Coordinates beside;
        for (std::size_t b = 0; b < D; ++b)
            beside[b] = std::clamp(static_cast<int>(std::lround(own.centre[static_cast<int>(b)])), 0,
                                   patch.cells()[b]);
        const auto along = static_cast<std::size_t>(axis);
        beside[along] = side == 0 ? 0 : patch.cells()[along];
        const int place = patch.node_index(beside);
        return place >= 0 && is_prescribed(context, place, axis);
    }

    /// Adds a domain to what is around the nodes that the tool reaches.
    void measure(const ToolContext<S>& context, const Patch<S>& patch, const DomainBox<S>& box,
                 const Motion& tool) {
        Coordinates low, high;
        for (int a = 0; a < D; ++a) {
            const auto axis = static_cast<std::size_t>(a);
            const double reach = spline_->reach() + box.half_size[a];
            low[axis] = std::max(0, static_cast<int>(std::ceil(box.centre[a] - reach)));
            high[axis] = std::min(patch.cells()[axis], static_cast<int>(std::floor(box.centre[a] + reach)));
            if (low[axis] > high[axis]) return;
        }
        for (Coordinates node = low;;) {
            if (Surroundings* const found = surroundings(context, patch, node, tool))
                add(*found, patch, node, box);
            std::size_t a = 0;
            while (a < D && node[a] == high[a]) node[a] = low[a], ++a;
            if (a == D) return;
            ++node[a];
        }
    }

    Surroundings* surroundings(const ToolContext<S>& context, const Patch<S>& patch, const Coordinates& node,
                               const Motion& tool) {
        const int place = patch.node_index(node);
        if (place < 0 || !context.inside[static_cast<std::size_t>(place)]) return nullptr;
        int& number = surroundings_of_[static_cast<std::size_t>(place)];
        if (number < 0) {
            const Vector position = patch.node_position(node);
            const auto [distance, normal] = surface(position, tool);
            number = static_cast<int>(surroundings_.size());
            surroundings_.push_back({place, position, distance, normal});
        }
        return &surroundings_[static_cast<std::size_t>(number)];
    }

    void add(Surroundings& around, const Patch<S>& patch, const Coordinates& node,
             const DomainBox<S>& box) const {
        Vector mass, moment;
        for (int a = 0; a < D; ++a) {
            const double begin = box.centre[a] - box.half_size[a] - node[static_cast<std::size_t>(a)],
                         end = begin + 2 * box.half_size[a], share = 1 / (2 * box.half_size[a]);
            const Spline::Values from = spline_->at(begin), to = spline_->at(end);
            mass[a] = share * (to.mass - from.mass);
            moment[a] = share * (to.moment - from.moment);
        }
        const double cells = box.volume / patch.cell_size().prod();
        around.size += cells * mass.prod();
        for (int a = 0; a < D; ++a) {
            Vector factors = mass;
            factors[a] = moment[a];
            around.moment[a] += cells * factors.prod() * patch.cell_size()[a];
        }
    }

    void add_node(const ToolContext<S>& context, std::size_t body, const Patch<S>& patch,
                  const Surroundings& around, const Motion& tool) {
        constexpr double least = 1e-5;   // cells of a body around a node; less is rounding
        constexpr double beside = 1e-6;  // cells
        constexpr double same = 0.999;   // cosine of the angle between normals
        if (!(around.size > least) || around.distance >= spline_->reach() * cell_along(patch, around.normal))
            return;
        if (!(patch.column(NodeField::mass)[around.place] > 0)) return;
        add_node(context, body, patch, around, around.normal, tool);
        // Where sides of the tool are as near as each other, on the axis of a wedge, each of them is met.
        std::array<Vector, 2 * D + 1> known{around.normal};
        std::size_t count = 1;
        for (const double step : {-beside, beside})
            for (int a = 0; a < D; ++a) {
                const Vector normal =
                    surface(around.position + step * patch.cell_size()[a] * Vector::Unit(a), tool).normal;
                const auto is_same = [&](const Vector& other) { return other.dot(normal) > same; };
                if (std::any_of(known.begin(), known.begin() + count, is_same)) continue;
                known[count++] = normal;
                add_node(context, body, patch, around, normal, tool);
            }
    }

    /// The spline has the same second moment along every direction: that of a cell of this size, m.
    static double cell_along(const Patch<S>& patch, const Vector& normal) {
        return normal.cwiseProduct(patch.cell_size()).norm();
    }

    /// Against the side of the tool that has this normal.
    void add_node(const ToolContext<S>& context, std::size_t body, const Patch<S>& patch,
                  const Surroundings& around, const Vector& normal, const Motion& tool) {
        const double cell = cell_along(patch, normal);
        const double gap =
            around.distance - cell * spline_->surface(-normal.dot(around.moment) / (around.size * cell));
        const Vector place = around.position - around.distance * normal;
        const Vector w =
            context.velocity(body, around.place).template cast<double>() - velocity_of(tool, place);
        const double target = -std::max(gap, 0.0) / context.dt;
        if (!tool.is_free() && w.dot(normal) >= target) return;
        const std::size_t first = impulses_.parts.size();
        add_part(context, body, patch, patch.node_coordinates(around.place), Vector::Ones());
        impulses_.points.push_back({.begin = first,
                                    .end = impulses_.parts.size(),
                                    .place = place,
                                    .normal = normal,
                                    .target = target});
        origins_.push_back({body, -1, gap, patch.cell_size().minCoeff()});
    }

    std::shared_ptr<const Geometry> geometry_;
    Impulses<D> impulses_;
    std::vector<Origin> origins_;  ///< by point
    std::vector<int> number_of_;   ///< by place of a node: which of the Impulses' it is; -1: none
    std::vector<char> near_;
    std::optional<Spline> spline_;
    std::vector<Surroundings> surroundings_;
    std::vector<int> surroundings_of_;  ///< by place of a node; -1: none
};

}  // namespace matpoint
