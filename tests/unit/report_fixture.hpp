#pragma once

#include <matpoint/schema.hpp>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {

struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;  ///< up to the first element within
};

/// All elements in the order of their beginnings. Throws std::runtime_error unless it is well-formed.
inline std::vector<Element> elements_of(const std::string& xml) {
    static const std::regex entity("&(amp|lt|gt|quot|#39);");
    std::vector<Element> all;
    std::vector<std::string> open;
    const auto fail = [&](const std::string& what) {
        throw std::runtime_error(what + " after <" + (all.empty() ? "" : all.back().name) + ">");
    };
    for (std::size_t at = xml.find('<'); at != xml.npos;) {
        const std::size_t end = xml.find('>', at);
        if (end == xml.npos) fail("a tag without end");
        const std::string tag = xml.substr(at + 1, end - at - 1);
        const std::size_t next = xml.find('<', end);
        const std::string text = xml.substr(end + 1, (next == xml.npos ? xml.size() : next) - end - 1);
        const std::string without_entities = std::regex_replace(tag + text, entity, "");
        // A script has its own rules, and this one needs neither sign.
        if (without_entities.find('&') != std::string::npos && !tag.starts_with("script")) fail("a bare &");
        at = next;
        if (tag.starts_with("!DOCTYPE")) continue;
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1)) fail("unexpected <" + tag + ">");
            open.pop_back();
            continue;
        }
        const std::size_t name_end = tag.find_first_of(" /\n");
        Element element{tag.substr(0, name_end), {}, text};
        // Not by a regular expression: libstdc++'s recurse at every letter, and points of a line have
        // thousands.
        std::size_t place = std::min(name_end, tag.size());
        while (place < tag.size() && tag[place] != '/') {
            const std::size_t begin = tag.find_first_not_of(" \n", place), equals = tag.find("=\"", begin);
            const std::size_t close = equals == tag.npos ? tag.npos : tag.find('"', equals + 2);
            if (begin == place || close == tag.npos) fail("no attribute: " + tag.substr(place));
            const std::string value = tag.substr(equals + 2, close - equals - 2);
            if (!element.attributes.emplace(tag.substr(begin, equals - begin), value).second)
                fail("an attribute twice in " + tag);
            place = close + 1;
        }
        if (place == tag.size()) open.push_back(element.name);
        all.push_back(element);
    }
    if (!open.empty()) fail("no end of <" + open.back() + ">");
    return all;
}

inline std::vector<Element> of_class(const std::vector<Element>& elements, const std::string& name) {
    std::vector<Element> found;
    for (const Element& element : elements) {
        const auto its = element.attributes.find("class");
        if (its != element.attributes.end() && its->second == name) found.push_back(element);
    }
    return found;
}

class ReportTest : public testing::Test {
  protected:
    ReportTest() {
        std::string name = (std::filesystem::temp_directory_path() / "matpoint_report_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~ReportTest() override { std::filesystem::remove_all(folder); }

    std::string content(const std::string& file) const {
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
        std::ifstream stream(folder / file);
        std::ostringstream text;
        text << stream.rdbuf();
        return text.str();
    }

    std::filesystem::path folder;
};

}  // namespace matpoint
