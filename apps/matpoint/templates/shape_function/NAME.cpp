#include <matpoint/plugin.hpp>
#include <matpoint/tensor_product_shape.hpp>

#include <cmath>

using namespace matpoint;

/// Quadratic B-spline along one axis; see README.md. The kernel multiplies the axes and does the loops.
struct Spline {
    static constexpr int width = 3;       // nodes that a particle reaches
    static constexpr bool sized = false;  // particles are points

    /// First of these nodes; xi is the position in cells. Both are counted from some node of the grid.
    template <class T>
    static T base(T xi) {
        using std::floor;
        return floor(xi - T(0.5));
    }

    /// Weights and derivatives (per cell) at s = xi - base, 1/2 <= s < 3/2. T is a number, or some at once.
    template <class T>
    static void evaluate(T s, T /*half_size*/, T* weights, T* derivatives) {
        const T left = T(1.5) - s, middle = s - T(1), right = s - T(0.5);
        weights[0] = T(0.5) * left * left;
        weights[1] = T(0.75) - middle * middle;
        weights[2] = T(0.5) * right * right;
        derivatives[0] = -left;
        derivatives[1] = T(-2) * middle;
        derivatives[2] = right;
    }
};

template <class Space>
class {{Name}} final : public TensorProductShape<Space, Spline> {
  public:
    static Schema schema() { return Schema("Quadratic B-splines", "[Steffen et al. 2008]"); }
    explicit {{Name}}(const Parameters&) {}
};

MATPOINT_PLUGIN("{{name}}", "0.1.0") { registry.shape_function<{{Name}}>("{{name}}"); }
