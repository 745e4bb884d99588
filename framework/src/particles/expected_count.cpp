#include "particles/expected_count.hpp"

#include <algorithm>
#include <vector>

namespace matpoint {

namespace {

/// Samples along an axis: 4096 in every dimension.
constexpr std::array<int, 3> samples_per_axis{4096, 64, 16};

/// The part of a geometry's box that is within the grid.
template <class S>
Geometry::Bounds box_on_grid(const Patch<S>& patch, const Geometry& geometry) {
    Geometry::Bounds box = geometry.bounds();
    const auto last = patch.node_position(patch.cells());
    for (int a = 0; a < S::dimension; ++a) {
        box.min[a] = std::max(box.min[a], patch.min()[a]);
        box.max[a] = std::max(box.min[a], std::min(box.max[a], static_cast<double>(last[a])));
    }
    return box;
}

}  // namespace

template <class S>
double most_particles(const Patch<S>& patch, const Geometry& geometry, const std::array<int, 3>& per_cell) {
    if (const PointCloud* const cloud = geometry.points()) return static_cast<double>(cloud->size());
    const Geometry::Bounds box = box_on_grid(patch, geometry);
    double places = 1;
    for (int a = 0; a < S::dimension; ++a)
        places *= (box.max[a] - box.min[a]) / patch.cell_size()[a] * per_cell[static_cast<std::size_t>(a)];
    return places;
}

template <class S>
double expected_particles(const Patch<S>& patch, const Geometry& geometry,
                          const std::array<int, 3>& per_cell) {
    const double most = most_particles(patch, geometry, per_cell);
    if (geometry.points()) return most;
    const Geometry::Bounds box = box_on_grid(patch, geometry);
    const int n = samples_per_axis[S::dimension - 1];
    const Eigen::Vector3d spacing = (box.max - box.min) / n;
    const auto layers = [](int axis) { return axis < S::dimension ? samples_per_axis[S::dimension - 1] : 1; };
    std::vector<Eigen::Vector3d> samples;
    for (int k = 0; k < layers(2); ++k)
        for (int j = 0; j < layers(1); ++j)
            for (int i = 0; i < n; ++i) {
                Eigen::Vector3d x =
                    box.min + spacing.cwiseProduct(Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5));
                for (int a = S::dimension; a < 3; ++a) x[a] = 0;
                samples.push_back(x);
            }
    const std::vector<char> inside = geometry.contains(samples);
    const auto hits = std::ssize(inside) - std::count(inside.begin(), inside.end(), 0);
    return most * static_cast<double>(hits) / static_cast<double>(samples.size());
}

#define MATPOINT_INSTANTIATE(S)                                                                     \
    template double most_particles<S>(const Patch<S>&, const Geometry&, const std::array<int, 3>&); \
    template double expected_particles<S>(const Patch<S>&, const Geometry&, const std::array<int, 3>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
