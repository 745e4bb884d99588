#include <matpoint/load.hpp>
#include <matpoint/parallel.hpp>
#include <matpoint/plugin.hpp>

#include "../surface_force.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace matpoint {

/// The body force of the scene's exact solution, on the particles: f_i = sum_p S_ip m_p b(X_p, t), the source
/// term of [Wallstedt & Guilkey 2008, eq. 52]. If asked for, its tractions on sides of the bodies too.
template <class S>
class Manufactured final : public Load<S> {
  public:
    using typename Load<S>::Real;
    using typename Load<S>::Vector;

    explicit Manufactured(const Parameters& parameters) {
        for (const std::string& face : parameters.texts("tractions_on"))
            sides_.push_back({Face<S>(face), "traction_area_" + face});
    }

    static Schema schema() {
        Schema schema("Body force, and tractions, of the scene's exact solution",
                      "[Wallstedt & Guilkey 2008, section 5]");
        schema
            .add("tractions_on", ParameterType::texts,
                 {.doc = "Sides of the bodies at the start (\"x_max\") that get the solution's traction",
                  .default_value = Json::array()})
            .refuse("", "needs an `exact_solution` in the scene",
                    [](const Json&, const Json& scene) { return !scene.contains("exact_solution"); })
            .refuse("/tractions_on", "expected sides such as \"x_min\" along axes that the scene has",
                    [](const Json& own, const Json& scene) {
                        const auto axes = std::string("xyz").substr(
                            0, scene.at("space").at("dimension").get<std::size_t>());
                        return std::ranges::any_of(own.at("tractions_on"), [&](const Json& given) {
                            const auto side = given.get<std::string>();
                            return side.empty() || axes.find(side[0]) == std::string::npos ||
                                   (side.substr(1) != "_min" && side.substr(1) != "_max");
                        });
                    });
        return schema;
    }

    void declare(Particles<S>& particles) override {
        if (sides_.empty()) return;
        particles.require(Field::initial_half_size);
        for (const Side& side : sides_) particles.require(side.field, 1);
    }

    void start(const Patch<S>&, std::span<Particles<S>> bodies) override {
        for (const Side& side : sides_)
            for (Particles<S>& particles : bodies) {
                const double plane = side.face.plane(particles);
                Real* area = particles.column(particles.slot(side.field), 0);
                for (Index p = 0; p < particles.size(); ++p)
                    area[p] = static_cast<Real>(side.face.initial_area(particles, p, plane, 0));
            }
    }

    void apply(LoadContext<S>& context) const override {
        for (const Particles<S>& particles : context.bodies) {
            if (!context.exact_solution->covers(particles.body())) continue;
            add_body_force(context, particles);
            for (const Side& side : sides_) add_traction(context, particles, side);
        }
    }

    double settled_at() const override { return std::numeric_limits<double>::infinity(); }

  private:
    struct Side {
        Face<S> face;
        std::string field;  ///< of the particles: their share of the side's area at the start, m^2
    };

    static Eigen::Vector3d reference(const Particles<S>& particles, Index p) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        x.head<S::dimension>() = particles.position(p, Field::initial_position);
        return x;
    }

    void add_body_force(LoadContext<S>& context, const Particles<S>& particles) const {
        constexpr Index per_task = 256;
        const Real* mass = particles.column(Field::mass);
        sources_.resize(static_cast<std::size_t>(particles.size()));
        parallel_for((particles.size() + per_task - 1) / per_task, particles.size(), [&](Index task) {
            for (Index p = task * per_task; p < std::min(particles.size(), (task + 1) * per_task); ++p) {
                const Eigen::Vector3d b = guarded(*context.exact_solution, "body_force", [&] {
                    return context.exact_solution->body_force(reference(particles, p), context.time);
                });
                PointSource<S>& source = sources_[static_cast<std::size_t>(p)];
                source.position = particles.position(p);
                source.half_size = particles.has(Field::half_size) ? particles.vector(Field::half_size, p)
                                                                   : Vector(Vector::Zero());
                source.value = mass[p] * b.head<S::dimension>().template cast<Real>();
            }
        });
        context.spread(particles, sources_, NodeField::external_force);
    }

    /// P N per initial area, at the surface.
    void add_traction(LoadContext<S>& context, const Particles<S>& particles, const Side& side) const {
        const Real* area = particles.column(particles.slot(side.field), 0);
        for (Index p = 0; p < particles.size(); ++p) {
            if (area[p] == 0) continue;
            Eigen::Vector3d x = reference(particles, p);
            x[side.face.axis()] += side.face.sign() * static_cast<double>(particles.column(
                                                          Field::initial_half_size, side.face.axis())[p]);
            const Eigen::Matrix3d f = context.exact_solution->deformation_gradient(x, context.time);
            const Eigen::Matrix3d nominal =
                f.determinant() * context.exact_solution->stress(x, context.time) * f.inverse().transpose();
            const Eigen::Vector3d force =
                static_cast<double>(area[p]) * side.face.sign() * nominal.col(side.face.axis());
            add_at_surface(context, side.face, particles, p,
                           Vector(force.head<S::dimension>().template cast<Real>()));
        }
    }

    std::vector<Side> sides_;
    mutable std::vector<PointSource<S>> sources_;  ///< kept, so that steps don't allocate
};

}  // namespace matpoint

MATPOINT_PLUGIN("manufactured", "1.0.0") {
    registry.load<matpoint::Manufactured>("manufactured");
}
