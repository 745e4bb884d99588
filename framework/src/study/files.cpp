#include "study/files.hpp"

#include <matpoint/output_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <thread>

namespace matpoint {
namespace {

/// Quoted where it must be [RFC 4180].
std::string field(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_number_float()) return number_text(value.get<double>());
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    for (std::size_t at = text.find('"'); at != text.npos; at = text.find('"', at + 2))
        text.insert(at, 1, '"');
    return '"' + text + '"';
}

}  // namespace

std::string csv(const Json& report) {
    const Json& rows = report.at("variants");
    std::vector<std::string> entries;
    for (const auto& [key, value] : rows.front().items())
        if (!value.is_structured()) entries.push_back(key);
    std::vector<std::string> cells(entries.begin(), entries.end());
    for (const Json& axis : report.at("varied")) cells.push_back(field(axis.at("pointer")));
    std::string text = fmt::format("{}\n", fmt::join(cells, ","));
    for (const Json& row : rows) {
        cells.clear();
        for (const std::string& key : entries) cells.push_back(field(row.at(key)));
        for (const Json& axis : report.at("varied"))
            cells.push_back(field(row.at("settings").at(axis.at("pointer").get<std::string>())));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

Json varied(const StudyFile& study) {
    Json axes = Json::array();
    for (const Axis& axis : study.axes) axes.push_back({{"pointer", axis.pointer}, {"label", axis.label}});
    return axes;
}

Json machine() {
    return {{"cores", std::thread::hardware_concurrency()}, {"version", MATPOINT_VERSION}};
}

}  // namespace matpoint
