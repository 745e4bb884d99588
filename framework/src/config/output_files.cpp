#include "config/output_files.hpp"

#include <algorithm>

namespace matpoint {
namespace {

constexpr std::string_view number_mark = "<number>", body_mark = "<body>";
constexpr std::size_t least_digits = 6;

/// A part of a pattern with parameters' texts, and a body's name, put in.
std::string filled(std::string part, const Json& own, const std::string& body_name) {
    for (std::size_t begin = 0; (begin = part.find('<', begin)) != part.npos;) {
        const std::size_t end = part.find('>', begin);
        const std::string key = part.substr(begin + 1, end - begin - 1);
        const std::string text = key == "body" ? body_name : own.at(key).get<std::string>();
        part.replace(begin, end - begin + 1, text);
        begin += text.size();
    }
    return part;
}

}  // namespace

bool OutputFileNames::holds(std::string_view name) const {
    if (!numbered) return name == before + after;
    if (!name.starts_with(before) || !name.ends_with(after)) return false;
    if (name.size() < before.size() + least_digits + after.size()) return false;
    const std::string_view digits = name.substr(before.size(), name.size() - before.size() - after.size());
    return digits.find_first_not_of("0123456789") == digits.npos;
}

bool OutputFileNames::meets(const OutputFileNames& other) const {
    if (!numbered) return other.holds(example());
    if (!other.numbered) return holds(other.example());
    return before == other.before && after == other.after;
}

std::vector<OutputFileNames> output_files(const Json& own, const Json& scene, const Schema& schema) {
    std::vector<std::string> bodies;
    if (own.contains("body")) {
        bodies.push_back(own.at("body").get<std::string>());
    } else {
        for (const auto& member : scene.at("bodies").items()) bodies.push_back(member.key());
    }
    std::vector<OutputFileNames> all;
    for (const std::string& file : schema.files()) {
        const std::size_t split = file.find(number_mark);
        const bool numbered = split != file.npos;
        const std::string before = file.substr(0, split);
        const std::string after = numbered ? file.substr(split + number_mark.size()) : "";
        const bool by_body = file.find(body_mark) != file.npos;
        for (std::size_t b = 0; b < (by_body ? bodies.size() : 1); ++b)
            all.push_back({filled(before, own, bodies[b]), filled(after, own, bodies[b]), numbered});
    }
    return all;
}

}  // namespace matpoint
