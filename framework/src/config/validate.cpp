#include "config/validate.hpp"

#include "config/expected.hpp"
#include "config/kinds.hpp"

#include <matpoint/component.hpp>
#include <matpoint/profile.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>

namespace matpoint {
namespace {

using Places = std::vector<std::array<double, 3>>;

/// A few places spread over the grid, if it says its corners.
Places places_in(const Json& grid, int dimension) {
    constexpr int per_axis = 4;
    Places places{{}};
    if (!grid.contains("min") || !grid.contains("max")) return places;
    for (int a = 0; a < dimension; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        const double min = grid["min"][axis].get<double>(), max = grid["max"][axis].get<double>();
        for (std::size_t p = places.size(); p-- > 0;)
            for (int k = 0; k < per_axis; ++k) {
                std::array<double, 3> place = places[p];
                place[axis] = min + (k + 0.5) / per_axis * (max - min);
                if (k == 0)
                    places[p] = place;
                else
                    places.push_back(place);
            }
    }
    return places;
}

/// Why a formula has no finite value at some time from 0 to `end`, if that is so. One of x has some at any
/// time: where it is evaluated, only the run knows, and places that never have a value prove nothing.
std::optional<std::string> without_value(const Profile& formula, const Places& places, double end) {
    constexpr int intervals = 100;
    const bool in_space = formula.variables().find_first_of("xyz") != std::string::npos;
    bool has_value = !in_space;
    std::optional<std::string> first;
    for (int k = 0; k <= intervals; ++k) {
        std::string reason;
        const bool found =
            std::any_of(places.begin(), in_space ? places.end() : places.begin() + 1, [&](const auto& place) {
                try {
                    formula(place, end * k / intervals);
                    return true;
                } catch (const FormulaError& error) {
                    reason = error.what();
                    return false;
                }
            });
        has_value = has_value || found;
        if (!found && !first) first = reason;
    }
    return has_value ? first : std::nullopt;
}

}  // namespace

Validator::Validator(const Document& document, Catalogue& catalogue, int dimension, Diagnostics& diagnostics)
    : document_(document),
      catalogue_(catalogue),
      dimension_(dimension),
      diagnostics_(diagnostics),
      folder_(std::filesystem::absolute(document.path).parent_path()) {}

void Validator::error(const std::string& at, std::string message) {
    diagnostics_.add(document_.diagnostic(at, std::move(message)));
}

Json Validator::object(const Schema& schema, const Json& own, const std::string& at) {
    if (!own.is_object()) {
        error(at, fmt::format("expected an object, got {}", shown(own)));
        return nullptr;
    }
    pending_.push_back({at, &schema.rules()});
    std::vector<const Parameter*> parameters;
    for (const Parameter& p : schema.parameters()) parameters.push_back(&p);
    return members(parameters, own, at, "");
}

Json Validator::component(const std::string& kind_name, const Json& own, const std::string& at) {
    if (!own.is_object()) {
        error(at, fmt::format("expected a {}: an object with \"type\", got {}", kind_name, shown(own)));
        return nullptr;
    }
    const auto type = own.find("type");
    if (type == own.end()) {
        for (const auto& [key, value] : own.items()) {
            if (!nearest(key, {"type"})) continue;
            error(join_pointer(at, key), "unknown key; did you mean \"type\"?");
            return nullptr;
        }
        error(at, "missing key \"type\"" + did_you_mean("", catalogue_.types(kind_name)));
        return nullptr;
    }
    const Schema* schema = type->is_string() ? catalogue_.find(kind_name, type->get<std::string>()) : nullptr;
    if (!schema) {
        const std::string name = type->is_string() ? type->get<std::string>() : "";
        const std::vector<std::string> types = catalogue_.types(kind_name);
        error(at + "/type",
              fmt::format("unknown {} {}{}", kind_name, shown(*type),
                          types.empty() ? "; no plugin offers one" : did_you_mean(name, types)));
        return nullptr;
    }
    const std::vector<int>& dimensions = schema->dimensions();
    if (dimension_ != 0 && std::find(dimensions.begin(), dimensions.end(), dimension_) == dimensions.end()) {
        error(at + "/type", fmt::format("{} works in {} dimension(s), and this scene has {}", shown(*type),
                                        fmt::join(dimensions, " or "), dimension_));
    }
    const Kind& kind = *find_kind(kind_name);
    pending_.push_back({at, &kind.common.rules()});
    pending_.push_back({at, &schema->rules(), kind_name});
    return members(parameters_of(kind, *schema), own, at, kind_name);
}

// `kind` is "" for an object that is not a component.
Json Validator::members(const std::vector<const Parameter*>& parameters, const Json& own,
                        const std::string& at, const std::string& kind) {
    Json resolved = Json::object();
    if (!kind.empty()) resolved["type"] = own.at("type");
    for (const Parameter* p : parameters) {
        const std::string pointer = join_pointer(at, p->name);
        const auto given = own.find(p->name);
        const bool may_be_null = p->optional || (p->default_value && p->default_value->is_null());
        if (given != own.end() && !(given->is_null() && may_be_null)) {
            resolved[p->name] = value(*p, *given, pointer);
        } else if (p->default_value && !p->default_value->is_null()) {
            resolved[p->name] = value(*p, default_value(*p), pointer);
        } else if (!may_be_null) {
            error(at, fmt::format("missing key \"{}\": expected {}", p->name, expected(*p, dimension_)));
        }
        if (p->start_only && resolved.contains(p->name)) start_only_.push_back(pointer);
    }
    for (const auto& member : own.items()) {
        const bool known = (member.key() == "type" && !kind.empty()) ||
                           std::any_of(parameters.begin(), parameters.end(),
                                       [&](const Parameter* p) { return p->name == member.key(); });
        if (!known) unknown_key(member.key(), parameters, own, at, kind);
    }
    return resolved;
}

void Validator::unknown_key(const std::string& key, const std::vector<const Parameter*>& parameters,
                            const Json& own, const std::string& at, const std::string& kind) {
    std::vector<std::string> owners;
    for (const std::string& type : kind.empty() ? std::vector<std::string>() : catalogue_.types(kind)) {
        try {
            const Schema* schema = catalogue_.find(kind, type);
            if (schema && schema->find(key)) owners.push_back(fmt::format("\"{}\"", type));
        } catch (const std::exception&) {
            // Another type's broken plugin must not hide this mistake.
        }
    }
    if (!owners.empty()) {
        return error(join_pointer(at, key),
                     fmt::format("unknown key; it is a parameter of {}", fmt::join(owners, ", ")));
    }
    std::vector<std::string> names;
    for (const Parameter* p : parameters) {
        if (!own.contains(p->name)) names.push_back(p->name);
    }
    error(join_pointer(at, key), "unknown key" + did_you_mean(key, names));
}

// Schemas know no dimension: a default may be one value for all axes, or have three.
Json Validator::default_value(const Parameter& p) const {
    Json value = *p.default_value;
    if (p.type != ParameterType::vector && p.type != ParameterType::profiles &&
        p.type != ParameterType::per_axis) {
        return value;
    }
    const auto size = static_cast<std::size_t>(dimension_ == 0 ? 3 : dimension_);
    if (!value.is_array()) return Json(Json::array_t(size, value));
    while (value.size() > size) value.erase(value.size() - 1);
    return value;
}

void Validator::check_rules(const Json& scene) {
    for (const PendingRules& pending : pending_) {
        const Json& own = scene.at(Json::json_pointer(pending.pointer));
        for (const Rule& rule : *pending.rules) {
            try {
                if (rule.applies(own, scene))
                    diagnostics_.add(
                        document_.diagnostic(pending.pointer + rule.pointer, rule.reason, rule.refuses));
            } catch (...) {
                if (pending.kind.empty()) throw;
                error(pending.pointer,
                      fmt::format("{} failed in the rule \"{}\" of its schema: {}",
                                  catalogue_.origin(pending.kind, own.at("type").get<std::string>()),
                                  rule.reason, text_of_exception()));
            }
        }
    }
}

void Validator::check_formulas(const Json& scene) {
    const double end = scene.at("time").at("end").get<double>();
    const auto positions = places_in(scene.at("grid"), dimension_);
    for (const std::string& pointer : formulas_in_time_) {
        const Profile formula(scene.at(Json::json_pointer(pointer)));
        if (const auto reason = without_value(formula, positions, end)) error(pointer, *reason);
    }
}

}  // namespace matpoint
