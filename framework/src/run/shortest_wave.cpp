#include "run/shortest_wave.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace matpoint {

namespace {

constexpr Index sample = 256;  // particles of a body that stand for all
constexpr int places = 4;      // of a body in the cells

/// A place in the same cell, farther by a part of it along all axes, and round to its other side.
template <class S>
typename S::Position shifted(const Patch<S>& patch, typename S::Position x, double part) {
    for (int a = 0; a < S::dimension; ++a) {
        const auto min = patch.min()[a], h = patch.cell_size()[a];
        const double xi = (x[a] - min) / h, within = xi - std::floor(xi) + part;
        x[a] = min + (std::floor(xi) + within - std::floor(within)) * h;
    }
    return x;
}

/// Some of a body's particles on a level.
template <class S>
std::vector<Index> sample_of(const Levels<S>& levels, const Particles<S>& particles, int level) {
    std::vector<Index> found;
    for (Index p = 0; p < particles.size() && std::ssize(found) < sample; ++p)
        if (levels.count() == 1 || levels.at(particles.position(p)) == level) found.push_back(p);
    return found;
}

/// Root mean square of the slope (1/m) of velocities +1 and -1 at every other node along an axis; of the
/// axis where it is largest.
template <class S>
double slope(const Patch<S>& patch, const Particles<S>& particles, const std::vector<Index>& samples,
             const ShapeFunction<S>& shape, double part) {
    std::array<double, S::dimension> squares{};
    for (const Index p : samples) {
        const typename S::Vector half_size = particles.has(Field::half_size)
                                                 ? particles.vector(Field::half_size, p)
                                                 : S::Vector::Zero().eval();
        const typename S::Position x = particles.position(p);
        const auto stencil = shape.stencil(patch, shifted(patch, x, part), half_size);
        for (int a = 0; a < S::dimension; ++a) {
            const auto axis = static_cast<std::size_t>(a);
            double own = 0;
            for (std::size_t k = 0; k < stencil.nodes.size(); ++k)
                own +=
                    (stencil.nodes[k][axis] % 2 == 0 ? 1 : -1) * static_cast<double>(stencil.gradients[k][a]);
            squares[axis] += own * own / static_cast<double>(samples.size());
        }
    }
    return std::sqrt(*std::ranges::max_element(squares));
}

}  // namespace

template <class S>
double shortest_wave_phase(const Levels<S>& levels, const std::vector<Particles<S>>& bodies,
                           const ShapeFunction<S>& shape) {
    double largest = 0;
    for (const Particles<S>& particles : bodies)
        for (int level = 0; level < levels.count(); ++level) {
            const std::vector<Index> samples = sample_of(levels, particles, level);
            const Patch<S>& patch = levels.patch(level);
            for (int k = 0; k < places; ++k)
                largest = std::max(largest,
                                   slope(patch, particles, samples, shape, static_cast<double>(k) / places) *
                                       patch.cell_size().minCoeff());
        }
    return largest;
}

#define MATPOINT_INSTANTIATE(S)                                                             \
    template double shortest_wave_phase(const Levels<S>&, const std::vector<Particles<S>>&, \
                                        const ShapeFunction<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
