// Squares of wave speeds that can't be are not lost among those of a batch's other particles.

#include <matpoint/pointwise_material.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace matpoint {
namespace {

/// Its squared wave speed is the particle's mass.
template <class S>
class Massive final : public PointwiseMaterial<S, Massive<S>> {
  public:
    using Real = typename S::Real;
    using PointwiseMaterial<S, Massive<S>>::PointwiseMaterial;
    template <class Point>
    auto squared_wave_speed(const Point& p) const {
        return p.mass();
    }
    template <class Point>
    auto update(const Point& p, Real) const {
        return p.mass();
    }
};

template <class S>
void expect_that_none_is_lost() {
    using Real = typename S::Real;
    const Json own{{"density", 1}};
    const Parameters::Context context{};
    const Massive<S> law(Parameters(own, context));
    const Material<S>& material = law;
    static const Gathered<S> nothing{};
    for (const Index count : {1, 7, 20})
        for (Index wrong = 0; wrong < count; ++wrong)
            for (const Real square : {Real(9), Real(-1), std::numeric_limits<Real>::quiet_NaN()}) {
                Particles<S> particles("body");
                particles.resize(count);
                std::fill_n(particles.column(Field::mass), count, Real(4));
                particles.column(Field::mass)[wrong] = square;
                const ParticleBatch<S> batch(particles, 0, count, nothing, 0);
                for (const Real speed : {material.wave_speed(batch), material.update(batch, Real(1))}) {
                    if (square > 0) {
                        EXPECT_EQ(speed, 3);
                    } else {
                        EXPECT_TRUE(std::isnan(speed)) << square << " of particle " << wrong;
                    }
                }
            }
}

TEST(SdkPointwise, ASquareThatIsNegativeOrNoNumberMakesTheSpeedNoNumber) {
    expect_that_none_is_lost<Bar>();
    expect_that_none_is_lost<BarSingle>();
}

}  // namespace
}  // namespace matpoint
