#include "report/report_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace matpoint {
namespace {

/// More kinds than this can't be told apart in a picture.
constexpr std::size_t most_groups = 28;

std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// The values of all keys as one text.
std::string values_of(const Json& variant, const std::vector<std::string>& keys) {
    std::string all;
    for (const std::string& key : keys) all += value_of(variant, key).dump() + "\n";
    return all;
}

std::size_t count_groups(const std::vector<const Json*>& variants, const std::vector<std::string>& keys) {
    std::map<std::string, bool> groups;
    for (const Json* variant : variants) groups[values_of(*variant, keys)] = true;
    return groups.size();
}

/// The place of a text among those that were asked for before.
std::size_t place_of(std::map<std::string, std::size_t>& places, const std::string& text) {
    return places.emplace(text, places.size()).first->second;
}

std::string group_name(const Json& variant, const std::vector<std::string>& keys) {
    std::string name;
    for (const std::string& key : keys) {
        const Json value = value_of(variant, key);
        const std::string label = value_label(value);
        if (label.empty()) continue;
        if (!name.empty()) name += ", ";
        name += value.is_number() || value.is_boolean() ? key_label(key) + " " + label : label;
    }
    return name;
}

}  // namespace

Json value_of(const Json& variant, const std::string& key) {
    if (!key.starts_with('/')) return variant.contains(key) ? variant.at(key) : Json();
    if (!variant.contains("settings")) return {};
    const Json& settings = variant.at("settings");
    for (std::size_t end = key.size(); end != 0 && end != key.npos; end = key.rfind('/', end - 1)) {
        const auto found = settings.find(key.substr(0, end));
        if (found == settings.end()) continue;
        const Json::json_pointer rest(key.substr(end));
        return found->contains(rest) ? found->at(rest) : Json();
    }
    return {};
}

std::optional<double> number_of(const Json& variant, const std::string& key) {
    const Json value = value_of(variant, key);
    if (!value.is_number() || !std::isfinite(value.get<double>())) return std::nullopt;
    return value.get<double>();
}

std::string text_of(const Json& variant, const std::string& key) {
    const Json value = value_of(variant, key);
    return value.is_string() ? value.get<std::string>() : "";
}

std::string key_label(const std::string& key) {
    std::string path = key;
    if (path.ends_with("/type")) path.erase(path.size() - 5);
    return spaced(path.substr(path.rfind('/') + 1));
}

std::string value_label(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
    if (!value.is_object() || !value.contains("type")) return value.dump();
    std::string others;
    for (const auto& [name, entry] : value.items()) {
        if (name == "type") continue;
        if (!others.empty()) others += ", ";
        others += spaced(name) + " " + value_label(entry);
    }
    const std::string type = value_label(value.at("type"));
    return others.empty() ? type : fmt::format("{} ({})", type, others);
}

std::vector<VariantGroup> grouped(const std::vector<const Json*>& variants,
                                  const std::vector<std::string>& keys) {
    const std::vector<std::string> first(keys.begin(),
                                         keys.begin() + std::min<std::ptrdiff_t>(1, std::ssize(keys)));
    const std::vector<std::string> others(keys.begin() + std::ssize(first), keys.end());
    std::map<std::string, std::size_t> places, colours, markers;
    std::vector<VariantGroup> groups;
    for (const Json* variant : variants) {
        const std::size_t place = place_of(places, values_of(*variant, keys));
        if (place == groups.size()) {
            const std::size_t colour = place_of(colours, values_of(*variant, first));
            const std::size_t marker =
                place_of(markers, values_of(*variant, others.empty() ? first : others));
            groups.push_back({group_name(*variant, keys), {colour, marker}, {}});
        }
        groups[place].variants.push_back(variant);
    }
    return groups;
}

std::vector<std::string> kind_keys(const std::vector<const Json*>& variants) {
    std::vector<std::string> candidates{"variant", "/shape_function"};
    for (const Json* variant : variants) {
        if (!variant->contains("settings")) continue;
        for (const auto& [key, value] : variant->at("settings").items()) {
            if (value.is_number() || std::count(candidates.begin(), candidates.end(), key) > 0) continue;
            // The shape function may be set by its type alone.
            const bool shape = key.starts_with("/shape_function");
            candidates.insert(shape ? candidates.begin() + 2 : candidates.end(), key);
        }
    }
    std::vector<std::string> keys;
    std::size_t count = 1;
    for (const std::string& candidate : candidates) {
        std::vector<std::string> more = keys;
        more.push_back(candidate);
        const std::size_t groups = count_groups(variants, more);
        if (groups <= count || groups > most_groups) continue;
        keys = std::move(more);
        count = groups;
    }
    return keys;
}

std::vector<const Json*> variants_of(const Json& study) {
    std::vector<const Json*> variants;
    if (!study.contains("variants")) return variants;
    for (const Json& variant : study.at("variants")) variants.push_back(&variant);
    return variants;
}

}  // namespace matpoint
