#include "shape_function_conformance.hpp"

#include "every_plugin.hpp"
#include "plugins.hpp"

#include <Eigen/Geometry>

namespace matpoint::conformance {
namespace {

std::vector<Json> every_shape() {
    std::vector<Json> shapes = every_plugin("shape_function");
    for (const char* domain : {"stretched", "uniform"})
        shapes.push_back({{"type", "gimp"}, {"domain", domain}});
    shapes.push_back({{"type", "bspline"}, {"order", 3}});
    return shapes;
}

class EveryShapeFunction : public testing::TestWithParam<Json> {};

TEST_P(EveryShapeFunction, Conforms) {
    PluginCatalogue catalogue;
    catalogue.find("shape_function", GetParam().at("type"));
    check_shape_function(catalogue.registry(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Plugins, EveryShapeFunction, testing::ValuesIn(every_shape()),
                         [](const auto& shape) {
                             std::string name;
                             for (const auto& [key, value] : shape.param.items())
                                 name += (name.empty() ? "" : "_") + (value.is_string()
                                                                          ? value.template get<std::string>()
                                                                          : key + value.dump());
                             return name;
                         });

/// Nodes 0 … 8 at distances of 0.5.
Patch<Bar> line() {
    Patch<Bar> patch({0, 0, 0}, {0.5, 1, 1}, {8});
    patch.set_blocks({0});
    return patch;
}
double weight(const ShapeFunction<Bar>& shape, double x, double half_size, int node, bool gradient = false) {
    using Vector = Bar::Vector;
    const auto s = shape.stencil(line(), Vector(x), Vector(half_size));
    for (std::size_t k = 0; k < s.nodes.size(); ++k)
        if (s.nodes[k][0] == node) return gradient ? s.gradients[k][0] : s.weights[k];
    return 0;
}
const Json contiguous{{"type", "gimp"}, {"domain", "contiguous"}},
    uniform{{"type", "gimp"}, {"domain", "uniform"}};

/// The closed form [Wallstedt & Guilkey 2008, eq. 5, 6].
TEST(Gimp, FollowsTheFormula) {
    const auto shape = make<ShapeFunction<Bar>>("shape_function", contiguous);
    const double h = 0.5, x_i = 1.5;
    for (const double l : {0.05, 0.125, 0.25})
        for (double x = 0.7; x < 2.3; x += 0.0137) {
            const double r = std::abs(x - x_i), side = x < x_i ? 1 : -1;
            double s = 0, g = 0;
            if (r <= l)
                s = 1 - (r * r + l * l) / (2 * h * l), g = side * r / (h * l);
            else if (r <= h - l)
                s = 1 - r / h, g = side / h;
            else if (r <= h + l)
                s = (h + l - r) * (h + l - r) / (4 * h * l), g = side * (h + l - r) / (2 * h * l);
            EXPECT_NEAR(weight(*shape, x, l, 3), s, 1e-14);
            EXPECT_NEAR(weight(*shape, x, l, 3, true), g, 1e-13);
        }
}

/// Particles of one body with these half-lengths, at x = 1.6, after the start of a step.
Particles<Bar> particles_of(ShapeFunction<Bar>& shape, std::vector<double> half_sizes, double stretch = 1) {
    Particles<Bar> particles("body");
    shape.declare(particles);
    particles.resize(static_cast<Index>(half_sizes.size()));
    std::ranges::fill_n(particles.column(Field::position), particles.size(), 1.6);
    std::ranges::copy(half_sizes, particles.column(Field::half_size));
    if (particles.has(Field::initial_half_size))
        std::ranges::copy(half_sizes, particles.column(Field::initial_half_size));
    if (particles.has(Field::displacement_gradient))
        std::ranges::fill_n(particles.column(Field::displacement_gradient), particles.size(), stretch - 1);
    shape.start_step(line(), particles);
    return particles;
}

TEST(Gimp, WidensForDomainsLargerThanACell) {
    const auto shape = make<ShapeFunction<Bar>>("shape_function", contiguous);
    auto body = particles_of(*shape, {0.1, 0.25});
    EXPECT_EQ(shape->width(), 3);
    auto other = particles_of(*shape, {0.1, 0.26});
    EXPECT_EQ(shape->width(), 4);
    // Each body has its own width, so that its results do not depend on the others.
    const auto base = [&](Particles<Bar>& particles) {
        particles.column(Field::position)[0] = 1.8;
        Patch<Bar>::Coordinates node;
        shape->base_nodes(line(), particles, 0, 1, &node);
        return node[0];
    };
    EXPECT_EQ(base(body), 3);
    EXPECT_EQ(base(other), 2);
}

/// Against the integral of eq. 1, summed.
TEST(Gimp, AveragesExactlyOverLargeDomains) {
    const auto shape = make<ShapeFunction<Bar>>("shape_function", contiguous);
    particles_of(*shape, {0.4});
    ASSERT_EQ(shape->width(), 4);
    const double h = 0.5;
    const auto average = [&](double x, double l, int node) {
        double sum = 0;
        const int n = 4000;
        for (int k = 0; k < n; ++k)
            sum += std::max(0.0, 1 - std::abs(x - l + (k + 0.5) * 2 * l / n - node * h) / h) / n;
        return sum;
    };
    for (const double l : {0.1, 0.3, 0.4, 0.5})
        for (double x = 0.63; x < 3; x += 0.077)
            for (int node = 0; node < 8; ++node)
                EXPECT_NEAR(weight(*shape, x, l, node), average(x, l, node), 1e-6);
    EXPECT_EQ(weight(*shape, 1.6, 0.9, 3), weight(*shape, 1.6, 0.5, 3));  // the limit
}

TEST(Gimp, ContiguousDomainsFollowTheDeformation) {
    const auto shape = make<ShapeFunction<Bar>>("shape_function", contiguous);
    EXPECT_DOUBLE_EQ(particles_of(*shape, {0.1}, 1.5).column(Field::half_size)[0], 0.15);
    EXPECT_DOUBLE_EQ(particles_of(*shape, {0.1}, 0.01).column(Field::half_size)[0], 0.005);
    EXPECT_DOUBLE_EQ(particles_of(*shape, {0.1}, -0.5).column(Field::half_size)[0], 0.05);
    const auto fixed = make<ShapeFunction<Bar>>("shape_function", uniform);
    const auto particles = particles_of(*fixed, {0.1}, 1.5);
    EXPECT_FALSE(particles.has(Field::displacement_gradient));
    EXPECT_DOUBLE_EQ(particles.column(Field::half_size)[0], 0.1);
}

/// Half-lengths at the start of a step, of a domain that began with `initial` and is deformed by `f`.
Eigen::Vector2d stretched_domain(const Eigen::Matrix2d& f, const Eigen::Vector2d& initial) {
    const auto shape =
        make<ShapeFunction<PlaneStrain>>("shape_function", {{"type", "gimp"}, {"domain", "stretched"}});
    Particles<PlaneStrain> particles("body");
    shape->declare(particles);
    particles.resize(1);
    for (int a = 0; a < 2; ++a) *particles.column(Field::initial_half_size, a) = initial[a];
    ParticleBatch<PlaneStrain>::store_displacement_gradient(particles, 0, {f - Eigen::Matrix2d::Identity()});
    shape->start_step(make_patch<PlaneStrain>(), particles);
    return particles.vector(Field::half_size, 0);
}

TEST(Gimp, StretchedDomainsFollowStretchesButNotTurns) {
    const Eigen::Vector2d square(0.1, 0.1), oblong(0.1, 0.2);
    const Eigen::Matrix2d stretch = Eigen::Vector2d(1.5, 0.8).asDiagonal();
    EXPECT_LT((stretched_domain(stretch, oblong) - Eigen::Vector2d(0.15, 0.16)).norm(), 1e-15);  // eq. 63
    for (double angle = 0; angle < 7; angle += 0.1)
        EXPECT_LT((stretched_domain(Eigen::Rotation2Dd(angle).matrix(), square) - square).norm(), 1e-15);
    const Eigen::Matrix2d quarter = Eigen::Rotation2Dd(std::acos(-1.0) / 2).matrix();
    EXPECT_LT((stretched_domain(quarter * stretch, oblong) - Eigen::Vector2d(0.16, 0.15)).norm(), 1e-15);
}

/// A box of half-lengths l has the second moments l^2 / 3; those of the deformed domain by Gauss points.
TEST(Gimp, StretchedDomainsKeepSecondMoments) {
    const Eigen::Matrix2d f{{1.2, 0.5}, {-0.3, 0.7}};
    const Eigen::Vector2d initial(0.1, 0.2);
    Eigen::Array2d moments = Eigen::Array2d::Zero();
    for (const double xi : {-1.0, 1.0})
        for (const double eta : {-1.0, 1.0}) {
            const Eigen::Vector2d point =
                f * Eigen::Vector2d(xi * initial[0], eta * initial[1]) / std::sqrt(3.0);
            moments += point.array().square() / 4;
        }
    EXPECT_LT((stretched_domain(f, initial).array().square() / 3 - moments).matrix().norm(), 1e-16);
}

TEST(Gimp, WithOneParticleACellIsTheQuadraticSpline) {
    const auto gimp = make<ShapeFunction<Bar>>("shape_function", uniform);
    const auto spline = make<ShapeFunction<Bar>>("shape_function", {{"type", "bspline"}, {"order", 2}});
    for (double x = 0.02; x < 4; x += 0.031)
        for (int node = -1; node < 10; ++node)
            for (const bool gradient : {false, true})
                EXPECT_NEAR(weight(*gimp, x, 0.25, node, gradient), weight(*spline, x, 0, node, gradient),
                            1e-14);
}

/// The derivative of a cubic B-spline is the difference of two quadratic ones.
TEST(BSpline, CubicFollowsFromQuadratic) {
    const auto quadratic = make<ShapeFunction<Bar>>("shape_function", {{"type", "bspline"}, {"order", 2}});
    const auto cubic = make<ShapeFunction<Bar>>("shape_function", {{"type", "bspline"}, {"order", 3}});
    const double h = 0.5;
    for (double x = 0.6; x < 3.2; x += 0.0171)
        for (int node = 0; node < 8; ++node)
            EXPECT_NEAR(weight(*cubic, x, 0, node, true),
                        (weight(*quadratic, x + h / 2, 0, node) - weight(*quadratic, x - h / 2, 0, node)) / h,
                        1e-13);
    EXPECT_NEAR(weight(*cubic, 1.5, 0, 3), 2.0 / 3, 1e-15);
    EXPECT_NEAR(weight(*cubic, 1.5, 0, 4), 1.0 / 6, 1e-15);
}

}  // namespace
}  // namespace matpoint::conformance
