// What the built-in `bspline` of order 2 does, from a textbook: a user's own shape function.
#include <matpoint/plugin.hpp>
#include <matpoint/tensor_product_shape.hpp>

#include <cmath>

using namespace matpoint;

struct Quadratic {
    static constexpr int width = 3;
    static constexpr bool sized = false;

    template <class T>
    static T base(T xi) {
        using std::floor;
        return floor(xi - T(0.5));
    }

    /// d: distance from the middle node, the nearest one, in cells.
    template <class T>
    static void evaluate(T s, T, T* weights, T* derivatives) {
        const T d = s - T(1);
        weights[0] = T(0.5) * (T(0.5) - d) * (T(0.5) - d);
        weights[1] = T(0.75) - d * d;
        weights[2] = T(0.5) * (T(0.5) + d) * (T(0.5) + d);
        derivatives[0] = d - T(0.5);
        derivatives[1] = T(-2) * d;
        derivatives[2] = d + T(0.5);
    }
};

template <class Space>
class UserSpline final : public TensorProductShape<Space, Quadratic> {
  public:
    static Schema schema() { return Schema("Quadratic B-splines", "[Steffen et al. 2008]"); }
    explicit UserSpline(const Parameters&) {}
};

MATPOINT_PLUGIN("user_spline", "1.0.0") {
    registry.shape_function<UserSpline>("user_spline");
}
