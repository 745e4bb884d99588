#pragma once

#include "each_once.hpp"
#include "particle_cloud.hpp"

#include <matpoint/edge.hpp>
#include <matpoint/registry.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

/// What every shape function must satisfy, in every space. Out of tree:
///
///     Registry registry;
///     matpoint_plugin_register(registry);
///     conformance::check_shape_function(registry, {{"type", "my_shape"}, …});
///
/// with every parameter given.
namespace matpoint::conformance {

template <class S>
class ShapeFunctionChecks {
  public:
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    using Position = typename S::Position;
    using Matrix = typename S::Matrix;
    using Coordinates = typename Patch<S>::Coordinates;
    static constexpr int d = S::dimension;
    static constexpr double eps = std::numeric_limits<Real>::epsilon();
    /// For sums over a stencil, and over all particles.
    static constexpr double tolerance = 200 * eps, sum_tolerance = 3000 * eps;

    /// `stretch`: how far the particles' domains are stretched at most.
    explicit ShapeFunctionChecks(ShapeFunction<S>& shape, double stretch = 1.1)
        : shape_(shape), patch_(make_patch<S>()), cloud_(patch_, shape, 400, stretch) {
        shape_.start_step(patch_, cloud_.particles);
    }

    void all() {
        stencil_reproduces_linear_functions();
        gradient_is_the_derivative();
        weights_are_right_up_to_the_edge();
        base_nodes_begin_the_stencils();
        scatter_agrees_with_stencil();
        scatter_conserves();
        only_what_is_asked_for_changes();
        gather_agrees_with_stencil();
        gather_is_the_transpose_of_scatter();
        affine_velocity_of_a_linear_field_is_its_gradient();
        batches_are_in_order();
        spread_agrees_with_stencil();
        is_made_of_finer_ones();
    }

    /// Where a shape has a refinement, N_i = sum_k c_k n_(2 i + k) of those on cells of half the size, away
    /// from the grid's edge: for points, and for domains of half a finer cell.
    void is_made_of_finer_ones() const {
        const std::vector<double> line = shape_.refinement();
        if (line.empty()) return;
        const int n = static_cast<int>(line.size());
        const Patch<S> finer = patch_.refined(n % 2 == 0);
        const Vector half = patch_.cell_size().template cast<Real>() / 8;
        for (Index p = 0; p < size(); ++p) {
            const Position x = cloud_.particles.position(p);
            const auto coarse = shape_.stencil(patch_, x, half), fine = shape_.stencil(finer, x, half);
            if (!is_within(coarse.nodes.front(), coarse.nodes.back())) continue;
            std::map<Coordinates, double> made;
            for (std::size_t k = 0; k < fine.nodes.size(); ++k)
                visit_parents(fine.nodes[k], n, [&](const Coordinates& parent, const Coordinates& place) {
                    double weight = static_cast<double>(fine.weights[k]);
                    for (const int a : place) weight *= line[static_cast<std::size_t>(a)];
                    made[parent] += weight;
                });
            for (std::size_t k = 0; k < coarse.nodes.size(); ++k) {
                EXPECT_NEAR(made[coarse.nodes[k]], coarse.weights[k], tolerance);
                made.erase(coarse.nodes[k]);
            }
            for (const auto& [node, weight] : made) EXPECT_NEAR(weight, 0, tolerance);
        }
    }

    /// sum S = 1, sum grad S = 0, sum S x_i = x_p, sum grad S (x) x_i = I; no node past the ghosts.
    void stencil_reproduces_linear_functions() const {
        const Vector cell = patch_.cell_size().template cast<Real>();
        for (Index p = 0; p < size(); ++p) {
            const auto s = stencil(p);
            Real sum = 0;
            Vector gradient = Vector::Zero(), first_moment = Vector::Zero();
            Matrix slope = Matrix::Zero();
            for (std::size_t k = 0; k < s.nodes.size(); ++k) {
                const Vector arm = cloud_.arm(s.nodes[k], p);
                sum += s.weights[k];
                gradient += s.gradients[k];
                first_moment += s.weights[k] * arm;
                slope += s.gradients[k] * arm.transpose();
                for (std::size_t a = 0; a < d; ++a) {
                    ASSERT_GE(s.nodes[k][a], -1);
                    ASSERT_LE(s.nodes[k][a], patch_.cells()[a] + 1);
                }
                EXPECT_GE(s.weights[k], -tolerance);
            }
            EXPECT_NEAR(sum, 1, tolerance);
            EXPECT_LE(gradient.cwiseProduct(cell).norm(), tolerance);
            EXPECT_LE(first_moment.cwiseQuotient(cell).norm(), tolerance);
            const Matrix scaled = cell.asDiagonal() * slope * cell.cwiseInverse().asDiagonal();
            EXPECT_LE((scaled - Matrix::Identity()).norm(), 10 * tolerance);
        }
    }

    void gradient_is_the_derivative() const {
        const double step = std::cbrt(eps);  // in cells
        for (Index p = 0; p < size(); ++p) {
            const auto s = stencil(p);
            for (int a = 0; a < d; ++a) {
                Position shift = Position::Zero();
                shift[a] = step * patch_.cell_size()[a];
                const auto behind = weights_at(cloud_.particles.position(p) - shift, p);
                const auto ahead = weights_at(cloud_.particles.position(p) + shift, p);
                if (behind.begin()->first != ahead.begin()->first) continue;  // the derivative may jump there
                for (std::size_t k = 0; k < s.nodes.size(); ++k) {
                    const auto rise = static_cast<double>(ahead.at(s.nodes[k]) - behind.at(s.nodes[k]));
                    const auto slope = static_cast<double>(s.gradients[k][a]) * patch_.cell_size()[a];
                    EXPECT_NEAR(slope, rise / (2 * step), 10 * step) << "axis " << a << ", node " << k;
                }
            }
        }
    }

    /// With ghosts folded as at open faces: sum 1, no ghosts, none negative, linear functions exact.
    void weights_are_right_up_to_the_edge() const {
        for (Index p = 0; p < size(); ++p) {
            const auto s = stencil(p);
            for (std::size_t a = 0; a < d; ++a) {
                const int base = s.nodes.front()[a], width = s.nodes.back()[a] - base + 1;
                std::vector<Real> weights(static_cast<std::size_t>(width));
                for (std::size_t k = 0; k < s.nodes.size(); ++k)
                    weights[static_cast<std::size_t>(s.nodes[k][a] - base)] += s.weights[k];
                fold_open_edge(base, width, patch_.cells()[a], weights.data());
                Real sum = 0, mean = 0;
                for (int k = 0; k < width; ++k) {
                    const Real weight = weights[static_cast<std::size_t>(k)];
                    EXPECT_GE(weight, -tolerance);
                    if (base + k < 0 || base + k > patch_.cells()[a]) {
                        EXPECT_EQ(weight, 0);
                    }
                    sum += weight;
                    mean += weight * static_cast<Real>(base + k);
                }
                EXPECT_NEAR(sum, 1, tolerance);
                const auto axis = static_cast<int>(a);
                const double xi =
                    (cloud_.particles.position(p)[axis] - patch_.min()[axis]) / patch_.cell_size()[axis];
                EXPECT_NEAR(mean, xi, 10 * tolerance);
            }
        }
    }

    void base_nodes_begin_the_stencils() const {
        std::vector<Coordinates> bases(static_cast<std::size_t>(size()));
        shape_.base_nodes(patch_, cloud_.particles, 0, size(), bases.data());
        for (Index p = 0; p < size(); ++p) {
            const auto s = stencil(p);
            EXPECT_EQ(bases[static_cast<std::size_t>(p)], s.nodes.front());
            for (std::size_t a = 0; a < d; ++a) {
                EXPECT_LE(s.nodes.back()[a] - s.nodes.front()[a] + 1, shape_.width());
            }
        }
    }

    void scatter_agrees_with_stencil() {
        enum class Sent { velocity, extended_velocity, grid_velocity };
        for (const Sent sent : {Sent::velocity, Sent::extended_velocity, Sent::grid_velocity}) {
            clear();
            const bool affine = sent == Sent::extended_velocity;
            Scatter what{.mass = true, .momentum = NodeField::velocity, .internal_force = true};
            if (affine) what.affine_slot = cloud_.particles.slot(Field::velocity_gradient);
            if (sent == Sent::grid_velocity) what.velocity_slot = cloud_.particles.slot(Field::grid_velocity);
            const Field field = sent == Sent::grid_velocity ? Field::grid_velocity : Field::velocity;
            shape_.scatter(patch_, cloud_.particles, 0, size() / 2, what);
            shape_.scatter(patch_, cloud_.particles, size() / 2, size(), what);
            auto mass = zeros(1), momentum = zeros(d), force = zeros(d);
            for (Index p = 0; p < size(); ++p) {
                const auto s = stencil(p);
                for (std::size_t k = 0; k < s.nodes.size(); ++k) {
                    const auto i = static_cast<std::size_t>(patch_.node_index(s.nodes[k]));
                    const Vector v =
                        cloud_.particles.vector(field, p) +
                        (affine ? Vector(extension(p) * cloud_.arm(s.nodes[k], p)) : Vector(Vector::Zero()));
                    const Vector f = -particle(Field::volume, p) * traction(p, s.weights[k], s.gradients[k]);
                    mass[0][i] += s.weights[k] * particle(Field::mass, p);
                    for (std::size_t c = 0; c < d; ++c) {
                        momentum[c][i] += s.weights[k] * particle(Field::mass, p) * v[static_cast<int>(c)];
                        force[c][i] += f[static_cast<int>(c)];
                    }
                }
            }
            expect_equal(NodeField::mass, mass);
            expect_equal(NodeField::velocity, momentum);
            expect_equal(NodeField::force, force);
        }
    }

    void scatter_conserves() {
        clear();
        shape_.scatter(patch_, cloud_.particles, 0, size(), {.mass = true, .momentum = NodeField::velocity});
        double mass = 0;
        for (Index p = 0; p < size(); ++p) mass += static_cast<double>(particle(Field::mass, p));
        EXPECT_NEAR(total(NodeField::mass, 0), mass, sum_tolerance * mass);
        for (int c = 0; c < d; ++c) {
            double momentum = 0;
            for (Index p = 0; p < size(); ++p)
                momentum += static_cast<double>(particle(Field::mass, p) * velocity(p)[c]);
            EXPECT_NEAR(total(NodeField::velocity, c), momentum, sum_tolerance * mass);
        }
    }

    void only_what_is_asked_for_changes() {
        const auto sum = [&](NodeField field) {
            double norm = 0;
            for (int c = 0; c < Patch<S>::components(field); ++c)
                for (Index i = 0; i < patch_.node_count(); ++i)
                    norm += std::abs(static_cast<double>(patch_.column(field, c)[i]));
            return norm;
        };
        const std::pair<Scatter, NodeField> requests[] = {
            {{.mass = true}, NodeField::mass},
            {{.momentum = NodeField::remapped_velocity}, NodeField::remapped_velocity},
            {{.internal_force = true}, NodeField::force},
        };
        for (const auto& [what, target] : requests) {
            clear();
            shape_.scatter(patch_, cloud_.particles, 0, size(), what);
            for (int f = 0; f < node_fields; ++f) {
                const auto field = static_cast<NodeField>(f);
                EXPECT_EQ(sum(field) > 0, field == target) << node_field_name(field);
            }
        }
    }

    void gather_agrees_with_stencil() {
        randomise_nodes();
        const auto record = gather({NodeField::velocity, true, NodeField::remapped_velocity, true});
        for (Index p = 0; p < size(); ++p) {
            const auto s = stencil(p);
            Vector v = Vector::Zero(), a = Vector::Zero(), remapped = Vector::Zero(),
                   inertia = Vector::Zero();
            Matrix gradient = Matrix::Zero(), b = Matrix::Zero();
            for (std::size_t k = 0; k < s.nodes.size(); ++k) {
                const Vector arm = cloud_.arm(s.nodes[k], p), nodal = node(NodeField::velocity, s.nodes[k]);
                v += s.weights[k] * nodal;
                a += s.weights[k] * node(NodeField::acceleration, s.nodes[k]);
                remapped += s.weights[k] * node(NodeField::remapped_velocity, s.nodes[k]);
                gradient += node(NodeField::remapped_velocity, s.nodes[k]) * s.gradients[k].transpose();
                b += s.weights[k] * nodal * arm.transpose();
                inertia += s.weights[k] * arm.cwiseProduct(arm);
            }
            const auto& entry = record.entries[static_cast<std::size_t>(p)];
            EXPECT_LE((entry.velocity - v).norm(), tolerance);
            EXPECT_LE((entry.acceleration - a).norm(), tolerance);
            for (int c = 0; c < d * d; ++c)
                EXPECT_NEAR(entry.gradient[static_cast<std::size_t>(c)], gradient.data()[c], 20 * tolerance);
            if constexpr (S::axisymmetric) {
                const double hoop = static_cast<double>(remapped[0]) / cloud_.particles.position(p)[0];
                EXPECT_NEAR(entry.gradient[d * d], hoop, 10 * tolerance * (1 + std::abs(hoop)));
            }
            const Matrix affine = b * inertia.cwiseInverse().asDiagonal();
            EXPECT_LE((entry.affine - affine).norm(), 100 * tolerance * affine.norm());
        }
    }

    /// sum_i (sum_p S m v_p) f_i = sum_p m v_p sum_i S f_i.
    void gather_is_the_transpose_of_scatter() {
        randomise_nodes();
        const auto record = gather({.velocity = NodeField::velocity});
        patch_.clear(NodeField::force);
        shape_.scatter(patch_, cloud_.particles, 0, size(), {.momentum = NodeField::force});
        double nodes = 0, particles = 0, scale = 0;
        for (int c = 0; c < d; ++c)
            for (Index i = 0; i < patch_.node_count(); ++i)
                nodes += static_cast<double>(patch_.column(NodeField::force, c)[i]) *
                         static_cast<double>(patch_.column(NodeField::velocity, c)[i]);
        for (Index p = 0; p < size(); ++p) {
            const Vector momentum = particle(Field::mass, p) * velocity(p);
            particles +=
                static_cast<double>(momentum.dot(record.entries[static_cast<std::size_t>(p)].velocity));
            scale += static_cast<double>(momentum.norm());
        }
        EXPECT_NEAR(nodes, particles, sum_tolerance * scale);
    }

    void affine_velocity_of_a_linear_field_is_its_gradient() {
        Matrix slope;
        for (int c = 0; c < d * d; ++c) slope.data()[c] = static_cast<Real>(c + 1);
        set_nodes(patch_, NodeField::velocity, [&](const Vector& x) -> Vector { return slope * x; });
        const auto record = gather({.gradient = NodeField::velocity, .affine = true});
        for (const auto& entry : record.entries) {
            EXPECT_LE((entry.affine - slope).norm(), 200 * tolerance * slope.norm());
            for (int c = 0; c < d * d; ++c)
                EXPECT_NEAR(entry.gradient[static_cast<std::size_t>(c)], slope.data()[c],
                            50 * tolerance * static_cast<double>(slope.norm()));
        }
    }

    void batches_are_in_order() {
        randomise_nodes();
        Record<S> record;
        shape_.gather(patch_, cloud_.particles, 5, size() - 3, {.velocity = NodeField::velocity}, record);
        Index next = 5;
        for (const auto& [begin, count] : record.batches) {
            EXPECT_EQ(begin, next);
            EXPECT_GT(count, 0);
            EXPECT_LE(count, batch_size);
            next += count;
        }
        EXPECT_EQ(next, size() - 3);
    }

    void spread_agrees_with_stencil() {
        clear();
        std::vector<PointSource<S>> sources;
        for (Index p = 0; p < size(); p += 7)
            sources.push_back({cloud_.particles.position(p), cloud_.half_size(p), velocity(p)});
        shape_.spread(patch_, sources, NodeField::external_force);
        auto expected = zeros(d);
        for (const auto& source : sources) {
            const auto s = shape_.stencil(patch_, source.position, source.half_size);
            for (std::size_t k = 0; k < s.nodes.size(); ++k)
                for (std::size_t c = 0; c < d; ++c)
                    expected[c][static_cast<std::size_t>(patch_.node_index(s.nodes[k]))] +=
                        s.weights[k] * source.value[static_cast<int>(c)];
        }
        expect_equal(NodeField::external_force, expected);
    }

  private:
    using NodeColumns = std::vector<std::vector<Real>>;

    Index size() const { return cloud_.particles.size(); }
    auto stencil(Index p) const {
        return shape_.stencil(patch_, cloud_.particles.position(p), cloud_.half_size(p));
    }
    std::map<Coordinates, Real> weights_at(const Position& x, Index p) const {
        const auto s = shape_.stencil(patch_, x, cloud_.half_size(p));
        std::map<Coordinates, Real> weights;
        for (std::size_t k = 0; k < s.nodes.size(); ++k) weights[s.nodes[k]] = s.weights[k];
        return weights;
    }
    Real particle(Field field, Index p) const { return cloud_.particles.column(field)[p]; }
    Vector velocity(Index p) const { return cloud_.particles.velocity(p); }
    Matrix extension(Index p) const {
        Matrix a;
        for (int c = 0; c < d * d; ++c) a.data()[c] = cloud_.particles.column(Field::velocity_gradient, c)[p];
        return a;
    }
    bool is_within(const Coordinates& first, const Coordinates& last) const {
        for (std::size_t a = 0; a < d; ++a)
            if (first[a] < 1 || last[a] >= patch_.cells()[a]) return false;
        return true;
    }
    /// The coarser nodes whose functions a finer one is a part of, and the places of its coefficients.
    template <class Visit>
    static void visit_parents(const Coordinates& node, int n, const Visit& visit) {
        Coordinates place;
        place.fill(0);
        for (;;) {
            Coordinates parent;
            bool whole = true;
            for (std::size_t a = 0; a < d; ++a) {
                // place - (n - 1) / 2 is the distance from twice the parent, in halves where nodes are
                // centred.
                const int twice = node[a] + n / 2 - place[a];
                whole = whole && twice % 2 == 0;
                parent[a] = twice / 2;
            }
            if (whole) visit(parent, place);
            std::size_t a = 0;
            while (a < d && place[a] == n - 1) place[a++] = 0;
            if (a == d) return;
            ++place[a];
        }
    }
    /// sigma grad S, and S sigma_hoop / r.
    Vector traction(Index p, Real weight, const Vector& gradient) const {
        const Tensor<S> stress = ParticleBatch<S>::load_stress(cloud_.particles, p);
        Vector t = stress.plane * gradient;
        if constexpr (S::axisymmetric)
            t[0] += weight * stress.normal / cloud_.particles.column(Field::position, 0)[p];
        return t;
    }
    Vector node(NodeField field, const Coordinates& node) const {
        Vector v;
        for (int c = 0; c < d; ++c) v[c] = patch_.column(field, c)[patch_.node_index(node)];
        return v;
    }
    double total(NodeField field, int component) const {
        const Real* column = patch_.column(field, component);
        return std::accumulate(column, column + patch_.node_count(), 0.0);
    }
    NodeColumns zeros(std::size_t components) const {
        return NodeColumns(components, std::vector<Real>(static_cast<std::size_t>(patch_.node_count())));
    }
    void clear() {
        for (int f = 0; f < node_fields; ++f) patch_.clear(static_cast<NodeField>(f));
    }
    void randomise_nodes() {
        std::mt19937 random(11);
        std::uniform_real_distribution<Real> value(-1, 1);
        for (const NodeField field :
             {NodeField::velocity, NodeField::acceleration, NodeField::remapped_velocity})
            set_nodes(patch_, field, [&](const Vector&) -> Vector {
                return Vector::NullaryExpr([&] { return value(random); });
            });
    }
    Record<S> gather(const Gather& what) const {
        Record<S> record;
        shape_.gather(patch_, cloud_.particles, 0, size(), what, record);
        EXPECT_EQ(record.entries.size(), static_cast<std::size_t>(size()));
        return record;
    }
    void expect_equal(NodeField field, const NodeColumns& expected) const {
        for (std::size_t c = 0; c < expected.size(); ++c) {
            Real largest = 0;
            for (const Real x : expected[c]) largest = std::max(largest, std::abs(x));
            for (std::size_t i = 0; i < expected[c].size(); ++i)
                ASSERT_NEAR(patch_.column(field, static_cast<int>(c))[i], expected[c][i],
                            tolerance * static_cast<double>(largest))
                    << node_field_name(field) << ", component " << c << ", place " << i;
        }
    }

    ShapeFunction<S>& shape_;
    Patch<S> patch_;
    ParticleCloud<S> cloud_;
};

/// Runs all checks in all spaces. `own`: the shape function's object as in a resolved scene.
inline void check_shape_function(const Registry& registry, const Json& own) {
    each_failure_once([&] {
        in_every_space([&]<class S>(const std::string& space) {
            SCOPED_TRACE(own.dump() + ", " + space);
            const Parameters::Context context{SpaceId::of<S>(), ".", &registry, nullptr};
            const auto shape = registry.make<ShapeFunction<S>>("shape_function", own, context);
            for (const double stretch : {1.1, 2.0}) ShapeFunctionChecks<S>(*shape, stretch).all();
        });
    });
}

}  // namespace matpoint::conformance
