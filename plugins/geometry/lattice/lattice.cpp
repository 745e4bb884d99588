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
class Lattice final : public Geometry, public PointCloud {
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
          axisymmetric_(parameters.context().space.mode == Mode::axisymmetric),
          bounds_{Eigen::Vector3d::Map(parameters.vector("min").data()),
                  Eigen::Vector3d::Map(parameters.vector("max").data())},
          jitter_(parameters.number("jitter")) {
        for (int a = 0; a < dimension_; ++a) {
            const auto i = static_cast<std::size_t>(a);
            counts_[i] = std::lround(parameters.vector("counts")[i]);
            spacing_[a] = (bounds_.max[a] - bounds_.min[a]) / static_cast<double>(counts_[i]);
            area_ *= spacing_[a];
        }
    }

    Bounds bounds() const override { return bounds_; }
    /// Single points fill no region.
    bool contains(const Eigen::Vector3d&) const override { return false; }
    const PointCloud* points() const override { return this; }

    Index size() const override { return counts_[0] * counts_[1] * counts_[2]; }
    void read(Index first, std::span<Point> points) const override {
        for (Index k = 0; k < std::ssize(points); ++k) points[static_cast<std::size_t>(k)] = point(first + k);
    }

  private:
    Point point(Index number) const {
        const Index row = number / counts_[0];
        const Eigen::Vector3d place(static_cast<double>(number % counts_[0]),
                                    static_cast<double>(row % counts_[1]),
                                    static_cast<double>(row / counts_[1]));
        Eigen::Vector3d position =
            bounds_.min + spacing_.cwiseProduct(place + Eigen::Vector3d::Constant(0.5));
        // With r at its middle, the volume of a rectangle's ring is exact.
        const double width = axisymmetric_ ? 2 * std::numbers::pi * position[0] : 1;
        if (jitter_ > 0)
            for (int a = 0; a < dimension_; ++a)
                position[a] += jitter_ * spacing_[a] * scattered(static_cast<std::uint64_t>(3 * number + a));
        return {position, area_ * width, Eigen::Vector3d::Zero(), spacing_ / 2};
    }

    int dimension_;
    bool axisymmetric_;
    Bounds bounds_;  ///< m
    double jitter_;  ///< in parts of the spacing
    std::array<Index, 3> counts_{1, 1, 1};
    Eigen::Vector3d spacing_ = Eigen::Vector3d::Zero();  ///< m
    double area_ = 1;                                    ///< m^D, of a particle's cross-section
};

MATPOINT_PLUGIN("lattice", "1.0.0") {
    registry.geometry<Lattice>("lattice");
}
