#include "config/document.hpp"
#include "run/box_samples.hpp"
#include "run/scene_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

namespace matpoint {

namespace {

/// Samples along an axis for each particle of the finer body, and most of them in all.
constexpr double samples_per_particle = 2;
constexpr double most_samples = 4e6;
/// Bodies that share a face may overlap by so much of a cell.
constexpr double rounding = 1e-3;

/// What a place on the cross-section stands for: a ring in axisymmetric space.
template <class S>
double ring(const Eigen::Vector3d& place) {
    return S::axisymmetric ? 2 * std::numbers::pi * std::abs(place[0]) : 1;
}

/// Volume that is in two regions, whose bounds share `box`.
template <class S>
double volume_of_both(const Geometry& a, const Geometry& b, const Geometry::Bounds& box,
                      const Eigen::Vector3d& spacing) {
    Eigen::Vector3d wanted = Eigen::Vector3d::Ones();
    for (int k = 0; k < S::dimension; ++k)
        wanted[k] = std::max(2.0, std::ceil((box.max[k] - box.min[k]) / spacing[k]));
    const double thinning = std::max(1.0, std::pow(wanted.prod() / most_samples, 1.0 / S::dimension));
    std::array<Index, 3> counts{1, 1, 1};
    for (std::size_t k = 0; k < S::dimension; ++k)
        counts[k] = static_cast<Index>(std::ceil(wanted[static_cast<Eigen::Index>(k)] / thinning));
    const BoxSamples samples(box, counts);
    return samples.part(S::dimension) * samples.sum([&](std::span<const Eigen::Vector3d> places) {
        const std::vector<char> in_a = a.contains(places);
        std::vector<Eigen::Vector3d> rest;
        for (std::size_t k = 0; k < places.size(); ++k)
            if (in_a[k]) rest.push_back(places[k]);
        const std::vector<char> in_both = b.contains(rest);
        double sum = 0;
        for (std::size_t k = 0; k < rest.size(); ++k)
            if (in_both[k]) sum += ring<S>(rest[k]);
        return sum;
    });
}

/// The listed points in a box, some at a time.
template <class Take>
void for_each_point(const PointCloud& cloud, const Geometry::Bounds& box, const Take& take) {
    std::vector<PointCloud::Point> points;
    for (Index first = 0; first < cloud.size(); first += std::ssize(points)) {
        points.resize(static_cast<std::size_t>(std::min<Index>(1024, cloud.size() - first)));
        cloud.read(first, points);
        for (const PointCloud::Point& point : points)
            if ((point.position.array() >= box.min.array()).all() &&
                (point.position.array() <= box.max.array()).all())
                take(point);
    }
}

/// Volume of the listed particles that are in a region.
double volume_within(const PointCloud& cloud, const Geometry& region, const Geometry::Bounds& box) {
    double volume = 0;
    for_each_point(cloud, box, [&](const PointCloud::Point& point) {
        if (region.contains(point.position)) volume += point.volume;
    });
    return volume;
}

/// Listed particles, found by the cell of the grid that they are in.
template <class S>
class Domains {
  public:
    Domains(const Patch<S>& patch, const PointCloud& cloud, const Geometry::Bounds& box) : patch_(patch) {
        for_each_point(cloud, box, [&](const PointCloud::Point& point) {
            const Domain domain{point.position, half_size(point)};
            largest_ = largest_.cwiseMax(domain.half_size);
            by_cell_.emplace_back(key(cell_of(point.position)), domain);
        });
        std::ranges::sort(by_cell_, {}, &std::pair<std::int64_t, Domain>::first);
    }

    /// Whether the middle of one particle is in the domain of the other.
    bool overlap(const PointCloud::Point& point) const {
        const Eigen::Vector3d half = half_size(point);
        const Eigen::Vector3d reach = half.cwiseMax(largest_);
        const Cell first = cell_of(point.position - reach), last = cell_of(point.position + reach);
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y)
                for (int x = first[0]; x <= last[0]; ++x)
                    for (const auto& [unused, domain] : std::ranges::equal_range(
                             by_cell_, key({x, y, z}), {}, &std::pair<std::int64_t, Domain>::first)) {
                        const Eigen::Array3d distance = (domain.middle - point.position).cwiseAbs();
                        if ((distance <= half.array()).all() || (distance <= domain.half_size.array()).all())
                            return true;
                    }
        return false;
    }

  private:
    using Cell = std::array<int, 3>;
    struct Domain {
        Eigen::Vector3d middle, half_size;
    };

    static Eigen::Vector3d half_size(const PointCloud::Point& point) {
        if (point.half_size) return *point.half_size;
        return Eigen::Vector3d::Constant(
            std::pow(point.volume / ring<S>(point.position), 1.0 / S::dimension) / 2);
    }
    Cell cell_of(const Eigen::Vector3d& place) const {
        Cell cell{};
        for (int a = 0; a < S::dimension; ++a)
            cell[static_cast<std::size_t>(a)] =
                static_cast<int>(std::floor((place[a] - patch_.min()[a]) / patch_.cell_size()[a]));
        return cell;
    }
    static std::int64_t key(const Cell& cell) {
        constexpr std::int64_t prime = 2097143;  // cells that share a key are told apart by their distance
        return (cell[2] * prime + cell[1]) * prime + cell[0];
    }

    const Patch<S>& patch_;
    std::vector<std::pair<std::int64_t, Domain>> by_cell_;
    Eigen::Vector3d largest_ = Eigen::Vector3d::Zero();
};

template <class S>
double volume_of(const Particles<S>& particles) {
    double volume = 0;
    const auto* const column = particles.column(Field::volume);
    for (Index p = 0; p < particles.size(); ++p) volume += static_cast<double>(column[p]);
    return volume;
}

/// Bodies, two at a time.
template <class S>
class Overlap {
  public:
    explicit Overlap(const SceneParts<S>& parts) : parts_(parts) {
        for (const auto& geometry : parts.geometries) bounds_.push_back(geometry->bounds());
    }

    /// Volume that both fill, m^D.
    double volume(std::size_t i, std::size_t j) const {
        const auto box = shared_box(i, j);
        if (!box) return 0;
        const Geometry &a = *parts_.geometries[i], &b = *parts_.geometries[j];
        if (a.points() && b.points()) {
            const Domains<S> domains(parts_.patch, *a.points(), *box);
            double volume = 0;
            for_each_point(*b.points(), *box, [&](const PointCloud::Point& point) {
                if (domains.overlap(point)) volume += point.volume;
            });
            return volume;
        }
        if (a.points()) return volume_within(*a.points(), b, *box);
        if (b.points()) return volume_within(*b.points(), a, *box);
        return volume_of_both<S>(a, b, *box, spacing(i).cwiseMin(spacing(j)) / samples_per_particle);
    }

  private:
    /// What the bounds of two bodies have in common on the grid, if it is more than a face.
    std::optional<Geometry::Bounds> shared_box(std::size_t i, std::size_t j) const {
        Geometry::Bounds box{bounds_[i].min.cwiseMax(bounds_[j].min),
                             bounds_[i].max.cwiseMin(bounds_[j].max)};
        for (int a = 0; a < S::dimension; ++a) {
            const auto low = parts_.patch.min()[a],
                       high = parts_.patch.node_position(parts_.patch.cells())[a];
            box.min[a] = std::max(box.min[a], low);
            box.max[a] = std::min(box.max[a], high);
            if (!(box.max[a] - box.min[a] > rounding * parts_.patch.cell_size()[a])) return {};
        }
        return box;
    }
    Eigen::Vector3d spacing(std::size_t body) const {
        const Json& per_cell =
            parts_.scene.at("bodies").at(parts_.bodies[body].body()).at("particles_per_cell");
        Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
        for (int a = 0; a < S::dimension; ++a)
            spacing[a] =
                parts_.patch.cell_size()[a] / per_cell[static_cast<std::size_t>(a)].template get<double>();
        return spacing;
    }

    const SceneParts<S>& parts_;
    std::vector<Geometry::Bounds> bounds_;
};

bool is_meant(const Json& bodies, const std::string& a, const std::string& b) {
    const auto names = [&](const std::string& body, const std::string& other) {
        const Json& meant = bodies.at(body).at("overlaps");
        return std::find(meant.begin(), meant.end(), other) != meant.end();
    };
    return names(a, b) || names(b, a);
}

}  // namespace

template <class S>
Findings check_overlaps(const SceneParts<S>& parts) {
    Findings findings;
    const Overlap<S> overlap(parts);
    for (std::size_t j = 1; j < parts.bodies.size(); ++j)
        for (std::size_t i = 0; i < j; ++i) {
            const std::string &one = parts.bodies[i].body(), &other = parts.bodies[j].body();
            if (is_meant(parts.scene.at("bodies"), one, other)) continue;
            const double volume = overlap.volume(i, j);
            if (!(volume > 0)) continue;
            const double smaller = std::min(volume_of(parts.bodies[i]), volume_of(parts.bodies[j]));
            findings.push_back(
                {false, join_pointer("/bodies", other) + "/geometry",
                 fmt::format(
                     "overlaps with body \"{0}\": {1:.2g} m{2} are filled by both, {3:.3g} % of the smaller "
                     "one, and have the mass of both. If that is meant, say \"overlaps\": \"{0}\"",
                     one, volume,
                     S::dimension == 1                       ? ""
                     : S::dimension == 2 && !S::axisymmetric ? "^2"
                                                             : "^3",
                     100 * volume / smaller)});
        }
    return findings;
}

#define MATPOINT_INSTANTIATE(S) template Findings check_overlaps<S>(const SceneParts<S>&);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
