#include <matpoint/load.hpp>
#include <matpoint/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace matpoint {

/// An acceleration given by position and time: m_i b(x_i, t) on every node, or of every particle
/// [Chen & Brannon 2002, eq. 1-17b].
template <class S>
class BodyForce final : public Load<S> {
  public:
    using typename Load<S>::Real;
    using typename Load<S>::Vector;

    explicit BodyForce(const Parameters& parameters)
        : at_particles_(parameters.text("at") == "particles"),
          where_(parameters.text("coordinates") == "material" ? Field::initial_position : Field::position) {
        for (const Json& component : parameters.json().at("acceleration"))
            acceleration_.push_back(component.is_null() ? std::nullopt : std::optional<Profile>(component));
    }

    static Schema schema() {
        Schema schema("Force per mass, given by position and time", "[Chen & Brannon 2002, eq. 1-17b]");
        return schema
            .add("acceleration", ParameterType::profiles,
                 {.unit = "m/s^2", .doc = "Components of b: numbers, tables of t, or formulas of x, y, z, t"})
            .choice("at", {.doc = "Where formulas are evaluated, and whose mass they act on",
                           .default_value = "nodes",
                           .choices = {"nodes", "particles"}})
            .choice("coordinates",
                    {.doc = "What x, y, z are: where a particle is at present, or where it was at "
                            "the start",
                     .default_value = "present",
                     .choices = {"present", "material"}})
            .refuse("/coordinates", "nodes have no material coordinates: they need \"at\": \"particles\"",
                    [](const Json& own, const Json&) {
                        return own.at("coordinates") == "material" && own.at("at") == "nodes";
                    })
            .refuse("/acceleration", "has no component: there is no force", [](const Json& own, const Json&) {
                return std::ranges::all_of(own.at("acceleration"), &Json::is_null);
            });
    }

    void declare(Particles<S>& particles) override { particles.require(where_); }

    void start(const Patch<S>& patch, std::span<Particles<S>> bodies) override {
        if constexpr (S::axisymmetric) refuse_at_axis(patch, bodies);
    }

    void apply(LoadContext<S>& context) const override {
        if (at_particles_)
            apply_at_particles(context);
        else
            apply_at_nodes(context);
    }

    double settled_at() const override {
        double time = 0;
        for (const auto& component : acceleration_)
            if (component) time = std::max(time, component->settled_at());
        return time;
    }

  private:
    void apply_at_nodes(LoadContext<S>& context) const {
        Patch<S>& patch = context.patch;
        const Real* mass = patch.column(NodeField::mass);
        for (Index i = 0; i < patch.node_count(); ++i) {
            if (mass[i] == 0) continue;
            const Vector b = acceleration(patch.position_at(static_cast<int>(i)), context.time);
            for (int a = 0; a < S::dimension; ++a)
                patch.column(NodeField::external_force, a)[i] += mass[i] * b[a];
        }
    }

    void apply_at_particles(LoadContext<S>& context) const {
        std::vector<PointSource<S>> sources;
        for (const Particles<S>& particles : context.bodies) {
            sources.clear();
            for (Index p = 0; p < particles.size(); ++p)
                sources.push_back({particles.position(p),
                                   particles.has(Field::half_size) ? particles.vector(Field::half_size, p)
                                                                   : Vector(Vector::Zero()),
                                   Vector(particles.column(Field::mass)[p] *
                                          acceleration(particles.position(p, where_), context.time))});
            context.spread(particles, sources, NodeField::external_force);
        }
    }

    Vector acceleration(const typename S::Position& place, double time) const {
        std::array<double, 3> x{};
        std::copy_n(place.data(), S::dimension, x.begin());
        Vector b = Vector::Zero();
        for (int a = 0; a < S::dimension; ++a)
            if (const auto& component = acceleration_[static_cast<std::size_t>(a)])
                b[a] = static_cast<Real>((*component)(x, time));
        return b;
    }

    /// Nothing is drawn along the radius where that is 0.
    void refuse_at_axis(const Patch<S>& patch, std::span<Particles<S>> bodies) const {
        if (patch.min()[0] != 0 || !acceleration_[0]) return;
        const double settled = std::isfinite(settled_at()) ? settled_at() : 0;  // s, the end of a table
        const auto drawn = [&](double y, double time) { return (*acceleration_[0])({0, y, 0}, time) != 0; };
        for (const Particles<S>& particles : bodies)
            for (Index p = 0; p < particles.size(); ++p) {
                const auto x = particles.position(p);
                if (x[0] < patch.cell_size()[0] && (drawn(x[1], 0) || drawn(x[1], settled)))
                    throw std::invalid_argument("body \"" + particles.body() +
                                                "\" is at the axis of the axisymmetric space: the "
                                                "acceleration along the radius x must be "
                                                "0 there, as a formula such as \"3*x\" is");
            }
    }

    bool at_particles_;
    Field where_;  ///< of a particle: what formulas take
    std::vector<std::optional<Profile>> acceleration_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("body_force", "1.0.0") {
    registry.load<matpoint::BodyForce>("body_force");
}
