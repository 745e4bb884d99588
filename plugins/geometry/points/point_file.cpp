#include "point_file.hpp"

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
constexpr int volume_column = 6;
constexpr std::array<std::string_view, 7> column_names = {"x", "y", "z", "vx", "vy", "vz", "volume"};

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

    PointCloud read(std::istream& in) {
        std::string text;
        while (std::getline(in, text)) {
            ++line_;
            if (line_ == 1 && text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // byte order mark
            const std::string_view line = trimmed(text);
            if (line.empty() || line.front() == '#') continue;
            if (columns_.empty()) {
                read_header(split(line));
                if (!mistakes_.empty()) break;  // without names, the rows mean nothing
            } else {
                read_row(split(line));
            }
        }
        if (columns_.empty())
            mistakes_.push_back(name_ +
                                ": it is empty; expected a line of column names, such as \"x, y, volume\"");
        if (mistakes_.empty() && cloud_.points.empty())
            mistakes_.push_back(name_ + ": it has column names but no points");
        if (mistakes_.empty()) return std::move(cloud_);
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
        for (const std::string_view name : names) {
            const auto found = std::find(column_names.begin(), column_names.end(), name);
            const int column = static_cast<int>(found - column_names.begin());
            if (found == column_names.end() || !belongs(static_cast<std::size_t>(column)))
                mistake("column " + in_quotes(name) + " is not known in " + std::to_string(dimension_) +
                        "D; expected some of " + known_names());
            else if (std::find(columns_.begin(), columns_.end(), column) != columns_.end())
                mistake("column " + in_quotes(name) + " is there twice");
            columns_.push_back(column);
        }
        for (std::size_t c : {0, 1, 2, volume_column})
            if (belongs(c) &&
                std::find(columns_.begin(), columns_.end(), static_cast<int>(c)) == columns_.end())
                mistake("column " + in_quotes(column_names[c]) + " is missing");
    }

    void read_row(const std::vector<std::string_view>& cells) {
        if (cells.size() != columns_.size()) {
            mistake("expected " + std::to_string(columns_.size()) + " values, found " +
                    std::to_string(cells.size()));
            return;
        }
        std::array<double, column_names.size()> values{};
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto column = static_cast<std::size_t>(columns_[i]);
            if (!read_number(cells[i], values[column]))
                mistake("column " + in_quotes(column_names[column]) + ": expected a finite number, found " +
                        in_quotes(cells[i]));
            else if (column == volume_column && values[column] <= 0)
                mistake("column \"volume\": expected a number greater than 0, found " + in_quotes(cells[i]));
        }
        cloud_.points.push_back(
            {{values[0], values[1], values[2]}, values[volume_column], {values[3], values[4], values[5]}});
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
    std::vector<int> columns_;  ///< for each column of the file, its place in column_names
    PointCloud cloud_;
    std::vector<std::string> mistakes_;
};

}  // namespace

PointCloud read_point_file(const std::filesystem::path& file, int dimension) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
        throw std::invalid_argument("cannot read the file " + in_quotes(file.string()));
    return Reader(file, dimension).read(in);
}

}  // namespace matpoint
