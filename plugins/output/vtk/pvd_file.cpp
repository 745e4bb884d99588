#include "pvd_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <matpoint/output_file.hpp>
#include <regex>

void PvdFile::open(const std::filesystem::path& file, double resumed_at) {
    file_ = file;
    entries_.clear();
    if (resumed_at < 0) return;
    static const std::regex entry(R"re(\s*<DataSet timestep="([^"]*)" file="([^"]*)"/>)re");
    std::ifstream old(file);
    std::smatch match;
    for (std::string line; std::getline(old, line);) {
        if (!std::regex_match(line, match, entry)) continue;
        const double time = std::stod(match[1]);
        if (time <= resumed_at) entries_.push_back({time, match[2]});
    }
}

void PvdFile::add(double time, const std::string& data_file) {
    entries_.push_back({time, data_file});
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\">\n"
        "  <Collection>\n";
    for (const Entry& e : entries_)
        text += fmt::format("    <DataSet timestep=\"{}\" file=\"{}\"/>\n", matpoint::number_text(e.time),
                            e.data_file);
    text += "  </Collection>\n</VTKFile>\n";
    matpoint::OutputFile file(file_);
    file.write(text);
    file.commit();
}
