// Particles on the lattice of the grid's cells, in every space, against exact masses and volumes.

#include "particles/seeding.hpp"

#include <gtest/gtest.h>
#include <matpoint/parallel.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <span>
#include <stdexcept>

namespace matpoint {

namespace {

using std::numbers::pi;

/// The region where x, y and z are in [min, max).
class Block final : public Geometry {
  public:
    Block(double min, double max) : min_(min), max_(max) {}
    Bounds bounds() const override {
        return {Eigen::Vector3d::Constant(min_), Eigen::Vector3d::Constant(max_)};
    }
    bool contains(const Eigen::Vector3d& x) const override {
        const auto within = [&](double c) { return c == 0 || (c >= min_ && c < max_); };
        return within(x[0]) && within(x[1]) && within(x[2]);
    }

  private:
    double min_, max_;
};

/// A body of any thickness, which knows where lines meet it.
class Plate final : public Geometry {
  public:
    Plate(double min, double max) : min_(min), max_(max) {}
    Bounds bounds() const override { return {{min_, 0.5, 0.5}, {max_, 1.5, 1.5}}; }
    bool contains(const Eigen::Vector3d& x) const override {
        const auto within = [](double c) { return c == 0 || (c >= 0.5 && c < 1.5); };
        return x[0] >= min_ && x[0] < max_ && within(x[1]) && within(x[2]);
    }
    std::vector<Intervals> along_x(std::span<const Eigen::Vector2d> lines, Interval, double) const override {
        std::vector<Intervals> found;
        for (const Eigen::Vector2d& line : lines)
            found.push_back(contains({min_, line[0], line[1]}) ? Intervals{{min_, max_}} : Intervals{});
        return found;
    }

  private:
    double min_, max_;
};

/// Counts what it is asked.
class CountingBlock final : public Geometry {
  public:
    CountingBlock(double min, double max) : block_(min, max) {}
    Bounds bounds() const override { return block_.bounds(); }
    bool contains(const Eigen::Vector3d&) const override {
        ADD_FAILURE() << "asked for a single point";
        return false;
    }
    std::vector<char> contains(std::span<const Eigen::Vector3d> points) const override {
        ++calls;
        for (const Eigen::Vector3d& x : points)
            EXPECT_TRUE(asked.insert({x[0], x[1], x[2]}).second) << "asked twice for a point";
        return static_cast<const Geometry&>(block_).contains(points);
    }

    mutable int calls = 0;
    mutable std::set<std::array<double, 3>> asked;

  private:
    Block block_;
};

class Cloud final : public Geometry, public PointCloud {
  public:
    explicit Cloud(std::vector<Point> points) : points_(std::move(points)) {}
    Bounds bounds() const override { return {}; }
    bool contains(const Eigen::Vector3d&) const override { return false; }
    const PointCloud* points() const override { return this; }
    Index size() const override { return std::ssize(points_); }
    void read(Index first, std::span<Point> points) const override {
        std::copy_n(points_.begin() + first, points.size(), points.begin());
    }

  private:
    std::vector<Point> points_;
};

/// Cells of 1/4 over [0, 2) along x and [0, 4) along the others.
template <class S>
Patch<S> make_patch() {
    typename Patch<S>::Coordinates cells;
    cells.fill(16);
    cells[0] = 8;
    return Patch<S>({0, 0, 0}, {0.25, 0.25, 0.25}, cells);
}

template <class S>
Particles<S> make_particles() {
    Particles<S> particles("brick");
    for (const Field field : {Field::initial_position, Field::half_size, Field::initial_half_size,
                              Field::displacement_gradient, Field::id})
        particles.require(field);
    return particles;
}

template <class S>
double sum(const Particles<S>& particles, Field field) {
    double total = 0;
    for (Index p = 0; p < particles.size(); ++p) total += static_cast<double>(particles.column(field)[p]);
    return total;
}

template <class F>
std::string error_of(F&& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

template <class S>
class ParticlesSeeding : public testing::Test {};
using Spaces = testing::Types<Bar, PlaneStrain, Axisymmetric, Solid, BarSingle, PlaneStrainSingle,
                              AxisymmetricSingle, SolidSingle>;
TYPED_TEST_SUITE(ParticlesSeeding, Spaces);

TYPED_TEST(ParticlesSeeding, AlignedBoxHasItsMass) {
    using S = TypeParam;
    const double tolerance = sizeof(typename S::Real) == 4 ? 1e-4 : 1e-12;
    auto particles = make_particles<S>();
    seed(particles, make_patch<S>(), Block(0.5, 1.5), {2, 3, 1}, 1000);

    const double volume = S::axisymmetric ? pi * (1.5 * 1.5 - 0.5 * 0.5) : 1.0;  // pi (R^2 - r^2) H, or 1^D
    EXPECT_EQ(particles.size(), S::dimension == 1 ? 8 : S::dimension == 2 ? 96 : 384);
    EXPECT_NEAR(sum(particles, Field::volume), volume, volume * tolerance);
    EXPECT_NEAR(sum(particles, Field::mass), 1000 * volume, 1000 * volume * tolerance);
}

TYPED_TEST(ParticlesSeeding, FillsTheFieldsThatWereAskedFor) {
    using S = TypeParam;
    using Real = typename S::Real;
    auto particles = make_particles<S>();
    const std::array<int, 3> per_cell{2, 3, 1};
    seed(particles, make_patch<S>(), Block(0.5, 1.5), per_cell, 1000,
         [](const Eigen::Vector3d& x) { return Eigen::Vector3d(2 * x[0], 7, -1); });
    for (Index p = 0; p < particles.size(); ++p) {
        const auto x = particles.position(p);
        EXPECT_EQ(particles.position(p, Field::initial_position), x);
        EXPECT_FLOAT_EQ(static_cast<float>(particles.velocity(p)[0]), static_cast<float>(2 * x[0]));
        for (int a = 0; a < S::dimension; ++a) {
            const double spacing = 0.25 / per_cell[static_cast<std::size_t>(a)];
            EXPECT_EQ(particles.vector(Field::half_size, p)[a], static_cast<Real>(spacing / 2));
            EXPECT_EQ(particles.vector(Field::initial_half_size, p)[a], static_cast<Real>(spacing / 2));
            const double place = x[a] / spacing - 0.5;
            EXPECT_NEAR(place, std::round(place), 1e-12);
        }
        EXPECT_TRUE(ParticleBatch<S>::load_deformation_gradient(particles, p).plane.isIdentity(0));
        EXPECT_EQ(particles.ids()[static_cast<std::size_t>(p)], static_cast<std::uint32_t>(p));
    }
}

TYPED_TEST(ParticlesSeeding, GoesCellByCellWhateverTheThreads) {
    using S = TypeParam;
    const auto patch = make_patch<S>();
    auto one = make_particles<S>(), three = make_particles<S>();
    const std::array<int, 3> per_cell{4, 5, 5};
    seed(one, patch, Block(0.2, 3.9), per_cell, 1);
    set_threads(3);
    seed(three, patch, Block(0.2, 3.9), per_cell, 1);
    set_threads(1);
    ASSERT_EQ(one.size(), three.size());
    std::set<int> left;  // cells that were gone through
    int current = -1;
    for (Index p = 0; p < one.size(); ++p) {
        ASSERT_EQ(one.position(p), three.position(p));
        int cell = 0;
        for (int a = S::dimension - 1; a >= 0; --a)
            cell = cell * 16 + static_cast<int>(one.position(p)[a] * 4);
        if (cell == current) continue;
        ASSERT_TRUE(left.insert(cell).second) << "cell " << cell << " comes twice";
        current = cell;
    }
}

TYPED_TEST(ParticlesSeeding, AsksForManyPointsAtATimeAndForNoneTwice) {
    using S = TypeParam;
    auto particles = make_particles<S>();
    const CountingBlock block(0.5, 1.5);
    Index velocities = 0;
    seed(
        particles, make_patch<S>(), block, {2, 3, 1}, 1,
        [&](const Eigen::Vector3d& x) {
            ++velocities;
            return x;
        },
        Seeding::centres);
    EXPECT_EQ(block.calls, 1);
    EXPECT_EQ(velocities, particles.size());
    // Along each axis the block has 4 cells; rounding of its bounds may cost some beside them.
    const std::size_t most = S::dimension == 1 ? 7 * 2 : S::dimension == 2 ? 7 * 7 * 6 : 7 * 7 * 7 * 6;
    EXPECT_LE(block.asked.size(), most);
}

TYPED_TEST(ParticlesSeeding, KeepsWithinTheGrid) {
    using S = TypeParam;
    auto particles = make_particles<S>();
    seed(particles, make_patch<S>(), Block(-1e300, 1e300), {1, 1, 1}, 1);
    EXPECT_EQ(particles.size(), S::dimension == 1 ? 8 : S::dimension == 2 ? 8 * 16 : 8 * 16 * 16);
}

TYPED_TEST(ParticlesSeeding, RefusesAnEmptyBody) {
    using S = TypeParam;
    auto particles = make_particles<S>();
    for (const Seeding seeding : {Seeding::filled, Seeding::centres})
        for (const auto& [min, max] : {std::pair(5.0, 6.0), std::pair(0.51, 0.52), std::pair(1.0, 0.5)}) {
            const std::string error = error_of([&] {
                seed(particles, make_patch<S>(), Block(min, max), {1, 1, 1}, 1, {}, seeding);
            });
            EXPECT_EQ(error.rfind("body \"brick\": its geometry contains no particle", 0), 0u) << error;
        }
}

TYPED_TEST(ParticlesSeeding, PlateHasItsVolumeHoweverThickAndWhereverItLies) {
    using S = TypeParam;
    const bool single = sizeof(typename S::Real) == 4;
    for (const double thickness : {0.001, 0.07, 0.124, 0.125, 0.18, 0.19, 0.3})
        for (const double min : {0.5, 0.51, 0.56, 0.5625, 0.62, 0.6249999}) {
            auto particles = make_particles<S>();
            const Plate plate(min, min + thickness);
            seed(particles, make_patch<S>(), plate, {2, 2, 2}, 1000);
            const double volume =
                S::axisymmetric ? pi * ((min + thickness) * (min + thickness) - min * min) : thickness;
            EXPECT_NEAR(sum(particles, Field::volume) / volume, 1, single ? 1e-6 / thickness : 1e-12)
                << thickness << " at " << min;
            double first = 1e9, last = -1e9, lightest = 1e9, heaviest = 0;
            for (Index p = 0; p < particles.size(); ++p) {
                const auto x = static_cast<double>(particles.position(p)[0]),
                           half = static_cast<double>(particles.vector(Field::half_size, p)[0]);
                first = std::min(first, x - half);
                last = std::max(last, x + half);
                lightest = std::min(lightest, half);
                heaviest = std::max(heaviest, half);
            }
            EXPECT_NEAR(first, min, single ? 1e-6 : 1e-12);
            EXPECT_NEAR(last, min + thickness, single ? 1e-6 : 1e-12);
            EXPECT_GE(lightest, heaviest / 4) << thickness << " at " << min;
        }
}

TYPED_TEST(ParticlesSeeding, KeepsTheCentroid) {
    using S = TypeParam;
    if constexpr (S::axisymmetric || sizeof(typename S::Real) == 4) return;
    auto particles = make_particles<S>();
    seed(particles, make_patch<S>(), Block(0.53, 1.71), {2, 3, 1}, 1);
    for (int a = 0; a < S::dimension; ++a) {
        double moment = 0;
        for (Index p = 0; p < particles.size(); ++p)
            moment += static_cast<double>(particles.column(Field::volume)[p] * particles.position(p)[a]);
        EXPECT_NEAR(moment / sum(particles, Field::volume), (0.53 + 1.71) / 2, 1e-12);
    }
}

TYPED_TEST(ParticlesSeeding, BodiesThatTouchNeitherOverlapNorLeaveAGap) {
    using S = TypeParam;
    const double tolerance = sizeof(typename S::Real) == 4 ? 1e-5 : 1e-12;
    for (const double between : {0.75, 0.8, 0.875, 0.93, 0.9999}) {
        auto left = make_particles<S>(), right = make_particles<S>(), both = make_particles<S>();
        seed(left, make_patch<S>(), Plate(0.5, between), {2, 2, 2}, 1000);
        seed(right, make_patch<S>(), Plate(between, 1.5), {2, 2, 2}, 1000);
        seed(both, make_patch<S>(), Plate(0.5, 1.5), {2, 2, 2}, 1000);
        EXPECT_EQ(left.size() + right.size(), both.size());
        EXPECT_NEAR((sum(left, Field::mass) + sum(right, Field::mass)) / sum(both, Field::mass), 1,
                    tolerance);
    }
}

TYPED_TEST(ParticlesSeeding, CentresAreWholePartsOrNothing) {
    using S = TypeParam;
    auto particles = make_particles<S>();
    seed(particles, make_patch<S>(), Plate(0.5, 0.57), {2, 2, 2}, 1000, {}, Seeding::centres);
    for (Index p = 0; p < particles.size(); ++p) {
        EXPECT_EQ(static_cast<double>(particles.position(p)[0]), 0.5625);
        EXPECT_EQ(static_cast<double>(particles.vector(Field::half_size, p)[0]), 0.0625);
    }
    EXPECT_EQ(particles.size(), S::dimension == 1 ? 1 : S::dimension == 2 ? 8 : 64);
}

TYPED_TEST(ParticlesSeeding, TakesListedPointsAsTheyAre) {
    using S = TypeParam;
    auto particles = make_particles<S>();
    Eigen::Vector3d a(0.3, 0.7, 1.1), b(1.9, 3.9, 3.9);
    for (int missing = S::dimension; missing < 3; ++missing) a[missing] = b[missing] = 0;
    const double ring = S::axisymmetric ? 2 * pi * a[0] : 1;
    const double volume = std::pow(0.1, S::dimension) * ring;
    seed(particles, make_patch<S>(), Cloud({{a, volume, {1, 0, 0}}, {b, 2 * volume, {0, 0, 0}}}), {1, 1, 1},
         500, [](const Eigen::Vector3d&) { return Eigen::Vector3d(3, 0, 0); });
    ASSERT_EQ(particles.size(), 2);
    EXPECT_FLOAT_EQ(static_cast<float>(particles.position(0)[0]), 0.3f);
    EXPECT_FLOAT_EQ(static_cast<float>(particles.velocity(0)[0]), 4);
    EXPECT_FLOAT_EQ(static_cast<float>(particles.velocity(1)[0]), 3);
    EXPECT_FLOAT_EQ(static_cast<float>(particles.vector(Field::half_size, 0)[0]), 0.05f);
    EXPECT_FLOAT_EQ(static_cast<float>(sum(particles, Field::mass)), static_cast<float>(500 * 3 * volume));
}

TYPED_TEST(ParticlesSeeding, TakesTheDomainsOfListedPoints) {
    using S = TypeParam;
    auto particles = make_particles<S>();
    Eigen::Vector3d x(1, 1, 1);
    for (int missing = S::dimension; missing < 3; ++missing) x[missing] = 0;
    const Eigen::Vector3d half_size(0.25, 0.5, 0.125);
    seed(particles, make_patch<S>(), Cloud({{x, 1, {0, 0, 0}, half_size}}), {1, 1, 1}, 500);
    for (int a = 0; a < S::dimension; ++a) {
        EXPECT_EQ(static_cast<double>(particles.vector(Field::half_size, 0)[a]), half_size[a]);
        EXPECT_EQ(static_cast<double>(particles.vector(Field::initial_half_size, 0)[a]), half_size[a]);
    }
}

TYPED_TEST(ParticlesSeeding, TakesAnyNumberOfListedPointsInTheirOrder) {
    using S = TypeParam;
    using Real = typename S::Real;
    std::vector<PointCloud::Point> points;
    for (int k = 0; k < 10'001; ++k) {
        const double volume = 1 + k;
        points.push_back(
            {{0.5 + 1e-4 * k, 0, 0}, volume, {-k * 1.0, 0, 0}, Eigen::Vector3d::Constant(volume)});
    }
    set_threads(3);
    auto particles = make_particles<S>();
    seed(particles, make_patch<S>(), Cloud(points), {1, 1, 1}, 2,
         [](const Eigen::Vector3d& x) { return Eigen::Vector3d(10 * x[0], 0, 0); });
    std::vector<PointCloud::Point> two_off = points;
    two_off[9000].position[0] = two_off[5000].position[0] = -1;
    const std::string error = error_of([&] {
        seed(particles, make_patch<S>(), Cloud(two_off), {1, 1, 1}, 2);
    });
    set_threads(1);

    ASSERT_EQ(particles.size(), std::ssize(points));
    for (Index p = 0; p < particles.size(); ++p) {
        const PointCloud::Point& point = points[static_cast<std::size_t>(p)];
        ASSERT_NEAR(particles.position(p)[0], point.position[0], 1e-14 * point.position[0]);
        ASSERT_EQ(particles.velocity(p)[0], static_cast<Real>(10 * point.position[0] + point.velocity[0]));
        ASSERT_EQ(particles.column(Field::volume)[p], static_cast<Real>(point.volume));
        ASSERT_EQ(particles.column(Field::mass)[p], static_cast<Real>(2 * point.volume));
        ASSERT_EQ(particles.vector(Field::half_size, p)[0], static_cast<Real>(point.volume));
    }
    EXPECT_EQ(error.rfind("body \"brick\": point 5001 of its geometry's 10001, at [-1", 0), 0u) << error;
}

TYPED_TEST(ParticlesSeeding, RefusesAListedPointOutsideTheGrid) {
    using S = TypeParam;
    auto particles = make_particles<S>();
    const Cloud cloud({{{1, 0, 0}, 1, {0, 0, 0}}, {{2.5, 0, 0}, 1, {0, 0, 0}}});
    const std::string error = error_of([&] { seed(particles, make_patch<S>(), cloud, {1, 1, 1}, 1); });
    EXPECT_EQ(error.rfind("body \"brick\": point 2 of its geometry's 2, at [2.5", 0), 0u) << error;
}

}  // namespace matpoint
