#include <matpoint/load.hpp>

#include "plugins.hpp"

#include <cmath>
#include <numbers>

namespace matpoint::conformance {
namespace {

/// Multilinear interpolation, one node at a time.
template <class S>
class Tent final : public ShapeFunction<S> {
  public:
    using typename ShapeFunction<S>::Vector;
    using typename ShapeFunction<S>::Position;
    using typename ShapeFunction<S>::Real;
    using typename ShapeFunction<S>::Coordinates;
    using typename ShapeFunction<S>::Stencil;

    int width() const override { return 2; }
    void base_nodes(const Patch<S>&, const Particles<S>&, Index, Index, Coordinates*) const override {}
    Coordinates base_node(const Patch<S>&, const Particles<S>&, const Position&) const override { return {}; }
    void scatter(Patch<S>&, const Particles<S>&, Index, Index, const Scatter&) const override {}
    void gather(const Patch<S>&, const Particles<S>&, Index, Index, const Gather&,
                GatherSink<S>&) const override {}
    void spread(Patch<S>& patch, std::span<const PointSource<S>> sources, NodeField field) const override {
        for (const PointSource<S>& source : sources) {
            const Stencil s = stencil(patch, source.position, source.half_size);
            for (std::size_t k = 0; k < s.nodes.size(); ++k)
                for (int a = 0; a < S::dimension; ++a)
                    patch.column(field, a)[patch.node_index(s.nodes[k])] += s.weights[k] * source.value[a];
        }
    }
    Stencil stencil(const Patch<S>& patch, const Position& position, const Vector&) const override {
        const Position cells = (position - patch.min()).cwiseQuotient(patch.cell_size());
        Stencil s;
        for (int corner = 0; corner < 1 << S::dimension; ++corner) {
            Coordinates node;
            Real weight = 1;
            for (int a = 0; a < S::dimension; ++a) {
                const int upper = corner >> a & 1;
                node[static_cast<std::size_t>(a)] = static_cast<int>(std::floor(cells[a])) + upper;
                const auto part = static_cast<Real>(cells[a] - std::floor(cells[a]));
                weight *= upper ? part : 1 - part;
            }
            s.nodes.push_back(node);
            s.weights.push_back(weight);
        }
        return s;
    }
};

/// A block from (1, 0.25, 0.25) to (2, 0.75, 0.75), particles of 0.1 x 0.125 x 0.25, on a grid from 0
/// to 3 with cells of 0.5; its nodes carry its mass, at density 1.
template <class S>
struct Block {
    using Real = typename S::Real;
    using Vector = typename S::Vector;
    static constexpr int d = S::dimension;

    explicit Block(const Json& own, bool deforms = false) : load(make<Load<S>>("load", own)) {
        Particles<S>& particles = bodies[0];
        if (deforms) particles.require(Field::displacement_gradient);
        for (auto& body : bodies) load->declare(body);
        if (!particles.has(Field::initial_half_size)) particles.require(Field::initial_half_size);
        particles.resize(d == 1 ? 10 : d == 2 ? 40 : 80);
        for (Index p = 0; p < particles.size(); ++p) {
            const Index place[] = {p % 10, p / 10 % 4, p / 40};
            Real volume = 1;
            for (int a = 0; a < d; ++a) {
                particles.column(Field::initial_half_size, a)[p] = static_cast<Real>(size[a] / 2);
                particles.column(Field::position, a)[p] =
                    static_cast<Real>((a == 0 ? 1 : 0.25) + (static_cast<double>(place[a]) + 0.5) * size[a]);
                volume *= static_cast<Real>(size[a]);
            }
            if (S::axisymmetric) volume *= static_cast<Real>(2 * std::numbers::pi * particles.position(p)[0]);
            particles.column(Field::mass)[p] = particles.column(Field::volume)[p] = volume;
        }
        std::vector<int> all;
        int count = 1;
        for (const int blocks : patch.blocks()) count *= blocks;
        for (int i = 0; i < count; ++i) all.push_back(i);
        patch.require(NodeField::external_force);
        patch.set_blocks(all);
        load->start(patch, bodies);
    }

    void apply(double time = 0) {
        patch.clear(NodeField::mass);
        patch.clear(NodeField::external_force);
        for (Index p = 0; p < bodies[0].size(); ++p) {
            const auto s = shape.stencil(patch, bodies[0].position(p), {});
            for (std::size_t k = 0; k < s.nodes.size(); ++k)
                patch.column(NodeField::mass)[patch.node_index(s.nodes[k])] +=
                    s.weights[k] * bodies[0].column(Field::mass)[p];
        }
        LoadContext<S> context{time, patch, bodies, shape};
        load->apply(context);
    }

    double force(int component) const {
        double sum = 0;
        for (Index i = 0; i < patch.node_count(); ++i)
            sum += static_cast<double>(patch.column(NodeField::external_force, component)[i]);
        return sum;
    }
    /// Where the force acts: its mean position along an axis.
    double centre(int component, int axis) const {
        double sum = 0;
        for (Index i = 0; i < patch.node_count(); ++i)
            sum += static_cast<double>(patch.column(NodeField::external_force, component)[i]) *
                   patch.node_position(patch.node_coordinates(static_cast<int>(i)))[axis];
        return sum / force(component);
    }
    void deform(const typename S::Matrix& f) {
        for (Index p = 0; p < bodies[0].size(); ++p)
            ParticleBatch<S>::store_displacement_gradient(bodies[0], p, {f - S::Matrix::Identity()});
    }

    static constexpr double size[] = {0.1, 0.125, 0.25};
    static constexpr double tolerance = 20 * std::numeric_limits<Real>::epsilon();

    std::shared_ptr<Load<S>> load;
    std::array<Particles<S>, 2> bodies{Particles<S>("block"), Particles<S>("bystander")};
    Patch<S> patch = make_patch();
    Tent<S> shape;

    static Patch<S> make_patch() {
        typename Patch<S>::Coordinates cells;
        cells.fill(6);
        return Patch<S>({0, 0, 0}, {0.5, 0.5, 0.5}, cells);
    }
};

const Json step = {{"type", "step"}, {"start", 0}};

Json traction(const std::string& face, const std::string& method, std::vector<double> value) {
    return {{"type", "traction"}, {"body", "block"},   {"face", face},
            {"method", method},   {"traction", value}, {"history", step}};
}

/// Areas of the sides normal to x, y, z.
template <class S>
std::vector<double> areas(bool upper) {
    if constexpr (S::dimension == 1) return {1};
    if constexpr (S::axisymmetric)
        return {2 * std::numbers::pi * (upper ? 2 : 1) * 0.5, std::numbers::pi * (2 * 2 - 1)};
    if constexpr (S::dimension == 2) return {0.5, 1};
    return {0.5 * 0.5, 0.5, 0.5};
}

template <class S>
void check_total_force() {
    const std::vector<double> value{3, -2, 5};
    for (int axis = 0; axis < S::dimension; ++axis) {
        for (const bool upper : {false, true}) {
            const std::string face =
                std::string(1, static_cast<char>('x' + axis)) + (upper ? "_max" : "_min");
            Json layer = traction(face, "boundary_layer", value), thick = layer;
            thick["thickness"] = 0.21;
            for (const Json& own : {traction(face, "surface_point", value), layer, thick}) {
                SCOPED_TRACE(own.dump());
                Block<S> block(own);
                block.apply();
                for (int a = 0; a < S::dimension; ++a) {
                    const double expected =
                        value[static_cast<std::size_t>(a)] * areas<S>(upper)[static_cast<std::size_t>(axis)];
                    EXPECT_NEAR(block.force(a), expected, block.tolerance * std::abs(expected));
                }
            }
        }
    }
}

TEST(Traction, TotalForceIsTractionTimesArea) {
#define CHECK_TOTAL_FORCE(S) check_total_force<S>();
    MATPOINT_FOR_EACH_SPACE(CHECK_TOTAL_FORCE)
}

/// A layer's force acts in its middle, a surface's on the surface.
TEST(Traction, MethodsDifferInWhereTheForceActs) {
    Json thick = traction("x_max", "boundary_layer", {1, 0});
    thick["thickness"] = 0.4;
    Block<PlaneStrain> surface(traction("x_max", "surface_point", {1, 0})),
        layer(traction("x_max", "boundary_layer", {1, 0})), thick_layer(thick);
    for (auto* block : {&surface, &layer, &thick_layer}) {
        // Off the node at 2, beyond which nothing has mass.
        for (Index p = 0; p < block->bodies[0].size(); ++p)
            block->bodies[0].column(Field::position, 0)[p] -= 0.2;
        block->apply();
        EXPECT_NEAR(block->centre(0, 1), 0.5, 1e-12);
    }
    EXPECT_NEAR(surface.force(0), layer.force(0), 1e-14);
    EXPECT_NEAR(surface.centre(0, 0), 1.8, 1e-12);
    EXPECT_NEAR(layer.centre(0, 0), 1.75, 1e-12);
    EXPECT_NEAR(thick_layer.centre(0, 0), 1.6, 1e-12);
}

TEST(Traction, AreaAndSurfaceFollowTheDeformation) {
    Eigen::Matrix2d f;
    f << 1.5, 0.3, 0, 2;
    for (const std::string method : {"surface_point", "boundary_layer"}) {
        Block<PlaneStrain> block(traction("x_max", method, {1, 0}), true);
        for (Index p = 0; p < block.bodies[0].size(); ++p)
            block.bodies[0].column(Field::position, 0)[p] -= 0.2;
        block.deform(f);
        block.apply();
        const double nanson = (f.determinant() * f.inverse().transpose() * Eigen::Vector2d(1, 0)).norm();
        EXPECT_NEAR(block.force(0), 0.5 * nanson, 1e-14);
        EXPECT_NEAR(block.centre(0, 0), method == "surface_point" ? 1.75 + 1.5 * 0.05 : 1.75, 1e-12);
    }
    Eigen::Matrix3d g;
    g << 1.5, 0.3, 0.1, 0.2, 2, 0, 0.1, 0.4, 0.8;
    Block<Solid> solid(traction("y_min", "surface_point", {0, 1, 0}), true);
    solid.deform(g);
    solid.apply();
    EXPECT_NEAR(solid.force(1),
                0.5 * (g.determinant() * g.inverse().transpose() * Eigen::Vector3d(0, 1, 0)).norm(), 1e-13);
}

/// The surface is past the node at 2, where a tent at the particles themselves gives no mass.
TEST(Traction, NoForceIsLostOnNodesWithoutMass) {
    Block<Bar> bar(traction("x_max", "surface_point", {1}));
    for (Index p = 0; p < bar.bodies[0].size(); ++p) bar.bodies[0].column(Field::position, 0)[p] += 0.02;
    bar.apply();
    double moved = 0;
    for (Index i = 0; i < bar.patch.node_count(); ++i)
        if (bar.patch.column(NodeField::mass)[i] > 0) moved += bar.patch.column(NodeField::external_force)[i];
    EXPECT_NEAR(moved, 1, 1e-14);
}

/// Ten steps of 1 ms don't add up to 10 ms exactly.
TEST(Traction, PulseEndsAtTheFirstStepThatReachesItsEnd) {
    Json own = traction("x_max", "surface_point", {1});
    own["history"] = {{"type", "pulse"}, {"start", 0}, {"duration", 0.01}};
    Block<Bar> bar(own);
    int loaded = 0;
    double time = 0;
    for (int k = 0; k < 20; ++k) {
        bar.apply(time);
        loaded += bar.force(0) > 0 ? 1 : 0;
        time += 1e-3;
    }
    EXPECT_EQ(loaded, 10);
}

TEST(Traction, RefusesWhatDoesNotFit) {
    const Schema schema = schema_of("load", "traction");
    Json own = traction("x_max", "surface_point", {1, 0});
    EXPECT_FALSE(has_rule(schema, true, "/thickness", own));
    own["thickness"] = 0.1;
    EXPECT_TRUE(has_rule(schema, true, "/thickness", own));
    own["method"] = "boundary_layer";
    EXPECT_FALSE(has_rule(schema, true, "/thickness", own));
    EXPECT_FALSE(has_rule(schema, true, "/face", own));
    EXPECT_TRUE(has_rule(schema, true, "/face", traction("z_min", "surface_point", {1, 0})));
}

TEST(History, StartsStepsAndReadsTablesAndFormulas) {
    const auto factor = [](const Json& history, double time) {
        Block<Bar> bar({{"type", "gravity"}, {"acceleration", {1}}, {"history", history}});
        bar.apply(time);
        return bar.force(0);
    };
    EXPECT_NEAR(factor({{"type", "step"}, {"start", 0.5}}, 0.4), 0, 1e-15);
    EXPECT_NEAR(factor({{"type", "step"}, {"start", 0.5}}, 0.5), 1, 1e-14);
    EXPECT_NEAR(factor({{"type", "table"}, {"times", {0, 2}}, {"values", {0, 4}}}, 0.5), 1, 1e-14);
    EXPECT_NEAR(factor({{"type", "formula"}, {"value", "t^2"}}, 3), 9, 1e-13);
}

TEST(History, RefusesWhatDoesNotFit) {
    const Schema schema = *schema_of("load", "gravity").find("history")->nested;
    const auto refuses = [&](const char* pointer, const Json& own) {
        return has_rule(schema, true, pointer, own);
    };
    EXPECT_TRUE(refuses("/duration", {{"type", "pulse"}}));
    EXPECT_TRUE(refuses("/duration", {{"type", "step"}, {"duration", 1}}));
    EXPECT_FALSE(refuses("/duration", {{"type", "pulse"}, {"duration", 1}}));
    EXPECT_TRUE(refuses("/values", {{"type", "table"}, {"times", {0, 1}}}));
    EXPECT_TRUE(refuses("/times", {{"type", "table"}, {"times", {1, 0}}, {"values", {1, 1}}}));
    EXPECT_TRUE(refuses("/times", {{"type", "table"}, {"times", {0, 1}}, {"values", {1}}}));
    EXPECT_FALSE(refuses("/times", {{"type", "table"}, {"times", {0, 1}}, {"values", {1, 1}}}));
    EXPECT_TRUE(refuses("/value", {{"type", "formula"}}));
}

/// Inside, on a face, and in a corner, where the particles are all on one side; then the body is stretched,
/// turned and moved: the whole force, through the point.
template <class S>
void check_point_load() {
    const std::vector<double> force{3, -2, 5};
    for (const std::vector<double>& at :
         {std::vector<double>{1.52, 0.47, 0.5}, {2.0, 0.5, 0.4}, {1.0, 0.25, 0.25}, {1.731, 0.75, 0.75}}) {
        SCOPED_TRACE(Json(at).dump());
        const auto d = static_cast<std::size_t>(S::dimension);
        Block<S> block({{"type", "point_load"},
                        {"body", "block"},
                        {"at", std::vector(at.begin(), at.begin() + S::dimension)},
                        {"force", std::vector(force.begin(), force.begin() + S::dimension)},
                        {"history", {{"type", "step"}, {"start", 0}}}});
        Eigen::Matrix3d f;
        f << 1.1, -0.2, 0.05, 0.25, 0.9, 0.1, -0.1, 0.05, 1.2;
        for (const bool moved : {false, true}) {
            typename S::Position point;
            for (std::size_t a = 0; a < d; ++a) point[static_cast<Index>(a)] = at[a];
            if (moved) {
                const typename S::Position shift = S::Position::Constant(0.3);
                const auto g = f.topLeftCorner<S::dimension, S::dimension>().eval();
                for (Index p = 0; p < block.bodies[0].size(); ++p) {
                    const typename S::Position x = g * block.bodies[0].position(p) + shift;
                    for (int a = 0; a < S::dimension; ++a)
                        block.bodies[0].set_value(Field::position, a, p, x[a]);
                }
                point = g * point + shift;
            }
            block.apply();
            for (int a = 0; a < S::dimension; ++a) {
                const double expected = force[static_cast<std::size_t>(a)];
                EXPECT_NEAR(block.force(a), expected, 2 * block.tolerance * std::abs(expected));
                for (int axis = 0; axis < S::dimension; ++axis)
                    EXPECT_NEAR(block.centre(a, axis), point[axis], 10 * block.tolerance);
            }
        }
    }
}

TEST(PointLoad, IsTheWholeForceThroughThePoint) {
#define CHECK_POINT_LOAD(S) check_point_load<S>();
    MATPOINT_FOR_EACH_SPACE(CHECK_POINT_LOAD)
}

TEST(Gravity, ActsOnTheMassOfEveryNode) {
    Block<Solid> block({{"type", "gravity"}, {"acceleration", {1, -2, 3}}, {"history", step}});
    block.apply();
    EXPECT_NEAR(block.force(1), -2 * 0.25, 1e-14);
    EXPECT_NEAR(block.force(2), 3 * 0.25, 1e-14);
    EXPECT_NEAR(block.centre(0, 0), 1.5, 1e-13);
}

/// Its force, and where that acts, is that of the particles, here or where they were before they moved.
TEST(BodyForce, IsEvaluatedAtParticles) {
    for (const bool material : {false, true}) {
        Block<PlaneStrain> block({{"type", "body_force"},
                                  {"acceleration", {"x^2 + t", "x*y"}},
                                  {"at", "particles"},
                                  {"coordinates", material ? "material" : "present"}});
        Particles<PlaneStrain>& particles = block.bodies[0];
        double force = 0, moment = 0;
        for (Index p = 0; p < particles.size(); ++p) {
            const auto start = particles.position(p);
            if (material)
                for (int a = 0; a < 2; ++a) particles.set_value(Field::initial_position, a, p, start[a]);
            particles.set_value(Field::position, 0, p, start[0] * 1.25 - 0.5);
            const auto present = particles.position(p), x = material ? start : present;
            const double mass = particles.column(Field::mass)[p];
            force += mass * (x[0] * x[0] + 2);
            moment += mass * (present[0] * x[0] * x[1] - present[1] * (x[0] * x[0] + 2));
        }
        block.apply(2);
        EXPECT_NEAR(block.force(0), force, 1e-13);
        EXPECT_NEAR(block.force(1) * block.centre(1, 0) - block.force(0) * block.centre(0, 1), moment, 1e-13);
    }
}

TEST(BodyForce, NodesHaveNoMaterialCoordinates) {
    const Schema schema = schema_of("load", "body_force");
    Json own = {{"acceleration", {"x", 0}}, {"at", "nodes"}, {"coordinates", "material"}};
    EXPECT_TRUE(has_rule(schema, true, "/coordinates", own));
    own["at"] = "particles";
    EXPECT_FALSE(has_rule(schema, true, "/coordinates", own));
}

TEST(BodyForce, IsEvaluatedAtNodes) {
    Block<PlaneStrain> block({{"type", "body_force"},
                              {"acceleration", {"x + y + t", nullptr}},
                              {"at", "nodes"},
                              {"coordinates", "present"}});
    block.apply(2);
    // Linear in position, so the mean over the block is that at its centre (1.5, 0.5).
    EXPECT_NEAR(block.force(0), 0.5 * (1.5 + 0.5 + 2), 1e-14);
    EXPECT_EQ(block.force(1), 0);
}

}  // namespace
}  // namespace matpoint::conformance
