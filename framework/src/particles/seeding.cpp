#include "particles/seeding.hpp"

#include <matpoint/parallel.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace matpoint {

namespace {

/// Candidates handed to the geometry at a time, about.
constexpr Index candidates_per_task = 65536;

/// What the particles' numbers can tell apart.
constexpr double most_places = std::numeric_limits<std::uint32_t>::max();

/// Volume of what a particle's cross-section sweeps: 2 pi r when axisymmetric. With r at its middle,
/// the volume of a rectangle's ring is exact.
template <class S>
double width(const Eigen::Vector3d& position) {
    return S::axisymmetric ? 2 * std::numbers::pi * position[0] : 1;
}

/// The lattice's coordinates along an axis in cells first … last - 1, and nothing for missing axes.
struct Axis {
    int first = 0, last = 1;
    int per_cell = 1;
    double half_size = 0;
    std::vector<double> coordinates{0.0};

    Index cells() const { return last - first; }
    double at(int cell, int k) const {
        return coordinates[static_cast<std::size_t>((cell - first) * per_cell + k)];
    }
};

template <class S>
Axis lattice_axis(const Patch<S>& patch, const Geometry::Bounds& bounds, int a, int per_cell) {
    Axis axis;
    const double min = static_cast<double>(patch.min()[a]), h = static_cast<double>(patch.cell_size()[a]);
    const double cells = patch.cells()[static_cast<std::size_t>(a)];
    // One cell more on both sides, for the rounding of bounds that lie on a cell's face.
    axis.first = static_cast<int>(std::clamp(std::floor((bounds.min[a] - min) / h) - 1, 0.0, cells));
    axis.last = static_cast<int>(std::clamp(std::floor((bounds.max[a] - min) / h) + 2, 0.0, cells));
    axis.last = std::max(axis.first, axis.last);
    axis.per_cell = per_cell;
    axis.half_size = h / (2 * per_cell);
    axis.coordinates.clear();
    for (int cell = axis.first; cell < axis.last; ++cell)
        for (int k = 0; k < per_cell; ++k)
            axis.coordinates.push_back(min + (cell + (k + 0.5) / per_cell) * h);
    return axis;
}

using Points = std::vector<Eigen::Vector3d>;

/// The lattice in the geometry's box, and those of its points that the geometry contains, a list for each
/// task.
struct Filling {
    Eigen::Vector3d half_size;  ///< m, of every particle
    double area;                ///< m^D, of a particle's cross-section
    std::vector<Points> points;
};

template <class S>
Filling fill_region(const Patch<S>& patch, const Geometry& geometry, const std::array<int, 3>& per_cell) {
    const Geometry::Bounds bounds = geometry.bounds();
    std::array<Axis, 3> axes;
    double places = 1;
    for (int a = 0; a < S::dimension; ++a) {
        const auto i = static_cast<std::size_t>(a);
        axes[i] = lattice_axis(patch, bounds, a, per_cell[i]);
        places *= static_cast<double>(axes[i].coordinates.size());
    }
    if (places > most_places)
        throw std::invalid_argument(
            fmt::format("its box holds {:.3g} places for particles, more than {:.3g}: take larger cells",
                        places, most_places));
    const auto& [x, y, z] = axes;
    Filling filling{{x.half_size, y.half_size, z.half_size}, 1, {}};
    for (int a = 0; a < S::dimension; ++a) filling.area *= 2 * filling.half_size[a];

    // A task is some rows of cells along x; putting the tasks' points together in their order makes
    // the particles' order independent of the threads.
    const Index rows = y.cells() * z.cells();
    const Index points_per_row = std::max<Index>(1, x.cells() * x.per_cell * y.per_cell * z.per_cell);
    const Index rows_per_task = std::max<Index>(1, candidates_per_task / points_per_row);
    const Index tasks = (rows + rows_per_task - 1) / rows_per_task;
    filling.points.resize(static_cast<std::size_t>(tasks));
    parallel_for(tasks, rows * points_per_row, [&](Index task) {
        Points candidates;
        candidates.reserve(static_cast<std::size_t>(rows_per_task * points_per_row));
        for (Index row = task * rows_per_task; row < std::min(rows, (task + 1) * rows_per_task); ++row) {
            const int cy = y.first + static_cast<int>(row % y.cells()),
                      cz = z.first + static_cast<int>(row / y.cells());
            for (int cx = x.first; cx < x.last; ++cx)
                for (int kz = 0; kz < z.per_cell; ++kz)
                    for (int ky = 0; ky < y.per_cell; ++ky)
                        for (int kx = 0; kx < x.per_cell; ++kx)
                            candidates.emplace_back(x.at(cx, kx), y.at(cy, ky), z.at(cz, kz));
        }
        const std::vector<char> inside = geometry.contains(candidates);
        Points& kept = filling.points[static_cast<std::size_t>(task)];
        kept.reserve(candidates.size() -
                     static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 0)));
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (inside[i]) kept.push_back(candidates[i]);
    });
    return filling;
}

template <class S>
void expect_on_grid(const Patch<S>& patch, const PointCloud& cloud, const std::string& body) {
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        const PointCloud::Point& point = cloud.points[i];
        bool outside = S::axisymmetric && point.position[0] <= 0;
        for (int a = 0; a < S::dimension; ++a) {
            const double cell = (point.position[a] - static_cast<double>(patch.min()[a])) /
                                static_cast<double>(patch.cell_size()[a]);
            outside = outside || !(cell >= 0 && cell < patch.cells()[static_cast<std::size_t>(a)]);
        }
        if (outside)
            throw std::invalid_argument(
                fmt::format("body \"{}\": point {} of its geometry's {}, at [{}], is outside the grid", body,
                            i + 1, cloud.points.size(),
                            fmt::join(point.position.data(), point.position.data() + S::dimension, ", ")));
    }
}

/// Sets one particle after the other.
template <class S>
class Sower {
  public:
    Sower(Particles<S>& particles, Index count, double density, const InitialVelocity& velocity)
        : particles_(particles), density_(density), velocity_(velocity) {
        if (count == 0)
            throw std::invalid_argument(
                fmt::format("body \"{}\": its geometry contains no particle; check that it lies within the "
                            "grid and is not smaller than the distance between particles, "
                            "the cell size over \"particles_per_cell\"",
                            particles.body()));
        particles.resize(count);
    }

    /// `volume` in m^3 (m^2 in plane strain, m in 1D; of the whole ring when axisymmetric); `velocity`, m/s,
    /// is added to the body's.
    void sow(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity,
             const Eigen::Vector3d& half_size, double volume) {
        set(Field::position, position);
        set(Field::initial_position, position);
        set(Field::velocity, velocity_ ? Eigen::Vector3d(velocity_(position) + velocity) : velocity);
        set(Field::half_size, half_size);
        set(Field::initial_half_size, half_size);
        particles_.column(Field::volume)[next_] = static_cast<Real>(volume);
        particles_.column(Field::mass)[next_] = static_cast<Real>(density_ * volume);
        ++next_;
    }

  private:
    using Real = typename S::Real;

    void set(Field field, const Eigen::Vector3d& value) {
        if (!particles_.has(field)) return;
        for (int a = 0; a < S::dimension; ++a)
            particles_.column(field, a)[next_] = static_cast<Real>(value[a]);
    }

    Particles<S>& particles_;
    double density_;  // kg/m^3
    const InitialVelocity& velocity_;
    Index next_ = 0;
};

}  // namespace

template <class S>
void seed(Particles<S>& particles, const Patch<S>& patch, const Geometry& geometry,
          const std::array<int, 3>& particles_per_cell, double density, const InitialVelocity& velocity) {
    if (const PointCloud* const cloud = geometry.points()) {
        expect_on_grid(patch, *cloud, particles.body());
        Sower<S> sower(particles, static_cast<Index>(cloud->points.size()), density, velocity);
        for (const PointCloud::Point& point : cloud->points) {
            const double size = std::pow(point.volume / width<S>(point.position), 1.0 / S::dimension);
            sower.sow(point.position, point.velocity,
                      point.half_size.value_or(Eigen::Vector3d::Constant(size / 2)), point.volume);
        }
        return;
    }
    const Filling filling = fill_region(patch, geometry, particles_per_cell);
    Index count = 0;
    for (const Points& points : filling.points) count += static_cast<Index>(points.size());
    Sower<S> sower(particles, count, density, velocity);
    for (const Points& points : filling.points)
        for (const Eigen::Vector3d& position : points)
            sower.sow(position, Eigen::Vector3d::Zero(), filling.half_size,
                      filling.area * width<S>(position));
}

#define MATPOINT_INSTANTIATE(S)                                                                       \
    template void seed<S>(Particles<S>&, const Patch<S>&, const Geometry&, const std::array<int, 3>&, \
                          double, const InitialVelocity&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
