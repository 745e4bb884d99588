#pragma once

#include <optional>
#include <string>
#include <vector>

namespace matpoint {

/// A cell of a table: what is shown, and the number that it is sorted by.
struct HtmlCell {
    std::string text;
    std::optional<double> number = {};
};

/// A number with so many digits, or an empty cell.
HtmlCell number_cell(std::optional<double> number, int digits);

/// A table that sorts by a column when its head is clicked, where the browser runs scripts.
class HtmlTable {
  public:
    explicit HtmlTable(const std::vector<std::string>& columns);
    /// `mark` is the row's class for the style sheet, or empty.
    void add(const std::vector<HtmlCell>& cells, const std::string& mark);
    std::string html() const;

  private:
    std::string rows_;
};

/// A page that needs nothing but itself.
std::string html_page(const std::string& title, const std::string& body);

}  // namespace matpoint
