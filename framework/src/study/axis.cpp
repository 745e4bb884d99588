#include "study/axis.hpp"

#include <matpoint/output_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace matpoint {
namespace {

/// What rounding may take from the last value of a range, in steps.
constexpr double slack = 1e-9;

double steps_of(const Json& range) {
    const double from = range.at("from"), to = range.at("to");
    if (range.contains("step")) return (to - from) / range.at("step").get<double>();
    return std::log(to / from) / std::log(range.at("factor").get<double>());
}

/// The last `count` keys of a pointer.
std::string end_of(const std::string& pointer, std::size_t count) {
    std::size_t at = pointer.size();
    while (count-- > 0 && at > 0) at = pointer.rfind('/', at - 1);
    return pointer.substr(at + 1);
}

bool all_differ(const std::vector<std::string>& texts) {
    return std::set<std::string>(texts.begin(), texts.end()).size() == texts.size();
}

std::string brief(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return number_text(value.get<double>(), 6);
    if (value.is_object() && value.contains("type") && value.at("type").is_string()) return value.at("type");
    return value.dump();
}

/// An object by its type and the rest of its members.
std::string full(const Json& value) {
    if (!value.is_object() || !value.contains("type") || !value.at("type").is_string()) return value.dump();
    std::vector<std::string> members;
    for (const auto& [key, member] : value.items())
        if (key != "type") members.push_back(key + "=" + brief(member));
    const std::string type = value.at("type");
    return members.empty() ? type : fmt::format("{}({})", type, fmt::join(members, ", "));
}

}  // namespace

Schema range_schema() {
    const auto number_of = [](const Json& own, const char* name) { return own.at(name).get<double>(); };
    return Schema("A range of numbers")
        .number("from", {.doc = "First value"})
        .number("to", {.doc = "Last value, if the steps meet it"})
        .number("step", {.doc = "What is added from value to value", .optional = true})
        .number("factor", {.doc = "What each value is multiplied by", .optional = true, .greater_than = 0})
        .refuse("", "give `step` or `factor`, one of them",
                [](const Json& own, const Json&) { return own.contains("step") == own.contains("factor"); })
        .refuse("/step", "does not lead from `from` to `to`",
                [=](const Json& own, const Json&) {
                    return own.contains("step") &&
                           !((number_of(own, "to") - number_of(own, "from")) * number_of(own, "step") > 0);
                })
        .refuse("/factor", "does not lead from `from` to `to`", [=](const Json& own, const Json&) {
            // Negated, so that what is not a number is refused.
            return own.contains("factor") && !(std::isfinite(steps_of(own)) && steps_of(own) > 0);
        });
}

double range_count(const Json& range) {
    return std::floor(steps_of(range) + slack) + 1;
}

std::vector<Json> range_values(const Json& range) {
    const double from = range.at("from");
    std::vector<Json> values;
    for (long i = 0; static_cast<double>(i) < range_count(range); ++i) {
        const auto n = static_cast<double>(i);
        const double value = range.contains("step") ? from + n * range.at("step").get<double>()
                                                    : from * std::pow(range.at("factor").get<double>(), n);
        values.push_back(std::stod(number_text(value, 12)));
    }
    const auto whole = [](const Json& value) {
        return value.get<double>() == std::trunc(value.get<double>()) && std::abs(value.get<double>()) < 1e15;
    };
    if (std::ranges::all_of(values, whole))
        for (Json& value : values) value = value.get<long>();
    return values;
}

std::vector<std::string> pointer_labels(const std::vector<std::string>& pointers) {
    std::vector<std::string> named;
    for (const std::string& pointer : pointers) {
        const bool by_object = pointer.ends_with("/type") && pointer != "/type";
        named.push_back(by_object ? pointer.substr(0, pointer.size() - 5) : pointer);
    }
    std::vector<std::string> labels;
    for (const std::string& name : named) {
        const auto keys = static_cast<std::size_t>(std::ranges::count(name, '/'));
        std::size_t count = 1;
        const auto shared = [&](const std::string& other) {
            return &other != &name && end_of(other, count) == end_of(name, count);
        };
        while (count < keys && std::ranges::any_of(named, shared)) ++count;
        labels.push_back(end_of(name, count));
    }
    return all_differ(labels) ? labels : pointers;
}

std::vector<std::string> value_labels(const std::vector<Json>& values) {
    const auto by = [&](const std::function<std::string(const Json&)>& text) {
        std::vector<std::string> labels;
        for (const Json& value : values) labels.push_back(text(value));
        return labels;
    };
    for (const auto& text : {brief, full})
        if (const auto labels = by(text); all_differ(labels)) return labels;
    return by([](const Json& value) { return value.dump(); });
}

}  // namespace matpoint
