#include "config/document.hpp"
#include "config/nearest.hpp"

#include <fmt/format.h>

#include <charconv>
#include <vector>

namespace matpoint {
namespace {

std::vector<std::string> keys_of(const Json& json) {
    std::vector<std::string> keys;
    if (json.is_object()) {
        for (const auto& member : json.items()) keys.push_back(member.key());
    } else if (json.is_array()) {
        for (std::size_t i = 0; i < json.size(); ++i) keys.push_back(std::to_string(i));
    }
    return keys;
}

/// The keys of a JSON pointer, unescaped.
std::vector<std::string> split(std::string_view pointer) {
    std::vector<std::string> keys;
    for (const char c : pointer) {
        if (c == '/') {
            keys.emplace_back();
        } else if (keys.back().ends_with('~') && (c == '0' || c == '1')) {
            keys.back().back() = c == '0' ? '~' : '/';
        } else {
            keys.back() += c;
        }
    }
    return keys;
}

/// The value at `key`, or nullptr. An array's end ("-" or its size) counts if `create`.
Json* step_into(Json& parent, std::string& key, bool create) {
    if (parent.is_object()) return create || parent.contains(key) ? &parent[key] : nullptr;
    if (!parent.is_array()) return nullptr;
    if (key == "-") key = std::to_string(parent.size());
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(key.data(), key.data() + key.size(), index);
    if (failure != std::errc() || end != key.data() + key.size()) return nullptr;
    if (create && index == parent.size()) parent.push_back(nullptr);
    return index < parent.size() ? &parent[index] : nullptr;
}

std::vector<std::string> pointers_into(const Json& json, const std::string& pointer) {
    std::vector<std::string> pointers;
    for (const std::string& key : keys_of(json)) pointers.push_back(join_pointer(pointer, key));
    return pointers;
}

}  // namespace

void apply_set(Document& document, std::string_view assignment, Diagnostics& diagnostics) {
    const auto mistake = [&](const std::string& pointer, std::string message) {
        diagnostics.add({.file = fmt::format("--set {}", assignment.substr(0, assignment.find('='))),
                         .pointer = pointer,
                         .message = std::move(message)});
    };
    const std::size_t equals = assignment.find('=');
    if (equals == assignment.npos || !assignment.starts_with('/')) {
        return mistake("", "expected /json/pointer=VALUE");
    }
    std::vector<std::string> keys = split(assignment.substr(0, equals));
    Json* at = &document.json;
    std::string pointer;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        Json* next = step_into(*at, keys[i], i + 1 == keys.size());
        const std::string next_pointer = join_pointer(pointer, keys[i]);
        if (!next) {
            const std::vector<std::string> candidates = pointers_into(*at, pointer);
            if (!at->is_object() || nearest(next_pointer, candidates))
                return mistake(next_pointer,
                               "there is nothing at this pointer" + did_you_mean(next_pointer, candidates));
            // What a scene leaves to its defaults, such as "integrator"; whether there is such a key is told
            // later.
            next = &((*at)[keys[i]] = Json::object());
            document.overrides.insert(next_pointer);
        }
        pointer = next_pointer;
        at = next;
    }
    const std::string_view value = assignment.substr(equals + 1);
    *at = Json::parse(value, nullptr, false);
    if (at->is_discarded()) *at = std::string(value);

    // What stood at and below the pointer is no longer from the file.
    document.forget_positions(pointer);
    document.overrides.insert(pointer);
}

}  // namespace matpoint
