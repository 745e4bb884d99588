#include "config/kinds.hpp"
#include "config/validate.hpp"

#include "config/expected.hpp"

#include <matpoint/profile.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matpoint {
namespace {

bool within(const ParameterOptions& o, double x) {
    return std::isfinite(x) && !(o.at_least && x < *o.at_least) && !(o.at_most && x > *o.at_most) &&
           !(o.greater_than && x <= *o.greater_than) && !(o.less_than && x >= *o.less_than);
}

std::vector<std::string> names_in(const Json& scene, const std::string& section) {
    std::vector<std::string> names;
    for (const auto& member : scene.at(section).items()) names.push_back(member.key());
    return names;
}

}  // namespace

Json Validator::mismatch(const Parameter& p, const Json& given, const std::string& at) {
    error(at, fmt::format("expected {}, got {}", expected(p, dimension_), shown(given)));
    return nullptr;
}

template <class Check>
Json Validator::list(const Parameter& p, const Json& given, const std::string& at, int size, Check check) {
    if (!given.is_array() || (size > 0 && given.size() != static_cast<std::size_t>(size)))
        return mismatch(p, given, at);
    Json resolved = Json::array();
    for (std::size_t i = 0; i < given.size(); ++i)
        resolved.push_back(check(given[i], fmt::format("{}/{}", at, i)));
    return resolved;
}

Json Validator::value(const Parameter& p, const Json& given, const std::string& at) {
    const auto as_number = [&](const Json& item, const std::string& pointer) {
        return number(p, item, pointer);
    };
    const bool words = p.type == ParameterType::number || p.type == ParameterType::object;
    if (words && !p.choices.empty() && given.is_string()) {
        if (std::find(p.choices.begin(), p.choices.end(), given) != p.choices.end()) return given;
        if (p.type == ParameterType::object) return mismatch(p, given, at);
    }
    switch (p.type) {
        case ParameterType::number:
            return number(p, given, at);
        case ParameterType::integer:
            return integer(p, given, at);
        case ParameterType::boolean:
            return given.is_boolean() ? given : mismatch(p, given, at);
        case ParameterType::text:
            return given.is_string() ? given : mismatch(p, given, at);
        case ParameterType::file:
            return file(p, given, at);
        case ParameterType::choice:
            return choice(p, given, at);
        case ParameterType::per_axis:
            if (!given.is_array()) {
                return Json(
                    Json::array_t(static_cast<std::size_t>(std::max(dimension_, 1)), number(p, given, at)));
            }
            [[fallthrough]];
        case ParameterType::vector:
            return list(p, given, at, dimension_, as_number);
        case ParameterType::numbers:
            return list(p, given, at, 0, as_number);
        case ParameterType::texts:
            return texts(p, given, at);
        case ParameterType::profile:
            return profile(p, given, at);
        case ParameterType::profiles:
            return list(p, given, at, dimension_, [&](const Json& item, const std::string& pointer) {
                return item.is_null() ? item : profile(p, item, pointer);
            });
        case ParameterType::reference:
            return reference(p, given, at);
        case ParameterType::references:
            if (given.is_string()) return Json::array({reference(p, given, at)});
            return list(p, given, at, 0, [&](const Json& item, const std::string& pointer) {
                return reference(p, item, pointer);
            });
        case ParameterType::place:
            return place(p, given, at);
        case ParameterType::component:
            return component(p.kind, given, at);
        case ParameterType::components:
            return list(p, given, at, 0, [&](const Json& item, const std::string& pointer) {
                return component(p.kind, item, pointer);
            });
        case ParameterType::object:
            return object(*p.nested, given, at);
        case ParameterType::objects:
            return list(p, given, at, 0, [&](const Json& item, const std::string& pointer) {
                return object(*p.nested, item, pointer);
            });
        case ParameterType::map:
            return map(p, given, at);
        case ParameterType::any:
            return p.unit.empty() ? given : numbers_within(p, given, at);
    }
    return given;
}

// A unit says that there is nothing but numbers, in lists as deep as may be.
Json Validator::numbers_within(const Parameter& p, const Json& given, const std::string& at) {
    if (!given.is_array()) return number(p, given, at);
    return list(p, given, at, 0, [&](const Json& item, const std::string& pointer) {
        return numbers_within(p, item, pointer);
    });
}

Json Validator::number(const ParameterOptions& options, const Json& given, const std::string& at) {
    Json resolved = given;
    if (given.is_string()) {
        try {
            resolved = units_.to_si(given.get_ref<const std::string&>(), options.unit);
        } catch (const std::invalid_argument& e) {
            error(at, fmt::format("expected {}: {}", expected_number(options), e.what()));
            return nullptr;
        }
    }
    if (!resolved.is_number() || !within(options, resolved.get<double>())) {
        error(at, fmt::format("expected {}, got {}", expected_number(options), shown(given)));
    }
    return resolved;
}

Json Validator::integer(const Parameter& p, const Json& given, const std::string& at) {
    if (!given.is_number() || !within(p, given.get<double>())) return mismatch(p, given, at);
    if (given.is_number_integer()) return given;
    const double number = given.get<double>();
    // Beyond 2^53 a double doesn't tell whole numbers apart.
    if (number != std::trunc(number) || std::abs(number) > 9007199254740992.0) return mismatch(p, given, at);
    return static_cast<long>(number);
}

Json Validator::choice(const Parameter& p, const Json& given, const std::string& at) {
    if (!given.is_string()) return mismatch(p, given, at);
    const std::string& name = given.get_ref<const std::string&>();
    if (std::find(p.choices.begin(), p.choices.end(), name) == p.choices.end()) {
        error(at, fmt::format("expected {}, got {}{}", expected(p), shown(given),
                              nearest(name, p.choices) ? did_you_mean(name, p.choices) : ""));
    }
    return given;
}

// Absolute, so that a resolved scene runs from any folder.
Json Validator::file(const Parameter& p, const Json& given, const std::string& at) {
    if (!given.is_string() || given.get_ref<const std::string&>().empty()) return mismatch(p, given, at);
    return (folder_ / given.get<std::string>()).lexically_normal().string();
}

Json Validator::texts(const Parameter& p, const Json& given, const std::string& at) {
    if (given.is_string()) return Json::array({given});
    return list(p, given, at, 0, [&](const Json& item, const std::string& pointer) {
        if (!item.is_string()) error(pointer, fmt::format("expected text, got {}", shown(item)));
        return item;
    });
}

Json Validator::profile(const Parameter& p, const Json& given, const std::string& at) {
    if (given.is_number()) return number(p, given, at);
    if (given.is_string()) return formula_or_quantity(p, given, at);
    const bool is_table =
        given.is_object() && given.size() == 2 && given.contains("times") && given.contains("values");
    if (is_table && p.variables.find('t') != p.variables.npos) return table(p, given, at);
    mismatch({{p}, p.name, ParameterType::profile}, given, at);
    return given;
}

Json Validator::formula_or_quantity(const Parameter& p, const Json& given, const std::string& at) {
    const Parameter one{{p}, p.name, ParameterType::profile};
    const std::string usable = usable_variables(p, dimension_);
    std::string not_a_formula;
    try {
        std::string foreign = Profile(given).variables();
        std::erase_if(foreign, [&](char v) { return usable.find(v) != usable.npos; });
        if (!foreign.empty())
            error(at, fmt::format("expected {}, got {}, which depends on {}", expected(one, dimension_),
                                  shown(given), fmt::join(foreign.begin(), foreign.end(), ", ")));
        if (usable.find('t') != usable.npos) formulas_in_time_.push_back(at);
        return given;
    } catch (const std::invalid_argument& e) {
        not_a_formula = e.what();
    }
    try {
        units_.to_si(given.get_ref<const std::string&>(), p.unit);
    } catch (const std::invalid_argument& not_a_quantity) {
        error(at, fmt::format("{} is neither a formula of {} ({}) nor a quantity ({})", shown(given),
                              fmt::join(usable.begin(), usable.end(), ", "), not_a_formula,
                              not_a_quantity.what()));
        return given;
    }
    return number(p, given, at);
}

Json Validator::table(const Parameter& p, const Json& given, const std::string& at) {
    const Parameter times{{.unit = "s"}, "times", ParameterType::numbers};
    const Parameter values{{p}, "values", ParameterType::numbers};
    const Json resolved{{"times", value(times, given["times"], at + "/times")},
                        {"values", value(values, given["values"], at + "/values")}};
    for (const Json& column : resolved) {
        const auto is_number = [](const Json& item) { return item.is_number(); };
        if (!column.is_array() || !std::all_of(column.begin(), column.end(), is_number)) return given;
    }
    try {
        Profile{resolved};
    } catch (const std::invalid_argument& e) {
        error(at, e.what());
    }
    return resolved;
}

Json Validator::reference(const Parameter& p, const Json& given, const std::string& at) {
    if (!given.is_string()) {
        error(at, fmt::format("expected a name in /{}, got {}", p.section, shown(given)));
        return nullptr;
    }
    const Json& scene = document_.json;
    if (!scene.contains(p.section) || !scene.at(p.section).is_object()) return given;
    std::vector<std::string> names = names_in(scene, p.section);
    names.insert(names.end(), p.choices.begin(), p.choices.end());
    const std::string& name = given.get_ref<const std::string&>();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        error(at, fmt::format("no \"{}\" in /{}{}", name, p.section, did_you_mean(name, names)));
    }
    return given;
}

Json Validator::face(const Parameter& p, const Json& given, const std::string& at) {
    if (!given.is_string()) return mismatch(p, given, at);
    const std::vector<std::string> faces = face_names(dimension_);
    const std::string& name = given.get_ref<const std::string&>();
    if (std::find(faces.begin(), faces.end(), name) == faces.end()) {
        error(at, fmt::format("no face \"{}\"; expected one of {}", name, fmt::join(faces, ", ")));
    }
    return given;
}

Json Validator::place(const Parameter& p, const Json& given, const std::string& at) {
    if (given.is_object() && given.contains("body")) return object(part_schema(), given, at);
    if (given.is_object()) return component("geometry", given, at);
    if (given.is_string()) return Json::array({face(p, given, at)});
    if (given.is_array() && given.empty()) return mismatch(p, given, at);
    return list(p, given, at, 0,
                [&](const Json& item, const std::string& pointer) { return face(p, item, pointer); });
}

Json Validator::map(const Parameter& p, const Json& given, const std::string& at) {
    if (!given.is_object() || static_cast<double>(given.size()) < p.at_least.value_or(0))
        return mismatch(p, given, at);
    Json resolved = Json::object();
    for (const auto& member : given.items()) {
        const std::string pointer = join_pointer(at, member.key());
        if (member.key().empty()) error(pointer, "a name can't be empty");
        resolved[member.key()] = p.nested ? object(*p.nested, member.value(), pointer)
                                          : component(p.kind, member.value(), pointer);
    }
    return resolved;
}

}  // namespace matpoint
