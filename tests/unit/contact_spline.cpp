#include <matpoint/spline.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace matpoint {
namespace {

/// N by its recurrence [de Boor 1978], and integrals of it by Simpson's rule.
double recurrence(int degree, double x) {
    if (degree == 0) return x >= -0.5 && x < 0.5 ? 1 : 0;
    const double r = (degree + 1) / 2.0;
    return ((x + r) * recurrence(degree - 1, x + 0.5) + (r - x) * recurrence(degree - 1, x - 0.5)) / degree;
}
template <class Function>
double integral(double from, double to, const Function& f) {
    constexpr int n = 4000;
    double sum = 0;
    for (int i = 0; i <= n; ++i)
        sum += f(from + (to - from) * i / n) * (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2);
    return sum * (to - from) / (3 * n);
}

TEST(ContactSpline, IsTheBSplineAndItsIntegrals) {
    for (const int degree : {1, 2, 3}) {
        const Spline spline(degree);
        for (double x = -2.3; x < 2.4; x += 0.17) {
            SCOPED_TRACE("degree " + std::to_string(degree) + ", x = " + std::to_string(x));
            const auto n = [&](double s) { return recurrence(degree, s); };
            const Spline::Values own = spline.at(x);
            EXPECT_NEAR(own.value, n(x), 1e-12);
            EXPECT_NEAR(own.mass, integral(-2.5, x, n), 1e-6);
            EXPECT_NEAR(own.moment, integral(-2.5, x, [&](double s) { return s * n(s); }), 1e-6);
        }
    }
}

TEST(ContactSpline, FindsTheSurfaceFromTheCentroid) {
    for (const int degree : {1, 2, 3}) {
        const Spline spline(degree);
        for (double d = -spline.reach() + 1e-4; d < spline.reach() - 1e-2; d += 0.0173) {
            const Spline::Values own = spline.at(d);
            EXPECT_NEAR(spline.surface(own.moment / own.mass), d, 1e-9) << "degree " << degree;
        }
        EXPECT_EQ(spline.surface(0.1), spline.reach());
        EXPECT_EQ(spline.surface(-3), -spline.reach());
    }
}

}  // namespace
}  // namespace matpoint
