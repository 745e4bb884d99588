#include <matpoint/plugin.hpp>
#include <matpoint/tensor_product_shape.hpp>

#include <cmath>

namespace matpoint {
namespace {

/// The tent function of the original method [Wallstedt & Guilkey 2008, eq. 2, 3].
struct Tent {
    static constexpr int width = 2;
    static constexpr bool sized = false;
    static constexpr double refinement[] = {0.5, 1, 0.5};

    template <class T>
    static T base(T xi) {
        using std::floor;
        return floor(xi);
    }

    template <class T>
    static void evaluate(T s, T, T* weights, T* derivatives) {
        using std::max;
        // A node that a particle on the next one reads the slope of has its velocity, not none.
        weights[0] = max(T(1) - s, T(1e-15));
        weights[1] = max(s, T(1e-15));
        derivatives[0] = T(-1);
        derivatives[1] = T(1);
    }
};

template <class S>
class Linear final : public TensorProductShape<S, Tent> {
  public:
    explicit Linear(const Parameters&) {}

    static Schema schema() {
        return Schema(
            "Piecewise linear: a particle is a point and reaches the corners of its cell. Fast, "
            "but forces jump when particles cross cells.",
            "[Wallstedt & Guilkey 2008, eq. 2, 3]");
    }
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("linear", "1.0.0") {
    registry.shape_function<matpoint::Linear>("linear");
}
