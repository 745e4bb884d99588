#include "report/html_page.hpp"

#include "report/markup.hpp"

#include <matpoint/output_file.hpp>

#include <fmt/format.h>

namespace matpoint {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", Arial, sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
figure { margin: 1rem 0; } svg { max-width: 100%; height: auto; border-radius: 6px; border: 1px solid #8884; }
.table { max-height: 75vh; overflow: auto; border: 1px solid #8886; border-radius: 6px; }
table { border-collapse: collapse; width: 100%; font-size: 13px; }
th { position: sticky; top: 0; background: Canvas; text-align: left; cursor: pointer; white-space: nowrap; box-shadow: 0 1px #8886; }
th, td { padding: .25rem .6rem; } tr + tr td { border-top: 1px solid #8883; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.front { background: #56b4e922; } tr.best { background: #009e7344; font-weight: 600; } tr.broken { color: #c0392b; }
footer { margin-top: 2rem; font-size: 12px; color: #888; }
)";

constexpr const char* script = R"(
document.querySelectorAll('th').forEach(function (head) {
  head.addEventListener('click', function () {
    var body = head.closest('table').tBodies[0], at = head.cellIndex, up = head.dataset.up !== '1';
    head.dataset.up = up ? '1' : '0';
    var key = function (row) {
      var cell = row.cells[at], text = cell.textContent;
      return 'n' in cell.dataset ? Number(cell.dataset.n) : text;
    };
    var order = function (a, b) {
      var x = key(a), y = key(b);
      if (x === '' || y === '') return (x === '') - (y === '');
      if (typeof x !== typeof y) return typeof x === 'number' ? -1 : 1;
      var sign = typeof x === 'number' ? Math.sign(x - y) : x.localeCompare(y);
      return up ? sign : -sign;
    };
    Array.from(body.rows).sort(order).forEach(function (row) { body.append(row); });
  });
});
)";

}  // namespace

HtmlCell number_cell(std::optional<double> number, int digits) {
    return number ? HtmlCell{number_text(*number, digits), number} : HtmlCell{};
}

HtmlTable::HtmlTable(const std::vector<std::string>& columns) {
    for (const std::string& column : columns) rows_ += fmt::format("<th>{}</th>", escaped(column));
    rows_ = "<thead><tr>" + rows_ + "</tr></thead>\n<tbody>\n";
}

void HtmlTable::add(const std::vector<HtmlCell>& cells, const std::string& mark) {
    rows_ += mark.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", mark);
    for (const HtmlCell& cell : cells) {
        rows_ += cell.number ? fmt::format("<td class=\"number\" data-n=\"{}\">", number_text(*cell.number))
                             : "<td>";
        rows_ += escaped(cell.text) + "</td>";
    }
    rows_ += "</tr>\n";
}

std::string HtmlTable::html() const {
    return "<div class=\"table\"><table>\n" + rows_ + "</tbody></table></div>\n";
}

std::string html_page(const std::string& title, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}<script>{3}</script>\n"
        "</body>\n</html>\n",
        escaped(title), style, body, script);
}

}  // namespace matpoint
