#include "particles/seeding.hpp"

#include <matpoint/parallel.hpp>

#include "particles/filled_places.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace matpoint {

namespace {

/// Volume of what a particle's cross-section sweeps: 2 pi r when axisymmetric. With r at its centroid
/// the volume of the ring is exact, whatever the cross-section (Pappus).
template <class S>
double width(const Eigen::Vector3d& position) {
    return S::axisymmetric ? 2 * std::numbers::pi * position[0] : 1;
}

/// Edge of the square or cube of a particle's volume.
template <class S>
double edge(const PointCloud::Point& point) {
    return std::pow(point.volume / width<S>(point.position), 1.0 / S::dimension);
}

/// The particles that a geometry lists, in its order.
class Listed {
  public:
    explicit Listed(const PointCloud& cloud) : cloud_(cloud) {}

    Index size() const { return cloud_.size(); }
    Index pieces() const { return (size() + piece_size - 1) / piece_size; }
    Index begin(Index piece) const { return piece * piece_size; }
    template <class Take>
    void for_each(Index piece, const Take& take) const {
        std::vector<PointCloud::Point> points(
            static_cast<std::size_t>(std::min(piece_size, size() - begin(piece))));
        cloud_.read(begin(piece), points);
        for (const PointCloud::Point& point : points) take(point);
    }

  private:
    static constexpr Index piece_size = 1024;
    const PointCloud& cloud_;
};

/// The particles of a region's places.
template <class S>
class Sown {
  public:
    explicit Sown(const FilledPlaces& places) : places_(places) {}

    Index size() const { return places_.size(); }
    Index pieces() const { return places_.pieces(); }
    Index begin(Index piece) const { return places_.begin(piece); }
    template <class Take>
    void for_each(Index piece, const Take& take) const {
        places_.for_each(
            piece, [&](const Eigen::Vector3d& middle, const Eigen::Vector3d& edges, double area) {
                take(PointCloud::Point{middle, area * width<S>(middle), Eigen::Vector3d::Zero(), edges / 2});
            });
    }

  private:
    const FilledPlaces& places_;
};

template <class S>
bool on_grid(const Patch<S>& patch, const Eigen::Vector3d& position) {
    if (S::axisymmetric && position[0] <= 0) return false;
    for (int a = 0; a < S::dimension; ++a) {
        const double cell = (position[a] - patch.min()[a]) / patch.cell_size()[a];
        if (!(cell >= 0 && cell < patch.cells()[static_cast<std::size_t>(a)])) return false;
    }
    return true;
}

template <class S>
void expect_on_grid(const Patch<S>& patch, const Listed& listed, const std::string& body) {
    std::vector<std::string> mistakes(static_cast<std::size_t>(listed.pieces()));
    parallel_for(listed.pieces(), listed.size(), [&](Index piece) {
        std::string& mistake = mistakes[static_cast<std::size_t>(piece)];
        Index number = listed.begin(piece);
        listed.for_each(piece, [&](const PointCloud::Point& point) {
            ++number;
            if (!mistake.empty() || on_grid(patch, point.position)) return;
            mistake = fmt::format(
                "body \"{}\": point {} of its geometry's {}, at [{}], is outside the grid", body, number,
                listed.size(), fmt::join(point.position.data(), point.position.data() + S::dimension, ", "));
        });
    });
    for (const std::string& mistake : mistakes)
        if (!mistake.empty()) throw std::invalid_argument(mistake);
}

template <class S>
void set(Particles<S>& particles, Field field, Index p, const Eigen::Vector3d& value) {
    if (!particles.has(field)) return;
    for (int a = 0; a < S::dimension; ++a) particles.set_value(field, a, p, value[a]);
}

/// Sets one particle after the other, beside those that there are. Pieces may be sown at the same time;
/// velocities are not, because a formula is evaluated by one thread at a time.
template <class S, class Source>
void sow(Particles<S>& particles, const Source& source, double density, const InitialVelocity& velocity) {
    using Real = typename S::Real;
    const Index first = particles.size();
    particles.resize(first + source.size());
    parallel_for(source.pieces(), source.size(), [&](Index piece) {
        Index p = first + source.begin(piece);
        source.for_each(piece, [&](const PointCloud::Point& point) {
            const Eigen::Vector3d half_size =
                point.half_size ? *point.half_size : Eigen::Vector3d::Constant(edge<S>(point) / 2);
            set(particles, Field::position, p, point.position);
            set(particles, Field::initial_position, p, point.position);
            set(particles, Field::velocity, p, point.velocity);
            set(particles, Field::half_size, p, half_size);
            set(particles, Field::initial_half_size, p, half_size);
            particles.set_value(Field::volume, 0, p, point.volume);
            particles.column(Field::mass)[p] = static_cast<Real>(density * point.volume);
            ++p;
        });
    });
    for (Index piece = 0; velocity && piece < source.pieces(); ++piece) {
        Index p = first + source.begin(piece);
        source.for_each(piece, [&](const PointCloud::Point& point) {
            set(particles, Field::velocity, p++, velocity(point.position) + point.velocity);
        });
    }
}

template <class S>
void expect_particles(const Particles<S>& particles) {
    if (particles.size() == 0)
        throw std::invalid_argument(fmt::format(
            "body \"{}\": its geometry contains no particle; check that it lies within the grid, and with "
            "\"seeding\": \"centres\" that it is not smaller than the distance between particles, "
            "the cell size over \"particles_per_cell\"",
            particles.body()));
}

}  // namespace

template <class S>
void seed(Particles<S>& particles, const Patch<S>& patch, const Geometry& geometry,
          const std::array<int, 3>& particles_per_cell, double density, const InitialVelocity& velocity,
          Seeding seeding) {
    if (const PointCloud* const cloud = geometry.points()) {
        const Listed listed(*cloud);
        expect_on_grid(patch, listed, particles.body());
        sow(particles, listed, density, velocity);
    } else {
        const CellLattice lattice(cell_axes(patch), geometry.bounds(), particles_per_cell);
        const FilledPlaces places(lattice, geometry, seeding);
        sow(particles, Sown<S>(places), density, velocity);
    }
    expect_particles(particles);
}

template <class S>
void seed(Particles<S>& particles, const Levels<S>& levels, const Geometry& geometry,
          const std::array<int, 3>& particles_per_cell, double density, const InitialVelocity& velocity,
          Seeding seeding) {
    if (levels.count() == 1)
        return seed(particles, levels.patch(0), geometry, particles_per_cell, density, velocity, seeding);
    const auto set_level = [&](Index p, int level) {
        for (const char* field : {refinement_field, level_field})
            particles.column(particles.slot(field), 0)[p] = static_cast<typename S::Real>(level);
    };
    if (geometry.points()) {
        seed(particles, levels.patch(0), geometry, particles_per_cell, density, velocity, seeding);
        for (Index p = 0; p < particles.size(); ++p) set_level(p, levels.at(particles.position(p)));
        return;
    }
    for (int level = 0; level < levels.count(); ++level) {
        const Index first = particles.size();
        const FilledPlaces places(
            {cell_axes(levels, level), levels.bounds(level, geometry.bounds()), particles_per_cell}, geometry,
            seeding, [&](const CellLattice::Place& place) {
                typename Patch<S>::Coordinates cell;
                std::copy_n(place.begin(), S::dimension, cell.begin());
                return levels.belongs(level, cell);
            });
        sow(particles, Sown<S>(places), density, velocity);
        for (Index p = first; p < particles.size(); ++p) set_level(p, level);
    }
    expect_particles(particles);
}

#define MATPOINT_INSTANTIATE(S)                                                                        \
    template void seed<S>(Particles<S>&, const Patch<S>&, const Geometry&, const std::array<int, 3>&,  \
                          double, const InitialVelocity&, Seeding);                                    \
    template void seed<S>(Particles<S>&, const Levels<S>&, const Geometry&, const std::array<int, 3>&, \
                          double, const InitialVelocity&, Seeding);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
