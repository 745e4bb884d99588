#include "run/pieces.hpp"

#include "step/ordering.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace matpoint {
namespace {

/// Disjoint sets of numbers.
class Sets {
  public:
    explicit Sets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }
    int root(int i) {
        while (parent(i) != i) i = parent(i) = parent(parent(i));
        return i;
    }
    void join(int i, int j) { parent(root(i)) = root(j); }

  private:
    int& parent(int i) { return parents_[static_cast<std::size_t>(i)]; }
    std::vector<int> parents_;
};

/// First nodes of the particles' stencils, each once, with the number of particles that have it.
template <class S>
struct Stencils {
    std::vector<typename Patch<S>::Coordinates> bases;
    std::vector<Index> particles;
};

template <class S>
Stencils<S> stencils(const Patch<S>& patch, const Particles<S>& particles, const ShapeFunction<S>& shape) {
    const Bounds<S> room = domain(patch);
    Stencils<S> found;
    std::vector<int> numbers(static_cast<std::size_t>(patch.node_count()), -1);  // by node
    std::array<typename Patch<S>::Coordinates, batch_size> bases;
    for (Index begin = 0; begin < particles.size(); begin += batch_size) {
        const Index end = std::min(particles.size(), begin + batch_size);
        shape.base_nodes(patch, particles, begin, end, bases.data());
        for (Index p = begin; p < end; ++p) {
            const auto x = particles.position(p).template cast<typename S::Real>().eval();
            if (!(x.array() >= room.low.array()).all() || !(x.array() <= room.high.array()).all()) continue;
            const auto& base = bases[static_cast<std::size_t>(p - begin)];
            const int place = patch.node_index(base);
            if (place < 0) continue;  // it has just moved on: its neighbours tell
            int& number = numbers[static_cast<std::size_t>(place)];
            if (number < 0) {
                number = static_cast<int>(found.bases.size());
                found.bases.push_back(base);
                found.particles.push_back(0);
            }
            ++found.particles[static_cast<std::size_t>(number)];
        }
    }
    return found;
}

/// The coarsest level with nodes wherever particles of any level are.
template <class S>
Patch<S> nodes_for_all(const Patch<S>& coarsest, const Particles<S>& particles,
                       const ShapeFunction<S>& shape) {
    std::array<double, 3> min{}, cell_size{};
    std::copy_n(coarsest.min().data(), S::dimension, min.begin());
    std::copy_n(coarsest.cell_size().data(), S::dimension, cell_size.begin());
    Patch<S> patch(min, cell_size, coarsest.cells());
    std::vector<typename Patch<S>::Coordinates> bases(static_cast<std::size_t>(particles.size()));
    shape.base_nodes(patch, particles, 0, particles.size(), bases.data());
    std::vector<int> blocks;
    for (const auto& base : bases)
        for (int corner = 0; corner < 1 << S::dimension; ++corner) {
            auto block = base;
            for (std::size_t a = 0; a < S::dimension; ++a)
                block[a] = Patch<S>::block_of(base[a] + (corner >> a & 1) * (shape.width() - 1));
            blocks.push_back(patch.block_number(block));
        }
    std::ranges::sort(blocks);
    blocks.erase(std::ranges::unique(blocks).begin(), blocks.end());
    patch.set_blocks(blocks);
    return patch;
}

template <class S>
std::vector<Index> pieces_on(const Patch<S>& patch, const Particles<S>& particles,
                             const ShapeFunction<S>& shape) {
    const Stencils<S> found = stencils(patch, particles, shape);
    const int width = shape.width();
    Sets sets(found.bases.size());
    std::vector<int> owners(static_cast<std::size_t>(patch.node_count()), -1);
    for (int i = 0; i < static_cast<int>(found.bases.size()); ++i) {
        int nodes = 1;
        for (int a = 0; a < S::dimension; ++a) nodes *= width;
        for (int n = 0; n < nodes; ++n) {
            auto node = found.bases[static_cast<std::size_t>(i)];
            for (int a = 0, rest = n; a < S::dimension; ++a, rest /= width)
                node[static_cast<std::size_t>(a)] += rest % width;
            const int place = patch.node_index(node);
            if (place < 0) continue;
            int& owner = owners[static_cast<std::size_t>(place)];
            if (owner >= 0) sets.join(owner, i);
            owner = i;
        }
    }
    std::vector<Index> sizes(found.bases.size(), 0);
    for (int i = 0; i < static_cast<int>(found.bases.size()); ++i)
        sizes[static_cast<std::size_t>(sets.root(i))] += found.particles[static_cast<std::size_t>(i)];
    std::erase(sizes, 0);
    std::ranges::sort(sizes, std::greater());
    return sizes;
}

}  // namespace

template <class S>
std::vector<Index> pieces(const Levels<S>& levels, const Patch<S>& patch, const Particles<S>& particles,
                          const ShapeFunction<S>& shape) {
    if (levels.count() == 1) return pieces_on(patch, particles, shape);
    return pieces_on(nodes_for_all(levels.patch(0), particles, shape), particles, shape);
}

template <class S>
double widest_spacing(const Patch<S>& patch, const Particles<S>& particles) {
    const double cell = patch.cell_size().maxCoeff();
    double widest = 0;
    for (Index p = 0; p < particles.size(); ++p) {
        auto volume = particles.value(Field::volume, 0, p);
        if constexpr (S::axisymmetric) volume /= 2 * std::numbers::pi * particles.position(p)[0];
        double stretch = 1, growth = 1;  // along the pull, and of the volume or area
        if (particles.has(Field::displacement_gradient)) {
            const auto f = ParticleBatch<S>::load_deformation_gradient(particles, p);
            const Eigen::Matrix<double, S::dimension, S::dimension> plane = f.plane.template cast<double>();
            if (!plane.allFinite()) continue;
            stretch = plane.jacobiSvd().singularValues()[0];
            growth = std::abs(plane.determinant());
        }
        const double spacing = stretch * std::pow(volume / growth, 1.0 / S::dimension) / cell;
        if (std::isfinite(spacing)) widest = std::max(widest, spacing);
    }
    return widest;
}

#define MATPOINT_INSTANTIATE(S)                                                                \
    template std::vector<Index> pieces(const Levels<S>&, const Patch<S>&, const Particles<S>&, \
                                       const ShapeFunction<S>&);                               \
    template double widest_spacing(const Patch<S>&, const Particles<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
