#include "config/kinds.hpp"
#include "config/scene.hpp"

namespace matpoint {
namespace {

std::shared_ptr<Schema> nested(Schema schema) {
    return std::make_shared<Schema>(std::move(schema));
}

Schema space_schema() {
    return Schema("Space of the simulation")
        .integer("dimension", {.doc = "Number of axes of the grid", .at_least = 1, .at_most = 3})
        .choice("mode",
                {.doc = "How directions outside the grid behave; by default bar in 1D, plane_strain in 2D, "
                        "solid in 3D. plane_stress: a sheet 1 m thick at the start, whose thickness is free",
                 .optional = true,
                 .choices = {"bar", "plane_strain", "plane_stress", "axisymmetric", "solid"}})
        .choice(
            "precision",
            {.doc = "Of floating-point numbers", .default_value = "double", .choices = {"double", "single"}})
        .refuse("/precision",
                "this Matpoint was built for double precision alone: build it with "
                "-DMATPOINT_SINGLE_PRECISION=ON",
                [](const Json& own, const Json&) { return !has_single && own.at("precision") == "single"; });
}

Schema time_schema() {
    Schema schema("Simulated time and its step");
    schema
        .number("end",
                {.unit = "s", .doc = "The run ends with the first step at or past it", .greater_than = 0})
        .number("step", {.unit = "s", .doc = "Fixed time step", .optional = true, .greater_than = 0})
        .number("cfl", {.doc = "Time step over the time that a wave, a particle, or what loads move from "
                               "rest takes to cross a cell; 0.4 if `step` is absent",
                        .optional = true,
                        .at_most = 2,
                        .greater_than = 0})
        .number(
            "wave_speed",
            {.unit = "m/s",
             .doc = "Speed that `cfl` refers to, for a constant step; by default the largest speed of a wave "
                    "plus that of a particle, at every step",
             .optional = true,
             .greater_than = 0})
        .number(
            "until_at_rest",
            {.doc = "The run ends before, at rest: when loads and boundaries no longer change, the "
                    "unbalanced force is below this part of the forces in balance, and the kinetic energy "
                    "below its square of the largest energy so far",
             .optional = true,
             .at_most = 0.1,
             .greater_than = 0})
        .integer(
            "max_steps",
            {.doc = "The run ends after so many steps, wherever it is", .optional = true, .at_least = 1});
    schema.refuse("/cfl", "give `step` or `cfl`, not both",
                  [](const Json& own, const Json&) { return own.contains("step") && own.contains("cfl"); });
    return schema.refuse(
        "/wave_speed", "belongs to `cfl`; with `step` it has no meaning",
        [](const Json& own, const Json&) { return own.contains("wave_speed") && own.contains("step"); });
}

Schema viscosity_schema() {
    return Schema("Artificial pressure q under compression, D = tr L < 0, beside the stress of the material",
                  "[von Neumann & Richtmyer 1950; Landshoff 1955; Chen & Brannon 2002, sec. 2]")
        .choice("form", {.doc = "landshoff: q = rho (linear c h |D| + quadratic h^2 D^2). chen_brannon: "
                                "eq. 2-1 with g = h/c, q = sqrt(c h rho lambda |D|) (linear + quadratic "
                                "|D| / max |D|)",
                         .default_value = "landshoff",
                         .choices = {"landshoff", "chen_brannon"}})
        .number("linear", {.doc = "c1", .default_value = 0.2, .at_least = 0})
        .number("quadratic", {.doc = "c2", .default_value = 2.0, .at_least = 0})
        .number("bulk_modulus", {.unit = "Pa",
                                 .doc = "lambda of chen_brannon; by default rho c^2",
                                 .optional = true,
                                 .greater_than = 0})
        .refuse("/bulk_modulus", "belongs to the form chen_brannon", [](const Json& own, const Json&) {
            return own.at("form") == "landshoff" && own.contains("bulk_modulus");
        });
}

Schema body_schema() {
    return Schema("Particles of one material")
        .add("material", ParameterType::reference, {.doc = "A name in /materials", .section = "materials"})
        .add("particles_per_cell", ParameterType::per_axis,
             {.doc = "A number in all, or one per axis; by default 2 per axis",
              .default_value = 2,
              .start_only = true,
              .at_least = 1})
        .choice(
            "seeding",
            {.doc = "What a particle stands for. filled: what the geometry fills of its part of the cell, so "
                    "that the body has the geometry's volume. centres: the whole part, if its centre is in "
                    "the geometry.",
             .default_value = "filled",
             .start_only = true,
             .choices = {"filled", "centres"}})
        .add("velocity", ParameterType::profiles,
             {.unit = "m/s",
              .doc = "Initial velocity by position",
              .default_value = 0,
              .start_only = true,
              .variables = "xyz"})
        .add("overlaps", ParameterType::references,
             {.doc = "Bodies that may fill the same space, with the mass of both",
              .default_value = Json::array(),
              .start_only = true,
              .section = "bodies"})
        .add("artificial_viscosity", ParameterType::object,
             {.doc = "A pressure against compression, which spreads shocks over a few cells",
              .optional = true,
              .nested = nested(viscosity_schema())})
        .add("geometry", ParameterType::component,
             {.doc = "The region to fill", .start_only = true, .kind = "geometry"});
}

Schema accuracy_schema() {
    return Schema(
               "How accurate the result should be; answered with a recommendation, the scene runs as it is")
        .number("target", {.doc = "Relative error of what the scene is about", .greater_than = 0});
}

Schema checkpoint_schema() {
    Schema schema("Saved states that a run can go on from");
    schema
        .number("every",
                {.unit = "s", .doc = "Simulated time between two", .optional = true, .greater_than = 0})
        .integer("every_steps", {.doc = "Steps between two", .optional = true, .at_least = 1})
        .integer("keep", {.doc = "How many of the latest stay", .default_value = 2, .at_least = 1});
    schema.refuse(
        "", "give `every` or `every_steps`: without one, no state is saved",
        [](const Json& own, const Json&) { return !own.contains("every") && !own.contains("every_steps"); });
    schema.warn("/every", "no state is ever saved: the run ends before",
                [](const Json& own, const Json& scene) {
                    return own.value("every", 0.0) > scene.at("/time/end"_json_pointer).get<double>();
                });
    return refuse_two_intervals(schema);
}

Schema health_schema() {
    return Schema("What to do when the numbers break down")
        .boolean("enabled", {.doc = "Whether to look", .default_value = true})
        .choice("off_grid", {.doc = "For a particle that has left the grid",
                             .default_value = "error",
                             .choices = {"error", "delete"}})
        .choice("unstable_step", {.doc = "For a time step beyond the limit of stability",
                                  .default_value = "error",
                                  .choices = {"error", "warn", "ignore"}})
        .number("energy_drift", {.doc = "Drift of the energy balance, over the largest energy, beyond which "
                                        "the run is warned of",
                                 .default_value = 0.05,
                                 .at_least = 0})
        .number("energy_gain",
                {.doc = "Energy from nowhere, over what the start, loads and walls have given, "
                        "beyond which the run breaks down",
                 .default_value = 0.5,
                 .at_least = 0});
}

Schema make_scene_schema() {
    const auto type = [](const char* name) { return Json{{"type", name}}; };
    const auto none = Json::array();
    return Schema("A Matpoint scene")
        .integer("matpoint", {.doc = "Version of the scene format", .at_least = 1, .at_most = 1})
        .text("title", {.doc = "One line; by default the file's name", .optional = true})
        .text("comment", {.doc = "For readers", .optional = true})
        .text("$schema", {.doc = "The JSON Schema, for editors", .optional = true})
        .add("space", ParameterType::object,
             {.doc = "Space of the simulation", .start_only = true, .nested = nested(space_schema())})
        .add("grid", ParameterType::component, {.doc = "Background grid", .start_only = true, .kind = "grid"})
        .add("shape_function", ParameterType::component,
             {.doc = "Grid basis and particle domain",
              .default_value = type("bspline"),
              .kind = "shape_function"})
        .add("transfer", ParameterType::component,
             {.doc = "How velocity goes to the grid and back",
              .default_value = type("affine_flip"),
              .kind = "transfer"})
        .add("integrator", ParameterType::component,
             {.doc = "Order of the phases of a step",
              .default_value = type("central_difference"),
              .kind = "integrator"})
        .add("time", ParameterType::object, {.doc = "Simulated time", .nested = nested(time_schema())})
        .add("materials", ParameterType::map,
             {.doc = "Constitutive models by name", .at_least = 1, .kind = "material"})
        .add("bodies", ParameterType::map,
             {.doc = "Particles by name", .at_least = 1, .nested = nested(body_schema())})
        .add("loads", ParameterType::components,
             {.doc = "Body forces and tractions", .default_value = none, .kind = "load"})
        .add("contacts", ParameterType::components,
             {.doc = "Between bodies, or with rigid tools", .default_value = none, .kind = "contact"})
        .add("boundary_conditions", ParameterType::components,
             {.doc = "On grid faces or regions", .default_value = none, .kind = "boundary_condition"})
        .add("damping", ParameterType::component,
             {.doc = "Leads the scene to rest", .optional = true, .kind = "damping"})
        .add("exact_solution", ParameterType::component,
             {.doc = "Turns error measurement on",
              .optional = true,
              .start_only = true,
              .kind = "exact_solution"})
        .add("outputs", ParameterType::components, {.doc = "Files", .default_value = none, .kind = "output"})
        .add("accuracy", ParameterType::object,
             {.doc = "Accuracy that is wanted; answered with a recommendation",
              .optional = true,
              .nested = nested(accuracy_schema())})
        .add("checkpoint", ParameterType::object,
             {.doc = "Saved states", .optional = true, .nested = nested(checkpoint_schema())})
        .add("health", ParameterType::object,
             {.doc = "Breakdown of the numbers",
              .default_value = Json::object(),
              .nested = nested(health_schema())})
        .add("plugins", ParameterType::texts,
             {.doc = "Paths of shared libraries, beside those found by the types named",
              .default_value = none})
        .add("checks", ParameterType::any, {.doc = "What must hold after the run", .optional = true})
        .add("resolved_with", ParameterType::any,
             {.doc = "Plugin versions of a resolved scene; ignored", .optional = true});
}

}  // namespace

const Schema& scene_schema() {
    static const Schema schema = make_scene_schema();
    return schema;
}

}  // namespace matpoint
