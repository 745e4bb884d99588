#include "grid/level_fields.hpp"
#include "levels_fixture.hpp"
#include "particles/seeding.hpp"
#include "step/splitting.hpp"

#include <cmath>
#include <numbers>
#include <set>

namespace matpoint {
namespace {

template <class S>
struct Sums {
    double mass = 0, volume = 0, energy = 0;
    typename S::Position momentum = S::Position::Zero(), moment = S::Position::Zero();

    explicit Sums(const Particles<S>& particles) {
        for (Index p = 0; p < particles.size(); ++p) {
            const double m = particles.value(Field::mass, 0, p);
            const typename S::Position v = particles.velocity(p).template cast<double>();
            mass += m;
            volume += particles.value(Field::volume, 0, p);
            energy += m * v.squaredNorm() / 2;
            momentum += m * v;
            moment += m * particles.position(p);
        }
    }
};

template <class S>
class Split : public testing::Test {
  protected:
    static constexpr int D = S::dimension;
    static typename Patch<S>::Coordinates cells() {
        typename Patch<S>::Coordinates cells;
        cells.fill(16);
        return cells;
    }
    static Eigen::Vector3d corner(double at) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        x.head<D>().setConstant(at);
        return x;
    }
    Split() {
        for (const Field field : {Field::id, Field::half_size, Field::initial_half_size,
                                  Field::displacement_gradient, Field::initial_position})
            particles.require(field);
        for (const char* field : {refinement_field, level_field}) particles.require(field, 1);
        area = particles.require("area", 1);
        particles.keep_whole(area);
        particles.resize(2);
        for (const Index p : {0, 1}) {
            for (int a = 0; a < D; ++a) {
                particles.set_value(Field::position, a, p, p == 0 ? 8.1 + a : 1.0);
                particles.set_value(Field::initial_position, a, p, 8);
                particles.column(Field::velocity, a)[p] = static_cast<typename S::Real>(2 + a);
                particles.column(Field::initial_half_size, a)[p] = 0.25;
                particles.column(Field::displacement_gradient, a + D * a)[p] =
                    static_cast<typename S::Real>(0.5 * a);
            }
            if constexpr (D > 1) particles.column(Field::displacement_gradient, D)[p] = 0.25;  // F_xy
            particles.set_value(Field::volume, 0, p, 3);
            particles.column(Field::mass)[p] = 6;
        }
    }

    Boxes first{{{corner(6), corner(12)}}}, second{{{corner(7.5), corner(10.5)}}};
    Patch<S> patch{{0, 0, 0}, {1, 1, 1}, cells()};
    Levels<S> levels{patch, {&first, &second}, refinements.at(1)};
    Particles<S> particles{"body"};
    int area = 0;
};
using Spaces = testing::Types<Bar, PlaneStrain, Axisymmetric, Solid>;
TYPED_TEST_SUITE(Split, Spaces);

TYPED_TEST(Split, KeepsWhatIsConserved) {
    using S = TypeParam;
    auto& body = this->particles;
    const Sums<S> before(body);
    ASSERT_EQ(this->levels.at(body.position(0)), 2);
    split_arrived(this->levels, body);
    const Index children = Index{1} << (2 * S::dimension);
    ASSERT_EQ(body.size(), children + 1);
    const Sums<S> after(body);
    EXPECT_NEAR(after.mass, before.mass, 1e-14);
    EXPECT_NEAR(after.volume, before.volume, 1e-14);
    EXPECT_NEAR(after.energy, before.energy, 1e-13);
    EXPECT_NEAR((after.momentum - before.momentum).norm(), 0, 1e-13);
    if (!S::axisymmetric) {
        EXPECT_NEAR((after.moment - before.moment).norm(), 0, 1e-12);
    }

    std::set<std::uint32_t> ids(body.ids().begin(), body.ids().end());
    EXPECT_EQ(std::ssize(ids), body.size());
    EXPECT_EQ(body.ids()[0], 0U);
    for (Index p = 0; p < body.size(); ++p) {
        if (p == 1) continue;  // the one that is elsewhere
        EXPECT_EQ(body.column(body.slot(refinement_field), 0)[p], 2);
        EXPECT_EQ(body.column(body.slot(level_field), 0)[p], 2);
        EXPECT_NEAR(body.column(Field::initial_half_size)[p], 0.0625, 1e-15);
    }
    split_arrived(this->levels, body);
    EXPECT_EQ(body.size(), children + 1);  // once
}

/// The children's middles are those of the parts of the deformed domain.
TYPED_TEST(Split, FillsTheDeformedDomain) {
    using S = TypeParam;
    auto& body = this->particles;
    const auto f = ParticleBatch<S>::load_deformation_gradient(body, 0).plane;
    const typename S::Position middle = body.position(0);
    split_arrived(this->levels, body);
    for (Index p = 0; p < body.size(); ++p) {
        if (p == 1) continue;
        const typename S::Position from_start =
            body.position(p, Field::initial_position) - 8 * S::Position::Ones();
        const typename S::Position expected = middle + f.template cast<double>() * from_start;
        EXPECT_NEAR((body.position(p) - expected).norm(), 0, 1e-13);
    }
}

TYPED_TEST(Split, LeavesWhatStandsForSomethingAsAWhole) {
    auto& body = this->particles;
    body.column(this->area, 0)[0] = 0.1;
    split_arrived(this->levels, body);
    EXPECT_EQ(body.size(), 2);
}

TYPED_TEST(Split, StaysOnTheGrid) {
    using S = TypeParam;
    Boxes edge({{this->corner(0), this->corner(4)}});
    Levels<S> at_edge(this->patch, {&edge}, refinements.at(1));
    auto& body = this->particles;
    for (int a = 0; a < S::dimension; ++a) body.set_value(Field::position, a, 0, 0.01);
    split_arrived(at_edge, body);
    for (Index p = 0; p < body.size(); ++p) EXPECT_GT(body.position(p).minCoeff(), 0);
}

/// Bodies have the mass of their geometry, and as many particles in a cell of each level.
TYPED_TEST(Split, SeedsAsEachLevelSays) {
    using S = TypeParam;
    Particles<S> seeded("body");
    seeded.require(Field::initial_half_size);
    for (const char* field : {refinement_field, level_field}) seeded.require(field, 1);
    const Boxes block({{this->corner(1.3), this->corner(13.8)}});
    seed(seeded, this->levels, block, {2, 2, 2}, 1000.0);
    double exact = 1;
    for (int a = 0; a < S::dimension; ++a) exact *= 12.5;
    if (S::axisymmetric) exact *= 2 * std::numbers::pi * 7.55;
    EXPECT_NEAR(Sums<S>(seeded).mass / (1000 * exact), 1, 1e-12);
    for (Index p = 0; p < seeded.size(); ++p) {
        const int level = this->levels.at(seeded.position(p));
        EXPECT_EQ(seeded.column(seeded.slot(refinement_field), 0)[p], level);
        const bool inside = (seeded.position(p).array() > 2).all() && (seeded.position(p).array() < 13).all();
        if (inside) {  // not cut by the edge
            EXPECT_NEAR(seeded.column(Field::initial_half_size)[p], std::ldexp(0.25, -level), 1e-12);
        }
    }
}

}  // namespace
}  // namespace matpoint
