#include "pvd_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <matpoint/output_file.hpp>
#include <regex>

void PvdFile::open(const std::filesystem::path& file, double resumed_at) {
    file_ = file;
    entries_.clear();
    if (resumed_at < 0) return;
    static const std::regex entry(R"re(\s*<DataSet timestep="([^"]*)" part="(\d+)" file="([^"]*)"/>)re");
    std::ifstream old(file);
    std::smatch match;
    for (std::string line; std::getline(old, line);) {
        if (!std::regex_match(line, match, entry)) continue;
        const double time = std::stod(match[1]);
        if (time > resumed_at) continue;
        if (match[2] == "0") entries_.push_back({time, {}});
        entries_.back().data_files.push_back(match[3]);
    }
}

void PvdFile::add(double time, const std::vector<std::string>& data_files) {
    entries_.push_back({time, data_files});
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\">\n"
        "  <Collection>\n";
    for (const Entry& e : entries_)
        for (std::size_t part = 0; part < e.data_files.size(); ++part)
            text += fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n",
                                matpoint::number_text(e.time), part, e.data_files[part]);
    text += "  </Collection>\n</VTKFile>\n";
    matpoint::OutputFile file(file_);
    file.write(text);
    file.commit();
}
