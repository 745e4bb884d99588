#include "touching.hpp"

#include <matpoint/plugin.hpp>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace matpoint {
namespace {

/// A rigid body of any geometry that pushes bodies; see README.md.
template <class S>
class RigidTool final : public Tool<S> {
  public:
    using typename Contact<S>::Real;
    using typename Contact<S>::Vector;
    static constexpr int D = S::dimension;

    static Schema schema() {
        Schema schema("A rigid tool that bodies can't enter: it pushes them, and rubs, but doesn't pull",
                      "[Ma, Lu, Wang, Roy, Hornung, Wissink & Komanduri 2005, section 2.1]");
        return schema
            .add("bodies", ParameterType::references,
                 {.doc = "Bodies that it acts on; all by default", .optional = true, .section = "bodies"})
            .add("geometry", ParameterType::component,
                 {.doc = "What it fills at the start", .kind = "geometry"})
            .add("motion", ParameterType::object,
                 {.doc = "How it moves; it rests by default",
                  .optional = true,
                  .nested = std::make_shared<Schema>(Motion::schema())})
            .number("friction",
                    {.doc = "Coefficient mu of Coulomb's friction", .default_value = 0, .at_least = 0})
            .choice(
                "method",
                {.doc = "Whether particles' surfaces are kept out of it, by pressures on them, or nodes, by "
                        "the gap between the surfaces there",
                 .paper = "[Ma et al. 2005, eq. 8-11]",
                 .default_value = "pressures",
                 .choices = {"pressures", "nodes"}})
            .refuse("/bodies", "acts on no body: name some, or leave it out for all",
                    [](const Json& own, const Json&) {
                        return own.contains("bodies") && own.at("bodies").is_array() &&
                               own.at("bodies").empty();
                    });
    }

    explicit RigidTool(const Parameters& parameters)
        : bodies_(parameters.has("bodies") ? parameters.texts("bodies") : std::vector<std::string>{}),
          geometry_(parameters.geometry("geometry")),
          motion_(parameters.has("motion") ? &parameters.json().at("motion") : nullptr, parameters,
                  guarded(*geometry_, "anchor", [&] { return geometry_->anchor(); })),
          friction_(parameters.number("friction")),
          end_(parameters.context().scene->at("time").at("end").get<double>()),
          by_particles_(parameters.text("method") == "pressures"),
          forces_("contact_force:" + parameters.text("name")),
          pressures_("contact_pressure:" + parameters.text("name")),
          overlaps_("contact_overlap:" + parameters.text("name")),
          touching_(geometry_) {
        guarded(*geometry_, "signed_distance", [&] { geometry_->signed_distance(motion_.centre()); });
        Eigen::Vector3d::Map(report_.position.data()) = motion_.centre();
    }

    void declare(Particles<S>& particles) const override {
        if (!acts_on(particles)) return;
        particles.require(Field::initial_half_size);
        particles.require(Field::displacement_gradient);
        if (!by_particles_) return;
        particles.require(forces_, D);
        particles.require(pressures_, 1);
        particles.require(overlaps_, 1);
    }

    /// The boxes of particles at an oblique surface stand out of it: what overlaps so at the start may.
    std::vector<std::string> start(const Patch<S>& patch, std::span<Particles<S>> bodies) override {
        for (Particles<S>& particles : bodies) {
            if (!acts_on(particles)) continue;
            double deepest = 0;
            typename S::Position place = S::Position::Zero();
            touching_.for_gaps(patch, particles, motion_,
                               [&](Index p, const auto& x, const auto& surface, double gap) {
                                   if (by_particles_)
                                       particles.column(particles.slot(overlaps_), 0)[p] =
                                           static_cast<Real>(std::max(0.0, -gap));
                                   if (surface.distance < deepest) deepest = surface.distance, place = x;
                               });
            if (deepest < 0)
                throw std::invalid_argument(
                    "body \"" + particles.body() + "\" is in the tool at the start: a particle at " +
                    text_of(place) + " is " + text_of(-deepest) + " m inside. Move one of them away");
        }
        return warnings(patch);
    }

    void act(ToolContext<S>& context) override {
        motion_.begin_step(context.time, context.dt);
        touching_.begin(context);
        for (std::size_t b = 0; b < context.bodies.size(); ++b) {
            Particles<S>& particles = context.bodies[b];
            if (!acts_on(particles)) continue;
            if (by_particles_)
                add_particles(context, b);
            else
                touching_.add_nodes(context, b, motion_);
        }
        Impulses<D>& impulses = touching_.impulses();
        refuse_leap(context);
        impulses.solve(motion_, friction_);
        for (const auto& node : impulses.nodes)
            context.push(node.body, node.place, node.impulse.template cast<Real>());
        if (by_particles_) {
            keep_forces(context);
            keep_pressures(context);
        }
        account(context);
        motion_.end_step(context.dt);
        Eigen::Vector3d::Map(report_.position.data()) = motion_.centre();
    }

    ContactReport report() const override { return report_; }
    SignedDistance signed_distance(const Eigen::Vector3d& point) const override {
        return touching_.signed_distance(point, motion_);
    }
    double settled_at() const override { return motion_.settled_at(); }

    std::map<std::string, double> state() const override {
        std::map<std::string, double> state = motion_.state();
        visit_report(report_, [&](const std::string& name, double value) { state[name] = value; });
        return state;
    }
    void restore(const std::map<std::string, double>& state) override {
        motion_.restore(state);
        visit_report(report_, [&](const std::string& name, double& value) { value = state.at(name); });
    }

  private:
    bool acts_on(const Particles<S>& particles) const {
        return bodies_.empty() || std::ranges::find(bodies_, particles.body()) != bodies_.end();
    }

    template <class Number>
    static std::string text_of(const Number& number) {
        std::ostringstream text;
        if constexpr (std::is_arithmetic_v<Number>)
            text << number;
        else
            text << "(" << number.transpose().format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ")) << ")";
        return text.str();
    }

    /// Whether it gets, as prescribed, to where no body can be.
    std::vector<std::string> warnings(const Patch<S>& patch) const {
        constexpr int samples = 256;
        const typename S::Position size = patch.node_position(patch.cells()) - patch.min(),
                                   middle = patch.min() + size / 2;
        Motion ahead = motion_;
        for (int k = 0; k <= samples; ++k) {
            if (touching_.distance(middle, ahead) > size.norm() / 2)
                return {k == 0 ? "the tool is off the grid, where no body is"
                               : "the tool leaves the grid, where no body is, before t = " +
                                     text_of(k * end_ / samples) + " s"};
            if (motion_.is_free()) break;
            ahead.begin_step(k * end_ / samples, end_ / samples);
            ahead.end_step(end_ / samples);
        }
        return {};
    }

    /// Bodies can't give way to what is faster than their waves, which go less than a cell in a step.
    void refuse_leap(const ToolContext<S>& context) {
        const double cell = context.nodes.back()->cell_size().minCoeff();
        for (const auto& point : touching_.impulses().points) {
            const double cells =
                motion_.velocity_at(Impulses<D>::full(point.place)).norm() * context.dt / cell;
            if (cells > 1)
                throw std::runtime_error(
                    "the tool moves by " + text_of(cells) +
                    " cells in a step: it is faster than waves in the bodies. Slow it down");
        }
    }

    /// They start from the forces of the last step.
    void add_particles(const ToolContext<S>& context, std::size_t body) {
        Particles<S>& particles = context.bodies[body];
        const int slot = particles.slot(forces_);
        Real* const overlap = particles.column(particles.slot(overlaps_), 0);
        touching_.add_particles(
            context, body, motion_,
            [&](Index p) {
                typename S::Position force;
                for (int c = 0; c < D; ++c) force[c] = static_cast<double>(particles.column(slot, c)[p]);
                return typename S::Position(force * context.dt);
            },
            [&](Index p, double gap) {
                if (gap > 0) overlap[p] = 0;  // from then on it is as any other
                return static_cast<double>(overlap[p]);
            });
    }

    void keep_forces(const ToolContext<S>& context) {
        for (Particles<S>& particles : context.bodies) {
            if (!acts_on(particles)) continue;
            for (int c = 0; c < D; ++c)
                std::fill_n(particles.column(particles.slot(forces_), c), particles.size(), Real(0));
            std::fill_n(particles.column(particles.slot(pressures_), 0), particles.size(), Real(0));
        }
        for (std::size_t k = 0; k < touching_.origins().size(); ++k) {
            const auto& origin = touching_.origins()[k];
            Particles<S>& particles = context.bodies[origin.body];
            const auto& point = touching_.impulses().points[k];
            const typename S::Position force = point.impulse / context.dt;
            for (int c = 0; c < D; ++c)
                particles.column(particles.slot(forces_), c)[origin.particle] = static_cast<Real>(force[c]);
        }
    }

    /// Forces over the areas that particles have across the normal, both as nodes see them: those of single
    /// particles are not unique, those of nodes are.
    void keep_pressures(const ToolContext<S>& context) {
        const Impulses<D>& impulses = touching_.impulses();
        shares_.assign(impulses.nodes.size(), {});
        const auto visit = [&](const auto& point, const auto& action) {
            for (std::size_t k = point.begin; k < point.end; ++k) {
                const auto& part = impulses.parts[k];
                const double weight = part.weight.dot(point.normal.cwiseAbs2());
                if (weight > 0) action(shares_[static_cast<std::size_t>(part.node)], weight);
            }
        };
        for (std::size_t k = 0; k < impulses.points.size(); ++k) {
            const auto& point = impulses.points[k];
            if (point.impulse.isZero(0)) continue;
            const auto& origin = touching_.origins()[k];
            const Particles<S>& particles = context.bodies[origin.body];
            const double area = particles.value(Field::volume, 0, origin.particle) /
                                (2 * Touching<S>::half_width(particles, origin.particle, point.normal));
            visit(point, [&](Share& share, double weight) {
                share.force += weight * point.impulse.dot(point.normal) / context.dt;
                share.area += weight * area;
            });
        }
        for (std::size_t k = 0; k < impulses.points.size(); ++k) {
            const auto& point = impulses.points[k];
            if (point.impulse.isZero(0)) continue;
            double pressure = 0, whole = 0;
            visit(point, [&](const Share& share, double weight) {
                pressure += weight * share.force / share.area;
                whole += weight;
            });
            const auto& origin = touching_.origins()[k];
            Particles<S>& particles = context.bodies[origin.body];
            particles.column(particles.slot(pressures_), 0)[origin.particle] =
                static_cast<Real>(pressure / whole);
        }
    }

    void account(const ToolContext<S>& context) {
        Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = force;
        const Impulses<D>& impulses = touching_.impulses();
        for (std::size_t k = 0; k < impulses.points.size(); ++k) {
            const auto& point = impulses.points[k];
            const double gap = touching_.origins()[k].gap, cell = touching_.origins()[k].cell;
            report_.penetration = std::max(report_.penetration, -gap / cell);
            if (point.impulse.isZero(0)) continue;
            if (report_.touched == 0) report_.first_gap = gap / cell;
            report_.touched = 1;
            const Eigen::Vector3d on_tool = -Impulses<D>::full(point.impulse) / context.dt;
            force += on_tool;
            torque += (Impulses<D>::full(point.place) - motion_.centre()).cross(on_tool);
            const typename S::Position across =
                point.impulse - point.impulse.dot(point.normal) * point.normal;
            report_.friction_work -= across.dot(point.approach + impulses.velocity(point, motion_)) / 2;
        }
        Eigen::Vector3d::Map(report_.force.data()) = force;
        Eigen::Vector3d::Map(report_.torque.data()) = torque;
        Eigen::Vector3d::Map(report_.impulse.data()) += force * context.dt;
    }

    /// What a node gets of forces, N, and of the areas that they act on, m^2.
    struct Share {
        double force = 0, area = 0;
    };

    std::vector<std::string> bodies_;  ///< empty: all
    std::shared_ptr<Geometry> geometry_;
    Motion motion_;
    double friction_, end_;  ///< coefficient; s, of the run
    bool by_particles_;
    std::string forces_, pressures_, overlaps_;  ///< fields of the particles, N, Pa, and m at the start
    Touching<S> touching_;
    std::vector<Share> shares_;  ///< by node of the impulses
    ContactReport report_;
};

}  // namespace
}  // namespace matpoint

MATPOINT_PLUGIN("rigid_tool", "1.0.0") {
    registry.contact<matpoint::RigidTool>("rigid_tool");
}
