#include <matpoint/history.hpp>
#include <matpoint/load.hpp>
#include <matpoint/plugin.hpp>

#include "../surface_force.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {

/// A force per present area on one side of a body, carried by its boundary particles.
template <class S>
class Traction final : public Load<S> {
  public:
    using typename Load<S>::Real;
    using typename Load<S>::Vector;

    explicit Traction(const Parameters& parameters)
        : body_(parameters.text("body")),
          face_(parameters.text("face")),
          thickness_(parameters.has("thickness") ? parameters.number("thickness") : 0),
          at_surface_(parameters.text("method") == "surface_point"),
          field_("traction_" + parameters.text("face") +
                 (thickness_ > 0 ? "_" + parameters.json().at("thickness").dump() : std::string())),
          history_(parameters.json().at("history")) {
        const auto traction = parameters.vector("traction");
        for (int a = 0; a < S::dimension; ++a) traction_[a] = traction[static_cast<std::size_t>(a)];
    }

    static Schema schema();

    void declare(Particles<S>& particles) override {
        if (particles.body() != body_) return;
        particles.require(Field::initial_half_size);
        if (S::dimension > 1) particles.require(Field::displacement_gradient);
        area_ = particles.require(field_, 1);
    }

    /// Gives boundary particles their share of the face's area, m^2; the others have none.
    void start(const Patch<S>&, std::span<Particles<S>> bodies) override {
        Particles<S>& particles = body(bodies);
        const double plane = face_.plane(particles);
        double area = 0, volume = 0;
        for (Index p = 0; p < particles.size(); ++p) {
            const double own = face_.initial_area(particles, p, plane, thickness_);
            particles.column(area_, 0)[p] = static_cast<Real>(own);
            area += own;
            volume += static_cast<double>(particles.column(Field::volume)[p]);
        }
        const double depth = face_.depth(particles);
        if (!(area * depth > 1e-6 * volume))
            throw std::invalid_argument("the face has no area: it lies on the axis");
        if (thickness_ > depth * (1 + 1e-6))
            throw std::invalid_argument("the boundary layer is thicker than the body, which is " +
                                        std::to_string(depth) + " m from this face to the opposite one");
    }

    void apply(LoadContext<S>& context) const override {
        const double factor = history_(context.time);
        if (factor == 0) return;
        const Particles<S>& particles = body(context.bodies);
        std::vector<PointSource<S>> sources;
        for (Index p = 0; p < particles.size(); ++p) {
            const Real area = particles.column(area_, 0)[p];
            if (area == 0) continue;
            const Real stretch = face_.area_stretch(particles, p);
            const Vector force =
                (static_cast<Real>(factor) * area * stretch * traction_.template cast<Real>()).eval();
            if (at_surface_)
                add_at_surface(context, face_, particles, p, force);
            else
                sources.push_back({particles.position(p), present_half_size(particles, p), force});
        }
        context.spread(particles, sources, NodeField::external_force);
    }

    double settled_at() const override { return history_.settled_at(); }

  private:
    Particles<S>& body(std::span<Particles<S>> bodies) const {
        return *std::find_if(bodies.begin(), bodies.end(), [&](const auto& b) { return b.body() == body_; });
    }

    std::string body_;
    Face<S> face_;
    double thickness_;  ///< m; 0: one particle
    bool at_surface_;
    std::string field_;
    History history_;
    Eigen::Matrix<double, S::dimension, 1> traction_;
    int area_ = -1;  ///< particle field
};

template <class S>
Schema Traction<S>::schema() {
    const auto given = [](const Json& own, const char* key) {
        return own.contains(key) && !own.at(key).is_null();
    };
    Schema schema("Force per area on one side of a body, which moves with it",
                  "[Chen & Brannon 2002, eq. 1-5, 1-16]");
    schema.add("body", ParameterType::reference, {.doc = "The body that is loaded", .section = "bodies"})
        .choice("face", {.doc = "Side of the body at the start",
                         .choices = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"}})
        .vector("traction", {.unit = "Pa", .doc = "Force per present area", .paper = "c = rho c^s"})
        .choice("method",
                {.doc = "surface_point: at the surface itself; boundary_layer: spread over the volume of "
                        "the boundary particles",
                 .paper = "[Chen & Brannon 2002, sec. 2]",
                 .default_value = "surface_point",
                 .choices = {"surface_point", "boundary_layer"}})
        .number("thickness",
                {.unit = "m",
                 .doc = "Thickness h of the boundary layer at the start; by default one particle",
                 .paper = "[Chen & Brannon 2002, eq. 1-5]",
                 .optional = true,
                 .greater_than = 0})
        .refuse("/thickness", "belongs to method \"boundary_layer\"",
                [=](const Json& own, const Json&) {
                    return given(own, "thickness") && own.at("method") != "boundary_layer";
                })
        .refuse("/face", "the scene has no such axis", [](const Json& own, const Json& scene) {
            return own.at("face").get<std::string>()[0] - 'x' >= scene.at("space").at("dimension").get<int>();
        });
    History::declare(schema);
    return schema;
}

}  // namespace matpoint

MATPOINT_PLUGIN("traction", "1.0.0") {
    registry.load<matpoint::Traction>("traction");
}
