#include <matpoint/load.hpp>
#include <matpoint/plugin.hpp>

#include <optional>

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
        schema.add(
            "acceleration", ParameterType::profiles,
            {.unit = "m/s^2", .doc = "Components of b: numbers, tables of t, or formulas of x, y, z, t"});
        return schema;
    }

    void apply(LoadContext<S>& context) const override {
        Patch<S>& patch = context.patch;
        const Real* mass = patch.column(NodeField::mass);
        for (Index i = 0; i < patch.node_count(); ++i) {
            if (mass[i] == 0) continue;
            const auto position = patch.node_position(patch.node_coordinates(static_cast<int>(i)));
            std::array<double, 3> x{};
            for (int a = 0; a < S::dimension; ++a)
                x[static_cast<std::size_t>(a)] = static_cast<double>(position[a]);
            for (int a = 0; a < S::dimension; ++a) {
                const auto& b = acceleration_[static_cast<std::size_t>(a)];
                if (!b) continue;
                patch.column(NodeField::external_force, a)[i] +=
                    mass[i] * static_cast<Real>((*b)(x, context.time));
            }
        }
    }

  private:
    std::vector<std::optional<Profile>> acceleration_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("body_force", "1.0.0") {
    registry.load<matpoint::BodyForce>("body_force");
}
