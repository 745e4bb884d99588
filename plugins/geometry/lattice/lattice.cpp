#include <matpoint/geometry.hpp>
#include <matpoint/plugin.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

using namespace matpoint;

namespace {

/// The k-th number of a sequence that has no order, uniform in [-1, 1): a mix of k's bits
/// [Steele, Lea & Flood 2014, SplitMix64].
double scattered(std::uint64_t k) {
    k = (k + 1) * 0x9e3779b97f4a7c15U;
    k = (k ^ (k >> 30U)) * 0xbf58476d1ce4e5b9U;
    k = (k ^ (k >> 27U)) * 0x94d049bb133111ebU;
    k ^= k >> 31U;
    return std::ldexp(static_cast<double>(k >> 11U), -52) - 1;
}

}  // namespace

/// A box of equally spaced particles; see README.md.
class Lattice final : public Geometry {
  public:
    static Schema schema() {
        return Schema("A box along the axes, filled with equally spaced particles whatever the grid's cells",
                      "[Wallstedt & Guilkey 2007, section 3]")
            .vector("min", {.unit = "m", .doc = "Corner with the smallest coordinates"})
            .vector("max", {.unit = "m", .doc = "Corner with the largest coordinates"})
            .add("counts", ParameterType::per_axis,
                 {.doc = "Particles along an axis, for all axes or one per axis", .at_least = 1})
            .number("jitter",
                    {.doc = "Largest shift of a particle from its place along each axis, in parts of "
                            "their distance; the same in every run",
                     .default_value = 0,
                     .at_least = 0,
                     .at_most = 0.5})
            .refuse("/max", "every coordinate of \"max\" must be greater than that of \"min\"",
                    [](const Json& own, const Json&) {
                        for (std::size_t a = 0; a < own.at("min").size(); ++a)
                            if (!(own.at("max").at(a).get<double>() > own.at("min").at(a).get<double>()))
                                return true;
                        return false;
                    })
            .refuse("/counts", "expected whole numbers, and at most 2^32 - 1 particles in all",
                    [](const Json& own, const Json&) {
                        double all = 1;
                        for (const Json& given : own.at("counts")) {
                            const auto count = given.get<double>();
                            if (count != std::floor(count)) return true;
                            all *= count;
                        }
                        return all > std::numeric_limits<std::uint32_t>::max();
                    });
    }

    explicit Lattice(const Parameters& parameters)
        : dimension_(parameters.context().space.dimension()),
          bounds_{Eigen::Vector3d::Map(parameters.vector("min").data()),
                  Eigen::Vector3d::Map(parameters.vector("max").data())} {
        std::array<long, 3> counts{1, 1, 1};
        Eigen::Vector3d spacing = Eigen::Vector3d::Zero();
        double area = 1;
        for (int a = 0; a < dimension_; ++a) {
            const auto i = static_cast<std::size_t>(a);
            counts[i] = std::lround(parameters.vector("counts")[i]);
            spacing[a] = (bounds_.max[a] - bounds_.min[a]) / static_cast<double>(counts[i]);
            area *= spacing[a];
        }
        const double jitter = parameters.number("jitter");
        const bool axisymmetric = parameters.context().space.mode == Mode::axisymmetric;
        cloud_.points.reserve(static_cast<std::size_t>(counts[0] * counts[1] * counts[2]));
        for (long k = 0; k < counts[2]; ++k)
            for (long j = 0; j < counts[1]; ++j)
                for (long i = 0; i < counts[0]; ++i) {
                    const Eigen::Vector3d place(static_cast<double>(i), static_cast<double>(j),
                                                static_cast<double>(k));
                    Eigen::Vector3d position =
                        bounds_.min + spacing.cwiseProduct(place + Eigen::Vector3d::Constant(0.5));
                    // With r at its middle, the volume of a rectangle's ring is exact.
                    const double width = axisymmetric ? 2 * std::numbers::pi * position[0] : 1;
                    if (jitter > 0)
                        for (int a = 0; a < dimension_; ++a)
                            position[a] += jitter * spacing[a] *
                                           scattered(3 * cloud_.points.size() + static_cast<std::size_t>(a));
                    cloud_.points.push_back({position, area * width, Eigen::Vector3d::Zero(), spacing / 2});
                }
    }

    Bounds bounds() const override { return bounds_; }
    /// Single points fill no region.
    bool contains(const Eigen::Vector3d&) const override { return false; }
    const PointCloud* points() const override { return &cloud_; }

  private:
    int dimension_;
    Bounds bounds_;  ///< m
    PointCloud cloud_;
};

MATPOINT_PLUGIN("lattice", "1.0.0") {
    registry.geometry<Lattice>("lattice");
}
