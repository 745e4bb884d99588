#include <matpoint/delegating_shape.hpp>
#include <matpoint/parallel.hpp>
#include <matpoint/plugin.hpp>
#include <matpoint/tensor_product_shape.hpp>

#include <atomic>
#include <cmath>
#include <limits>
#include <string>

namespace matpoint {
namespace {

/// Tent function averaged over the particle's domain [x_p - l, x_p + l], exactly
/// [Wallstedt & Guilkey 2008, eq. 1, 2, 4]; for l <= h / 2 that is eq. 5, 6. The domain is cut at the
/// nodes: the part [lo, hi] of cell k, in cells from its left node, adds the integrals of 1 - x to node
/// k and of x to node k + 1. Width 3 holds domains with l up to h / 2, width 4 up to h.
template <int Width>
struct AveragedTent {
    static constexpr int width = Width;
    static constexpr bool sized = true;
    static constexpr double refinement[] = {0.5, 1, 0.5};              // the tent's, averaged on both sides
    static constexpr double largest_half_size = Width == 3 ? 0.5 : 1;  // in cells
    /// Smaller domains count as this large, so that the average exists for points too.
    static constexpr double smallest_half_size = 1e-3;

    template <class T>
    static T base(T xi) {
        using std::floor;
        return floor(xi - T(largest_half_size));
    }

    template <class T>
    static void evaluate(T s, T half_size, T* weights, T* derivatives) {
        using std::max;
        using std::min;
        const T l = max(T(smallest_half_size), min(half_size, T(largest_half_size)));
        const T begin = s - l, end = s + l, density = T(1) / (end - begin);
        weights[0] = derivatives[0] = T(0);
        for (int k = 0; k < Width - 1; ++k) {
            T lo = begin - T(k), hi = end - T(k);
            if (k > 0) lo = max(T(0), lo), hi = max(T(0), hi);
            if (k < Width - 2) lo = min(lo, T(1)), hi = min(hi, T(1));
            const T share = (hi - lo) * density, right = T(0.5) * (hi + lo) * share;
            weights[k] = weights[k] + (share - right);
            weights[k + 1] = right;
            derivatives[k] = derivatives[k] - share;
            derivatives[k + 1] = share;
        }
    }
};

template <class S>
class Gimp final : public DelegatingShape<S> {
  public:
    using typename ShapeFunction<S>::Real;

    explicit Gimp(const Parameters& parameters) : domain_(parameters.text("domain")) {}

    static Schema schema() {
        Schema schema(
            "Generalized interpolation: the tent function averaged over each particle's domain, "
            "a box aligned with the axes.",
            "[Wallstedt & Guilkey 2008, eq. 1-7]");
        schema.choice(
            "domain",
            {.doc = "Whether domains follow the deformation by its diagonal (contiguous, cpGIMP), by the "
                    "lengths of its rows, which a rotation leaves alone (stretched), or keep their initial "
                    "size (uniform, uGIMP).",
             .paper = "[Wallstedt & Guilkey 2008, eq. 7, 63]",
             .default_value = "contiguous",
             .choices = {"contiguous", "stretched", "uniform"}});
        return schema;
    }

    void declare(Particles<S>& particles) const override {
        particles.require(Field::half_size);
        if (domain_ == "uniform") return;
        particles.require(Field::initial_half_size);
        particles.require(Field::displacement_gradient);
    }

    void start_step(const Patch<S>& patch, Particles<S>& particles) override {
        constexpr Index chunk = 4096;
        std::atomic<bool> wide = false;
        parallel_for((particles.size() + chunk - 1) / chunk, particles.size(), [&](Index k) {
            const Index begin = k * chunk, count = std::min(chunk, particles.size() - begin);
            for (int a = 0; a < S::dimension; ++a) {
                if (domain_ == "contiguous") follow_diagonal(particles, a, begin, count);
                if (domain_ == "stretched") follow_stretch(particles, a, begin, count);
                // Rounding must not make a domain of exactly one cell reach a fourth node.
                constexpr Real limit = Real(0.5) * (1 + 16 * std::numeric_limits<Real>::epsilon());
                const Real largest = column(particles, Field::half_size, a, begin, count).maxCoeff();
                if (largest * patch.inverse_cell_size()[a] > limit) wide = true;
            }
        });
        std::erase(wide_, &particles);
        if (wide) wide_.push_back(&particles);
    }

    std::string trouble(const Particles<S>& particles) const override {
        if (domain_ != "contiguous") return {};
        constexpr Real half = Real(0.5);  // of what the domain would be if it followed the stretch
        for (Index p = 0; p < particles.size(); ++p)
            for (int a = 0; a < S::dimension; ++a)
                if (particles.column(Field::half_size, a)[p] <
                    half * std::min(stretched(particles, a, p),
                                    particles.column(Field::initial_half_size, a)[p]))
                    return "Domains of gimp \"contiguous\" follow the diagonal of F, which shrinks as body "
                           "\"" +
                           particles.body() +
                           "\" turns: particles no longer fill it. Set /shape_function/domain to "
                           "\"stretched\".";
        return {};
    }

  private:
    using Numbers = Eigen::Array<Real, Eigen::Dynamic, 1>;

    static Eigen::Map<Numbers> column(Particles<S>& particles, Field field, int c, Index begin, Index count) {
        return {particles.column(field, c) + begin, count};
    }
    /// l^n = l^0 diag(F^n) [Wallstedt & Guilkey 2008, eq. 7, 63]. It vanishes where F turns by 90
    /// degrees: not below 5 % of l^0.
    static void follow_diagonal(Particles<S>& particles, int a, Index begin, Index count) {
        const auto of = [&](Field field, int c) { return column(particles, field, c, begin, count); };
        of(Field::half_size, a) =
            of(Field::initial_half_size, a) *
            (Real(1) + of(Field::displacement_gradient, a * (S::dimension + 1))).abs().max(Real(0.05));
    }
    /// l_a^2 = sum_b (F_ab l^0_b)^2: the box with the second moments of the deformed domain. That is
    /// eq. 63 where the stretch is along the axes, and is the same whichever way a square domain turns.
    static void follow_stretch(Particles<S>& particles, int a, Index begin, Index count) {
        const auto of = [&](Field field, int c) { return column(particles, field, c, begin, count); };
        Eigen::Map<Numbers> l = of(Field::half_size, a);
        l.setZero();
        for (int b = 0; b < S::dimension; ++b)
            l += ((Real(a == b ? 1 : 0) + of(Field::displacement_gradient, a + b * S::dimension)) *
                  of(Field::initial_half_size, b))
                     .square();
        l = l.sqrt();
    }

    static Real stretched(const Particles<S>& particles, int a, Index p) {
        Real squares = 0;
        for (int b = 0; b < S::dimension; ++b) {
            const Real f = Real(a == b ? 1 : 0) +
                           particles.column(Field::displacement_gradient, a + b * S::dimension)[p];
            const Real l = f * particles.column(Field::initial_half_size, b)[p];
            squares += l * l;
        }
        return std::sqrt(squares);
    }

    const ShapeFunction<S>& shape_of(const Particles<S>& particles) const override {
        if (std::ranges::find(wide_, &particles) == wide_.end()) return narrow_shape_;
        return wide_shape_;
    }
    const ShapeFunction<S>& widest() const override {
        if (wide_.empty()) return narrow_shape_;
        return wide_shape_;
    }

    std::string domain_;
    std::vector<const Particles<S>*> wide_;  ///< bodies with a domain larger than a cell
    TensorProductShape<S, AveragedTent<3>> narrow_shape_;
    TensorProductShape<S, AveragedTent<4>> wide_shape_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("gimp", "1.1.0") {
    registry.shape_function<matpoint::Gimp>("gimp");
}
