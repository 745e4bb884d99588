#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace matpoint {

/// A CSV file of numbers with a line of column names.
struct Table {
    std::filesystem::path file;
    std::vector<std::string> names;
    std::vector<std::vector<double>> columns;

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
    /// Throws std::runtime_error naming the columns there are.
    const std::vector<double>& column(const std::string& name) const;
    /// The only one beside `time`. Throws std::runtime_error naming them if there are several.
    std::string only_column() const;
};

/// Throws std::runtime_error if the file can't be read or isn't such a table.
Table read_table(const std::filesystem::path& file);

}  // namespace matpoint
