#include "study/study_schema.hpp"

#include "verify/statistics.hpp"

namespace matpoint {
namespace {

std::shared_ptr<Schema> nested(Schema schema) {
    return std::make_shared<Schema>(std::move(schema));
}

bool is_pointer(const Json& text) {
    try {
        return Json::json_pointer(text.get<std::string>()).to_string() == text && text != "";
    } catch (const Json::exception&) {
        return false;
    }
}

Schema& add_summary(Schema& schema, ParameterOptions options) {
    return schema.text("summary", std::move(options))
        .text("label", {.doc = "What tables and axes call it; by default the pointer", .optional = true})
        .refuse("/summary", "expected a JSON pointer into summary.json, such as \"/error/linf\"",
                [](const Json& own, const Json&) {
                    return own.contains("summary") && !is_pointer(own.at("summary"));
                });
}

Schema measure_schema() {
    Schema schema("A number taken from a probe's file, as by a check of this form");
    describe_statistic(schema);
    return schema;
}

Schema accuracy_schema() {
    Schema schema(
        "What is called the error of a variant: a number in its summary.json, or one taken from a probe's "
        "file, "
        "without its sign or less what is exact");
    return add_summary(schema, {.doc = "JSON pointer into summary.json, \"/error/linf\"", .optional = true})
        .add("measure", ParameterType::object,
             {.doc = "In place of `summary`: a statistic of a probe of the scene",
              .optional = true,
              .nested = nested(measure_schema())})
        .refuse(
            "", "give `summary` or `measure`, one of both",
            [](const Json& own, const Json&) { return own.contains("summary") == own.contains("measure"); })
        .number("exact", {.doc = "The error is the distance from it", .optional = true})
        .refuse(
            "/exact", "is known exactly: leave `reference` out",
            [](const Json& own, const Json&) { return own.contains("exact") && own.contains("reference"); })
        .number("scale",
                {.doc = "The error is divided by it; by default by `exact` or the reference, if there is one",
                 .optional = true,
                 .greater_than = 0})
        .choice("reference",
                {.doc = "Without an exact solution: the error is the distance from the limit that "
                        "the finest values of `along` lead to",
                 .optional = true,
                 .choices = {"finest"}})
        .text("along",
              {.doc = "JSON pointer of the varied value that refines", .default_value = "/grid/cell_size"});
}

Schema cost_schema() {
    Schema schema("What a variant costs: a number in its summary.json");
    return add_summary(schema, {.doc = "JSON pointer into summary.json", .default_value = "/cpu_seconds"});
}

/// What both sorts of file have.
Schema common_schema(const char* doc) {
    return Schema(doc)
        .text("title", {.doc = "One line; by default the file's name", .optional = true})
        .text("comment", {.doc = "For readers", .optional = true})
        .add("scene", ParameterType::file, {.doc = "The scene to vary, relative to this file"})
        .add("set", ParameterType::any,
             {.doc = "Values of the scene to replace in all variants, by JSON pointer", .optional = true})
        .add("variants", ParameterType::any,
             {.doc = "Named sets of values to replace, each a variant", .optional = true})
        .add("vary", ParameterType::any,
             {.doc = "Lists or ranges of values by JSON pointer; all combinations are variants",
              .optional = true})
        .boolean("keep_outputs",
                 {.doc = "Whether the outputs and checkpoints of the scene are written and kept",
                  .default_value = false});
}

Schema search_schema() {
    return Schema("Where to look for the limit")
        .text("pointer", {.doc = "JSON pointer into the scene"})
        .number("from", {.doc = "Smallest value"})
        .number("to", {.doc = "Largest value"})
        .integer("digits",
                 {.doc = "Significant digits of the limit", .default_value = 2, .at_least = 1, .at_most = 12})
        .boolean("largest", {.doc = "Whether the largest stable value is looked for; else the smallest",
                             .default_value = true})
        .refuse("/to", "must be more than `from`", [](const Json& own, const Json&) {
            return !(own.at("to").get<double>() > own.at("from").get<double>());
        });
}

Schema stable_schema() {
    Schema schema("Which runs are stable: those that complete with this number below a bound");
    return add_summary(schema, {.doc = "JSON pointer into summary.json"})
        .number("below", {.doc = "The number, without its sign, must be less"});
}

}  // namespace

Schema study_schema() {
    return common_schema("A study: what variants of a scene cost, and how accurate they are")
        .add("accuracy", ParameterType::object,
             {.doc = "The error of a variant", .nested = nested(accuracy_schema())})
        .add("cost", ParameterType::object,
             {.doc = "The cost of a variant",
              .default_value = Json::object(),
              .nested = nested(cost_schema())})
        .number("target", {.doc = "The cheapest variant with at most this error is written as best.json",
                           .optional = true,
                           .greater_than = 0})
        .choice("timing", {.doc = "quiet: one run at a time, so that times are measured without neighbours; "
                                  "shared: as many as there are cores",
                           .default_value = "shared",
                           .choices = {"shared", "quiet"}})
        .add("plots", ParameterType::any, {.doc = "Further plots", .optional = true});
}

Schema limits_schema() {
    return common_schema("Where variants of a scene stop being stable")
        .add("search", ParameterType::object,
             {.doc = "Where to look for the limit", .nested = nested(search_schema())})
        .add("stable", ParameterType::object,
             {.doc = "Which runs are stable", .nested = nested(stable_schema())});
}

Schema plot_schema() {
    return Schema("A plot of quantities of the variants")
        .text("name", {.doc = "Of its file: letters, digits, _ and -"})
        .text("title", {.doc = "Above it", .optional = true})
        .text("x", {.doc = "A varied value, by JSON pointer, or a measured one: cost, particle_steps, …"})
        .text("y", {.doc = "The same", .default_value = "error"})
        .add("lines", ParameterType::texts,
             {.doc = "What tells the lines apart: \"variant\" and varied values; by default whatever is no "
                     "number",
              .optional = true})
        .add("where", ParameterType::any,
             {.doc = "Only variants with these values, by JSON pointer", .optional = true})
        .text("x_label", {.doc = "By default that of the quantity", .optional = true})
        .text("y_label", {.doc = "By default that of the quantity", .optional = true})
        .choice("x_scale", {.doc = "Of the axis", .optional = true, .choices = {"linear", "log"}})
        .choice("y_scale", {.doc = "Of the axis", .optional = true, .choices = {"linear", "log"}})
        .number("x_divisor", {.doc = "x is divided by it", .optional = true, .greater_than = 0})
        .add("slopes", ParameterType::numbers, {.doc = "Guide lines of these slopes", .optional = true})
        .refuse("/name", "a file is called after it: letters, digits, _ and - only",
                [](const Json& own, const Json&) {
                    const std::string name = own.at("name");
                    return name.empty() || name.find_first_not_of(
                                               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                               "0123456789_-") != name.npos;
                });
}

}  // namespace matpoint
