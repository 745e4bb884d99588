#include "config/document.hpp"
#include "run/box_samples.hpp"
#include "run/scene_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

namespace matpoint {

namespace {

constexpr std::array<Index, 3> samples_per_axis{4096, 64, 16};  ///< by dimension

/// Whether a body that reaches beyond the face goes on there as its mirror image.
template <class S>
bool is_plane_of_symmetry(const SceneParts<S>& parts, int axis, int side) {
    const auto cells = parts.patch.cells();
    typename Patch<S>::Coordinates node{};
    if (side == 1) node = cells;
    if (S::axisymmetric && axis == 0 && side == 0 && parts.patch.min()[0] == 0) return true;
    for (const PlacedCondition<S>& placed : parts.conditions) {
        if (!holds_on(placed, axis, side)) continue;
        const auto prescribed = placed.condition->prescribes(axis);
        for (int c = 0; c < S::dimension; ++c)
            if (prescribed[static_cast<std::size_t>(c)] != (c == axis)) return false;
        return placed.condition->velocity(parts.patch.node_position(node), 0)[axis] == 0;
    }
    return false;
}

/// Of the space of a geometry, the part that a condition on places is true of, as samples see it.
template <class S>
class Extent {
  public:
    Extent(const SceneParts<S>& parts, const Geometry& geometry)
        : geometry_(geometry), box_(geometry.bounds()), low_(box_.min), high_(box_.max) {
        for (int a = 0; a < S::dimension; ++a) {
            const auto i = static_cast<std::size_t>(a);
            low_[a] = parts.patch.min()[a];
            high_[a] = parts.patch.node_position(parts.patch.cells())[a];
            counts_[i] = samples_per_axis[S::dimension - 1];
            tolerance_[a] = 1e-6 * parts.patch.cell_size()[a] +
                            4 * static_cast<double>(std::numeric_limits<typename S::Real>::epsilon()) *
                                std::max(std::abs(low_[a]), std::abs(high_[a]));
            // What has no end, or goes on as its mirror image, is meant to be cut.
            if (!std::isfinite(box_.min[a]) || is_plane_of_symmetry(parts, a, 0))
                box_.min[a] = std::max(box_.min[a], low_[a]);
            if (!std::isfinite(box_.max[a]) || is_plane_of_symmetry(parts, a, 1))
                box_.max[a] = std::min(box_.max[a], high_[a]);
        }
    }

    bool reaches_beyond(int axis, int side) const {
        Geometry::Bounds beyond = box_;
        if (side == 0)
            beyond.max[axis] = low_[axis];
        else
            beyond.min[axis] = high_[axis];
        return beyond.max[axis] - beyond.min[axis] > tolerance_[axis] && weight(beyond, false) > 0;
    }

    double part_off_the_grid() const { return weight(box_, true) / weight(box_, false); }

  private:
    /// Of the samples in the geometry (and off the grid); by their rings in axisymmetric space.
    double weight(const Geometry::Bounds& box, bool only_off_grid) const {
        return BoxSamples(box, counts_).sum([&](std::span<const Eigen::Vector3d> places) {
            const std::vector<char> inside = geometry_.contains(places);
            double sum = 0;
            for (std::size_t k = 0; k < places.size(); ++k) {
                const bool off =
                    (places[k].array() < low_.array()).any() || (places[k].array() > high_.array()).any();
                if (inside[k] && (off || !only_off_grid)) sum += S::axisymmetric ? std::abs(places[k][0]) : 1;
            }
            return sum;
        });
    }

    const Geometry& geometry_;
    Geometry::Bounds box_;
    Eigen::Vector3d low_, high_;  ///< corners of the grid, m
    Eigen::Vector3d tolerance_ = Eigen::Vector3d::Zero();
    std::array<Index, 3> counts_{1, 1, 1};
};

}  // namespace

template <class S>
Findings check_extents(const SceneParts<S>& parts) {
    Findings findings;
    for (std::size_t b = 0; b < parts.bodies.size(); ++b) {
        if (parts.geometries[b]->points()) continue;  // seeding sees to each of them
        const Extent<S> extent(parts, *parts.geometries[b]);
        std::vector<std::string> faces;
        for (int axis = 0; axis < S::dimension; ++axis)
            for (int side = 0; side < 2; ++side)
                if (extent.reaches_beyond(axis, side)) faces.push_back(face_name(axis, side));
        if (faces.empty()) continue;
        findings.push_back(
            {true, join_pointer("/bodies", parts.bodies[b].body()) + "/geometry",
             fmt::format(
                 "the grid ends at {0}, and {1:.2g} % of the body is beyond: enlarge /grid, or cut the "
                 "geometry there (\"intersection\"). A body goes on beyond a plane of symmetry, a "
                 "\"slip\" condition on {0}",
                 fmt::join(faces, " and "), 100 * extent.part_off_the_grid())});
    }
    return findings;
}

#define MATPOINT_INSTANTIATE(S) template Findings check_extents<S>(const SceneParts<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
