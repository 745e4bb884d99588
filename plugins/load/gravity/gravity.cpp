#include <matpoint/history.hpp>
#include <matpoint/load.hpp>
#include <matpoint/plugin.hpp>

namespace matpoint {

/// The same acceleration everywhere: m_i g on every node [Chen & Brannon 2002, eq. 1-17b].
template <class S>
class Gravity final : public Load<S> {
  public:
    using typename Load<S>::Real;

    explicit Gravity(const Parameters& parameters)
        : acceleration_(parameters.vector("acceleration")), history_(parameters.json().at("history")) {}

    static Schema schema() {
        Schema schema("Uniform acceleration of all bodies", "[Chen & Brannon 2002, eq. 1-17b]");
        schema.vector("acceleration", {.unit = "m/s^2", .doc = "Acceleration g"})
            .refuse("/acceleration",
                    "x is the radius in an axisymmetric space, along which there is no uniform acceleration: "
                    "give 0, or a formula of x with the load \"body_force\"",
                    [](const Json& own, const Json& scene) {
                        return scene.at("space").at("mode") == "axisymmetric" &&
                               own.at("acceleration")[0] != 0;
                    });
        History::declare(schema);
        return schema;
    }

    void apply(LoadContext<S>& context) const override {
        Patch<S>& patch = context.patch;
        const double factor = history_(context.time);
        const Real* mass = patch.column(NodeField::mass);
        for (int a = 0; a < S::dimension; ++a) {
            const Real g = static_cast<Real>(factor * acceleration_[static_cast<std::size_t>(a)]);
            Real* force = patch.column(NodeField::external_force, a);
            for (Index i = 0; i < patch.node_count(); ++i) force[i] += mass[i] * g;
        }
    }

    double settled_at() const override { return history_.settled_at(); }

  private:
    std::array<double, 3> acceleration_;
    History history_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("gravity", "1.0.0") {
    registry.load<matpoint::Gravity>("gravity");
}
