#include "config/expected.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace matpoint {
namespace {

std::string range(const ParameterOptions& o) {
    if (o.at_least && o.at_least == o.at_most) return fmt::format(" equal to {}", *o.at_least);
    std::vector<std::string> bounds;
    if (o.greater_than) bounds.push_back(fmt::format("> {}", *o.greater_than));
    if (o.at_least) bounds.push_back(fmt::format(">= {}", *o.at_least));
    if (o.less_than) bounds.push_back(fmt::format("< {}", *o.less_than));
    if (o.at_most) bounds.push_back(fmt::format("<= {}", *o.at_most));
    return bounds.empty() ? "" : fmt::format(" {}", fmt::join(bounds, " and "));
}

std::string restrictions(const ParameterOptions& o) {
    return range(o) + (o.unit.empty() ? "" : fmt::format(" ({})", o.unit));
}

std::string list_of_numbers(const ParameterOptions& o, int dimension) {
    const std::string numbers = dimension == 0   ? "one number per dimension, each"
                                : dimension == 1 ? "1 number"
                                                 : fmt::format("{} numbers", dimension);
    return fmt::format("a list of {}{}", numbers, restrictions(o));
}

std::string one_profile(const ParameterOptions& o, int dimension) {
    const std::string variables = usable_variables(o, dimension);
    const bool in_time = variables.find('t') != variables.npos;
    return fmt::format("a number{} a formula of {}{}", in_time ? "," : " or",
                       fmt::join(variables.begin(), variables.end(), ", "),
                       in_time ? ", or {\"times\": [...], \"values\": [...]}" : "");
}

}  // namespace

std::string type_name(ParameterType type) {
    switch (type) {
        case ParameterType::number:
            return "number";
        case ParameterType::integer:
            return "integer";
        case ParameterType::boolean:
            return "boolean";
        case ParameterType::text:
            return "text";
        case ParameterType::file:
            return "file";
        case ParameterType::choice:
            return "choice";
        case ParameterType::vector:
            return "vector";
        case ParameterType::per_axis:
            return "per_axis";
        case ParameterType::numbers:
            return "numbers";
        case ParameterType::texts:
            return "texts";
        case ParameterType::profile:
            return "profile";
        case ParameterType::profiles:
            return "profiles";
        case ParameterType::reference:
            return "reference";
        case ParameterType::references:
            return "references";
        case ParameterType::place:
            return "place";
        case ParameterType::component:
            return "component";
        case ParameterType::components:
            return "components";
        case ParameterType::object:
            return "object";
        case ParameterType::objects:
            return "objects";
        case ParameterType::map:
            return "map";
        case ParameterType::any:
            break;
    }
    return "any";
}

/// The words that may stand in the place of what is expected.
std::string or_word(const ParameterOptions& options) {
    std::string words;
    for (const std::string& word : options.choices) words += " or \"" + word + "\"";
    return words;
}

std::string expected_number(const ParameterOptions& options, bool whole) {
    return (whole ? "a whole number" : "a number") + restrictions(options) + or_word(options);
}

std::string expected(const Parameter& p, int dimension) {
    switch (p.type) {
        case ParameterType::number:
            return expected_number(p);
        case ParameterType::integer:
            return expected_number(p, true);
        case ParameterType::boolean:
            return "true or false";
        case ParameterType::text:
            return "text";
        case ParameterType::file:
            return "the path of a file";
        case ParameterType::choice:
            return fmt::format("one of {}", fmt::join(p.choices, ", "));
        case ParameterType::vector:
            return list_of_numbers(p, dimension);
        case ParameterType::per_axis:
            return expected_number(p) + ", or " + list_of_numbers(p, dimension);
        case ParameterType::numbers:
            return "a list of numbers" + (restrictions(p).empty() ? "" : ", each" + restrictions(p));
        case ParameterType::texts:
            return "text or a list of texts";
        case ParameterType::profile:
            return one_profile(p, dimension) + restrictions(p);
        case ParameterType::profiles:
            return fmt::format(
                "a list of {}, each null, {}{}",
                dimension == 0 ? "one item per dimension" : fmt::format("{} item(s)", dimension),
                one_profile(p, dimension), restrictions(p));
        case ParameterType::reference:
            return fmt::format("a name in /{}", p.section);
        case ParameterType::references:
            return fmt::format("a name in /{} or a list of them", p.section);
        case ParameterType::place:
            return fmt::format("a face or a list of faces ({}), a geometry, or a part of a body",
                               fmt::join(face_names(dimension), ", "));
        case ParameterType::component:
            return fmt::format("a {}: an object with \"type\"", p.kind);
        case ParameterType::components:
            return fmt::format("a list of {} objects, each with \"type\"", p.kind);
        case ParameterType::object:
            return "an object" + or_word(p);
        case ParameterType::objects:
            return "a list of objects";
        case ParameterType::map:
            return fmt::format("an object of at least {} named item(s)", p.at_least.value_or(0));
        case ParameterType::any:
            break;
    }
    return p.unit.empty() ? "anything" : "lists of numbers" + restrictions(p);
}

std::string usable_variables(const ParameterOptions& options, int dimension) {
    std::string usable = options.variables;
    if (dimension > 0) std::erase_if(usable, [&](char v) { return v != 't' && v - 'x' >= dimension; });
    return usable;
}

std::string shown(const Json& value) {
    constexpr std::size_t longest = 60;
    // Bytes that are not UTF-8 can come from the command line.
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() <= longest) return text;
    std::size_t end = longest - 3;
    while ((static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end) + "...";
}

std::vector<std::string> face_names(int dimension) {
    std::vector<std::string> names{"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
    if (dimension > 0) names.resize(2 * static_cast<std::size_t>(dimension));
    return names;
}

}  // namespace matpoint
