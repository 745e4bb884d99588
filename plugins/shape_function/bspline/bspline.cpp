#include <matpoint/delegating_shape.hpp>
#include <matpoint/plugin.hpp>
#include <matpoint/tensor_product_shape.hpp>

#include <cmath>

namespace matpoint {
namespace {

/// Node-centred quadratic B-spline, support 3h.
struct QuadraticSpline {
    static constexpr int width = 3;
    static constexpr bool sized = false;
    static constexpr double refinement[] = {0.25, 0.75, 0.75, 0.25};

    template <class T>
    static T base(T xi) {
        using std::floor;
        return floor(xi - T(0.5));
    }

    /// s is in [1/2, 3/2): the middle node is the nearest.
    template <class T>
    static void evaluate(T s, T, T* weights, T* derivatives) {
        const T left = T(1.5) - s, middle = s - T(1), right = s - T(0.5);
        weights[0] = T(0.5) * left * left;
        weights[1] = T(0.75) - middle * middle;
        weights[2] = T(0.5) * right * right;
        derivatives[0] = -left;
        derivatives[1] = T(-2) * middle;
        derivatives[2] = right;
    }
};

/// Node-centred cubic B-spline, support 4h.
struct CubicSpline {
    static constexpr int width = 4;
    static constexpr bool sized = false;
    static constexpr double refinement[] = {0.125, 0.5, 0.75, 0.5, 0.125};

    template <class T>
    static T base(T xi) {
        using std::floor;
        return floor(xi) - T(1);
    }

    /// s is in [1, 2): the particle's cell lies between the middle nodes.
    template <class T>
    static void evaluate(T s, T, T* weights, T* derivatives) {
        const T sixth = T(1) / T(6), two_thirds = T(2) / T(3), half = T(0.5);
        const T right = s - T(1), left = T(2) - s;
        weights[0] = sixth * left * left * left;
        weights[1] = two_thirds - right * right * (T(1) - half * right);
        weights[2] = two_thirds - left * left * (T(1) - half * left);
        weights[3] = sixth * right * right * right;
        derivatives[0] = -half * left * left;
        derivatives[1] = right * (T(1.5) * right - T(2));
        derivatives[2] = left * (T(2) - T(1.5) * left);
        derivatives[3] = half * right * right;
    }
};

template <class S>
class BSpline final : public DelegatingShape<S> {
  public:
    explicit BSpline(const Parameters& parameters) {
        if (parameters.integer("order") == 2)
            spline_ = std::make_unique<TensorProductShape<S, QuadraticSpline>>();
        else
            spline_ = std::make_unique<TensorProductShape<S, CubicSpline>>();
    }

    static Schema schema() {
        Schema schema(
            "Quadratic or cubic B-splines: a particle is a point, and forces are smooth when it "
            "crosses cells.");
        schema.integer("order",
                       {.doc = "Degree of the polynomials: 2 (3 nodes an axis) or 3 (4 nodes an axis).",
                        .default_value = 2,
                        .at_least = 2,
                        .at_most = 3});
        return schema;
    }

  private:
    const ShapeFunction<S>& shape_of(const Particles<S>&) const override { return *spline_; }
    const ShapeFunction<S>& widest() const override { return *spline_; }

    std::unique_ptr<ShapeFunction<S>> spline_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("bspline", "1.0.0") {
    registry.shape_function<matpoint::BSpline>("bspline");
}
