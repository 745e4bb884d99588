#include "verify/check.hpp"

#include <matpoint/field_shape.hpp>
#include <matpoint/profile.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace matpoint {
namespace {

/// The place of a component called "x", "xy", … (or not named, if the field has only one).
int component_of(const RunView& view, const std::string& body, const std::string& field,
                 const Json& particles) {
    const std::vector<std::string> fields = view.fields(body);
    if (std::find(fields.begin(), fields.end(), field) == fields.end()) {
        throw std::runtime_error(fmt::format("body \"{}\" has no field \"{}\"; there are {}", body, field,
                                             fmt::join(fields, ", ")));
    }
    const int count = view.components(body, field);
    const std::vector<std::string> names =
        component_names(field_shape(field, count, view.space()), count, view.space());
    if (!particles.contains("component") && count == 1) return 0;
    const std::string name = particles.value("component", "");
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        throw std::runtime_error(fmt::format("{} has no component \"{}\"; expected one of {}", field, name,
                                             fmt::join(names, ", ")));
    }
    return static_cast<int>(found - names.begin());
}

struct Norms {
    double l1 = 0, l2 = 0, linf = 0;
};

CheckResult evaluate_particles(const Json& check, const FinishedRun& run) {
    const Json& particles = check.at("particles");
    const std::string body = particles.at("body"), field = particles.at("field"), norm = check.at("norm");

    const auto simulation = Simulation::create(run.scene, run.catalogue);
    simulation->restore(run.result.final_state);
    const std::vector<std::string> bodies = simulation->bodies();
    if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) {
        throw std::runtime_error(
            fmt::format("there is no body \"{}\"; there are {}", body, fmt::join(bodies, ", ")));
    }
    if (simulation->particle_count(body) == 0) throw std::runtime_error("no particle is left");
    const std::vector<double> values =
        simulation->column(body, field, component_of(*simulation, body, field, particles));
    std::vector<std::array<double, 3>> positions(values.size());
    for (int axis = 0; axis < simulation->space().dimension(); ++axis) {
        const std::vector<double> x = simulation->column(body, "initial_position", axis);
        for (std::size_t p = 0; p < x.size(); ++p) positions[p][static_cast<std::size_t>(axis)] = x[p];
    }

    const Profile formula(check.at("formula"));
    const std::string missing =
        std::string("xyz").substr(static_cast<std::size_t>(simulation->space().dimension()));
    if (const auto axis = formula.variables().find_first_of(missing); axis != std::string::npos)
        throw std::runtime_error(
            fmt::format("the formula depends on {}, which the space has not", formula.variables()[axis]));
    const double time = simulation->time();
    Norms norms;
    std::size_t worst = 0;
    for (std::size_t p = 0; p < values.size(); ++p) {
        const double deviation = std::abs(values[p] - formula(positions[p], time));
        norms.l1 += deviation;
        norms.l2 += deviation * deviation;
        if (!(deviation <= norms.linf)) {
            norms.linf = deviation;
            worst = p;
        }
    }
    norms.l1 /= static_cast<double>(values.size());
    norms.l2 = std::sqrt(norms.l2 / static_cast<double>(values.size()));

    const double measured = norm == "l1" ? norms.l1 : norm == "l2" ? norms.l2 : norms.linf;
    const double below = check.at("below");
    const std::array<double, 3>& x = positions[worst];
    return {.holds = measured < below,
            .measured = fmt::format("{} of {} {}: {:.3g} {} {:.3g}", norm, body, field, measured,
                                    measured < below ? "<" : "not <", below),
            .where = fmt::format("worst from ({:g}, {:g}, {:g}), where it is {:.9g}, expected {:.9g}", x[0],
                                 x[1], x[2], values[worst], formula(x, time))};
}

}  // namespace

CheckKind particles_check() {
    Schema which("A component of a field of a body's particles");
    which.add("body", ParameterType::reference, {.doc = "Name of a body", .section = "bodies"})
        .text("field", {.doc = "As in outputs: \"stress\", \"velocity\""})
        .text("component", {.doc = "\"x\", \"xy\", …; not for scalars", .optional = true});
    Schema schema("A field of the particles at the end of the run against a formula");
    schema
        .add("particles", ParameterType::object,
             {.doc = "What is measured", .nested = std::make_shared<Schema>(std::move(which))})
        .profile(
            "formula",
            {.doc = "What it should be; x, y, z are the particle's initial position (m), t the time of the "
                    "run's end (s)"})
        .choice("norm", {.doc = "Of the deviations: mean (l1), root mean square (l2) or largest (linf)",
                         .default_value = "linf",
                         .choices = {"l1", "l2", "linf"}})
        .number("below", {.doc = "The norm must be less (SI)", .greater_than = 0})
        .text("comment", {.doc = "For readers", .optional = true});
    return {"particles", schema, evaluate_particles};
}

}  // namespace matpoint
