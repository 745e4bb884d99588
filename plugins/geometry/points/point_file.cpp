#include "point_file.hpp"

#include <matpoint/input_file.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace matpoint {

namespace {

constexpr std::size_t most_mistakes = 20;
constexpr std::size_t first_edge = 6, volume_column = 9;
constexpr std::streamsize longest_line = 65536;
constexpr std::array<std::string_view, 10> column_names = {"x",  "y",  "z",  "vx", "vy",
                                                           "vz", "dx", "dy", "dz", "volume"};

std::string in_quotes(std::string_view text) {
    return "\"" + std::string(text) + "\"";
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r";
    const std::size_t first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos; line.remove_prefix(comma + 1))
        cells.push_back(trimmed(line.substr(0, comma)));
    cells.push_back(trimmed(line));
    return cells;
}

/// False unless the whole text is one finite number.
bool read_number(std::string_view text, double& value) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stop == end && std::isfinite(value);
}

class Reader {
  public:
    Reader(const std::filesystem::path& file, int dimension) : name_(file.string()), dimension_(dimension) {}

    PointTable read(std::istream& in) {
        std::vector<char> buffer(longest_line);
        while (in.getline(buffer.data(), longest_line)) {
            ++line_;
            std::string_view text(buffer.data(), static_cast<std::size_t>(in.gcount()) - (in.eof() ? 0 : 1));
            if (line_ == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
            const std::string_view line = trimmed(text);
            if (line.empty() || line.front() == '#') continue;
            if (table_.columns.empty()) {
                read_header(split(line));
                if (!mistakes_.empty()) break;  // without names, the rows mean nothing
            } else {
                read_row(split(line));
            }
        }
        if (!in.eof() && in.gcount() == longest_line - 1) {
            ++line_;
            mistake("longer than any row of numbers: this is no table");
        } else if (table_.columns.empty())
            mistakes_.push_back(name_ +
                                ": it is empty; expected a line of column names, such as \"x, y, volume\"");
        if (mistakes_.empty() && table_.numbers.empty())
            mistakes_.push_back(name_ + ": it has column names but no points");
        if (mistakes_.empty()) return std::move(table_);
        throw std::invalid_argument(report());
    }

  private:
    void mistake(const std::string& what) {
        mistakes_.push_back(name_ + ":" + std::to_string(line_) + ": " + what);
    }

    bool belongs(std::size_t column) const {
        return column == volume_column || static_cast<int>(column % 3) < dimension_;
    }

    std::string known_names() const {
        std::string names;
        for (std::size_t c = 0; c < column_names.size(); ++c)
            if (belongs(c)) names += (names.empty() ? "" : ", ") + std::string(column_names[c]);
        return names;
    }

    void read_header(const std::vector<std::string_view>& names) {
        std::vector<std::size_t>& columns = table_.columns;
        for (const std::string_view name : names) {
            const auto found = std::find(column_names.begin(), column_names.end(), name);
            const auto column = static_cast<std::size_t>(found - column_names.begin());
            if (found == column_names.end() || !belongs(column))
                mistake("column " + in_quotes(name) + " is not known in " + std::to_string(dimension_) +
                        "D; expected some of " + known_names());
            else if (std::find(columns.begin(), columns.end(), column) != columns.end())
                mistake("column " + in_quotes(name) + " is there twice");
            columns.push_back(column);
        }
        for (const std::size_t c : {std::size_t{0}, std::size_t{1}, std::size_t{2}, volume_column})
            if (belongs(c) && std::find(columns.begin(), columns.end(), c) == columns.end())
                mistake("column " + in_quotes(column_names[c]) + " is missing");
        const auto is_edge = [](std::size_t c) { return c >= first_edge && c < volume_column; };
        const auto edges = std::ranges::count_if(columns, is_edge);
        if (edges > 0 && edges < dimension_) mistake("a domain has edges along all axes, or none are given");
    }

    void read_row(const std::vector<std::string_view>& cells) {
        if (cells.size() != table_.columns.size()) {
            mistake("expected " + std::to_string(table_.columns.size()) + " values, found " +
                    std::to_string(cells.size()));
            return;
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::size_t column = table_.columns[i];
            double value = 0;
            if (!read_number(cells[i], value))
                mistake("column " + in_quotes(column_names[column]) + ": expected a finite number, found " +
                        in_quotes(cells[i]));
            else if (column >= first_edge && value <= 0)
                mistake("column " + in_quotes(column_names[column]) +
                        ": expected a number greater than 0, found " + in_quotes(cells[i]));
            table_.numbers.push_back(value);
        }
    }

    std::string report() const {
        std::string text;
        for (std::size_t i = 0; i < std::min(mistakes_.size(), most_mistakes); ++i)
            text += (i == 0 ? "" : "\n") + mistakes_[i];
        if (mistakes_.size() > most_mistakes)
            text += "\nand " + std::to_string(mistakes_.size() - most_mistakes) + " more mistakes";
        return text;
    }

    std::string name_;
    int dimension_;
    int line_ = 0;
    PointTable table_;  ///< its columns are places in column_names
    std::vector<std::string> mistakes_;
};

}  // namespace

PointCloud::Point PointTable::point(Index row) const {
    std::array<double, column_names.size()> values{};
    for (std::size_t i = 0; i < columns.size(); ++i)
        values[columns[i]] = numbers[static_cast<std::size_t>(row) * columns.size() + i];
    PointCloud::Point point{
        {values[0], values[1], values[2]}, values[volume_column], {values[3], values[4], values[5]}};
    if (values[first_edge] > 0) point.half_size = Eigen::Vector3d::Map(values.data() + first_edge) / 2;
    return point;
}

PointTable read_point_file(const std::filesystem::path& file, int dimension) {
    if (const std::string why = why_unreadable(file); !why.empty())
        throw std::invalid_argument(file.string() + ": " + why);
    std::ifstream in(file, std::ios::binary);
    return Reader(file, dimension).read(in);
}

}  // namespace matpoint
