#include <matpoint/load.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace matpoint {

/// An acceleration given by position and time: m_i b(x_i, t) on every node
/// [Chen & Brannon 2002, eq. 1-17b].
template <class S>
class BodyForce final : public Load<S> {
  public:
    using typename Load<S>::Real;

    explicit BodyForce(const Parameters& parameters) {
        for (const Json& component : parameters.json().at("acceleration"))
            acceleration_.push_back(component.is_null() ? std::nullopt : std::optional<Profile>(component));
    }

    static Schema schema() {
        Schema schema("Force per mass, given by position and time", "[Chen & Brannon 2002, eq. 1-17b]");
        return schema
            .add("acceleration", ParameterType::profiles,
                 {.unit = "m/s^2", .doc = "Components of b: numbers, tables of t, or formulas of x, y, z, t"})
            .refuse("/acceleration", "has no component: there is no force", [](const Json& own, const Json&) {
                return std::ranges::all_of(own.at("acceleration"), &Json::is_null);
            });
    }

    void start(const Patch<S>& patch, std::span<Particles<S>> bodies) override {
        if constexpr (S::axisymmetric) refuse_at_axis(patch, bodies);
    }

    void apply(LoadContext<S>& context) const override {
        Patch<S>& patch = context.patch;
        const Real* mass = patch.column(NodeField::mass);
        for (Index i = 0; i < patch.node_count(); ++i) {
            if (mass[i] == 0) continue;
            const auto position = patch.node_position(patch.node_coordinates(static_cast<int>(i)));
            std::array<double, 3> x{};
            std::copy_n(position.data(), S::dimension, x.begin());
            for (int a = 0; a < S::dimension; ++a) {
                const auto& b = acceleration_[static_cast<std::size_t>(a)];
                if (!b) continue;
                patch.column(NodeField::external_force, a)[i] +=
                    mass[i] * static_cast<Real>((*b)(x, context.time));
            }
        }
    }

    double settled_at() const override {
        double time = 0;
        for (const auto& component : acceleration_)
            if (component) time = std::max(time, component->settled_at());
        return time;
    }

  private:
    /// Nothing is drawn along the radius where that is 0.
    void refuse_at_axis(const Patch<S>& patch, std::span<Particles<S>> bodies) const {
        if (patch.min()[0] != 0 || !acceleration_[0]) return;
        for (const Particles<S>& particles : bodies)
            for (Index p = 0; p < particles.size(); ++p) {
                const auto x = particles.position(p);
                if (x[0] < patch.cell_size()[0] &&
                    (*acceleration_[0])({0, static_cast<double>(x[1]), 0}, 0) != 0)
                    throw std::invalid_argument("body \"" + particles.body() +
                                                "\" is at the axis of the axisymmetric space: the "
                                                "acceleration along the radius x must be "
                                                "0 there, as a formula such as \"3*x\" is");
            }
    }

    std::vector<std::optional<Profile>> acceleration_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("body_force", "1.0.0") {
    registry.load<matpoint::BodyForce>("body_force");
}
