#include "verify/table.hpp"

#include <matpoint/input_file.hpp>

#include "config/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

namespace matpoint {
namespace {

constexpr std::uintmax_t largest_table = std::uintmax_t{1} << 30;  // bytes

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> all;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
        const auto first = cell.find_first_not_of(" \t\r\"");
        const auto last = cell.find_last_not_of(" \t\r\"");
        all.push_back(first == cell.npos ? "" : cell.substr(first, last - first + 1));
    }
    return all;
}

}  // namespace

const std::vector<double>& Table::column(const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        throw std::runtime_error(
            fmt::format("{} has no column \"{}\"{}", file.string(), name, did_you_mean(name, names)));
    }
    return columns[static_cast<std::size_t>(found - names.begin())];
}

std::string Table::only_column() const {
    std::vector<std::string> others = names;
    std::erase(others, "time");
    if (others.size() != 1) {
        throw std::runtime_error(fmt::format("{} has several columns: name one by \"column\" ({})",
                                             file.string(), fmt::join(others, ", ")));
    }
    return others.front();
}

Table read_table(const std::filesystem::path& file) {
    std::istringstream stream(read_whole(file, largest_table));
    Table table{file, {}, {}};
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        const std::vector<std::string> row = cells(line);
        if (table.names.empty()) {
            table.names = row;
            table.columns.resize(row.size());
            continue;
        }
        if (row.size() != table.names.size()) {
            throw std::runtime_error(fmt::format("{}:{}: expected {} columns, got {}", file.string(), number,
                                                 table.names.size(), row.size()));
        }
        for (std::size_t c = 0; c < row.size(); ++c) {
            double value = 0;
            const auto [end, failure] = std::from_chars(row[c].data(), row[c].data() + row[c].size(), value);
            if (failure != std::errc() || end != row[c].data() + row[c].size()) {
                throw std::runtime_error(
                    fmt::format("{}:{}: expected a number, got \"{}\"", file.string(), number, row[c]));
            }
            table.columns[c].push_back(value);
        }
    }
    return table;
}

}  // namespace matpoint
