#include "report/limits_report.hpp"

#include "report/html_page.hpp"
#include "report/markup.hpp"
#include "report/plot_axis.hpp"
#include "report/report_rows.hpp"
#include "report/text_file.hpp"

#include <matpoint/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace matpoint {
namespace {

// pixels
constexpr double bars_top = 44, bar_pitch = 22, bar_height = 14, bars_width = 480, longest_bar_name = 48;

struct Search {
    std::string label;  ///< of what is searched
    const char* wanted;
    double from, to;
    double good_end, bad_end;  ///< where most and least variants are stable
};

Search search_of(const Json& limits) {
    const Json search = limits.value("search", Json::object());
    const double from = search.value("from", 0.0), to = search.value("to", 1.0);
    const bool largest = search.value("largest", true);
    return {key_label(search.value("pointer", "value")),
            largest ? "largest" : "smallest",
            from,
            to,
            largest ? from : to,
            largest ? to : from};
}

std::string outcome(const Json& variant, const Search& search) {
    const std::string status = text_of(variant, "status");
    if (status == "stable_everywhere") return fmt::format("stable even at {:g}", search.bad_end);
    if (status == "unstable_everywhere") return fmt::format("unstable even at {:g}", search.good_end);
    const auto limit = number_of(variant, "limit");
    return limit ? number_text(*limit, 6) : status;
}

/// A bar to the limit; open at its end where nothing unstable was met, a cross where nothing stable was.
std::string bar(const Json& variant, const Search& search, const PlotAxis& axis, double y,
                const std::string& colour) {
    const std::string status = text_of(variant, "status");
    const double zero = axis.pixel(0);
    const double middle = y + bar_height / 2;
    const bool endless = status == "stable_everywhere";
    const auto limit = endless ? std::optional(search.bad_end) : number_of(variant, "limit");
    double end = zero;
    std::string shape;
    if (limit) {
        end = axis.pixel(*limit);
        shape = fmt::format(
            "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n",
            std::min(zero, end), y, std::abs(end - zero), bar_height, colour);
        if (endless)
            shape += fmt::format("<path d=\"M{:.1f} {:.1f}v{}l8 -{}z\" fill=\"{}\"/>\n", end + 2, y,
                                 bar_height, bar_height / 2, colour);
    } else if (status == "unstable_everywhere") {
        end = axis.pixel(search.good_end);
        shape = fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"2\"/>\n", cross_path(end, middle, 4),
                            colour);
    }
    return shape + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                               end + (limit && !endless ? 6 : 14), middle + 4,
                               escaped(outcome(variant, search)));
}

std::string bar_plot(const Json& limits, const Search& search) {
    const std::vector<const Json*> variants = variants_of(limits);
    std::vector<double> values{0};
    std::size_t longest = 0;
    for (const Json* variant : variants) {
        if (const auto limit = number_of(*variant, "limit")) values.push_back(*limit);
        if (value_of(*variant, "status") == "stable_everywhere") values.push_back(search.bad_end);
        if (value_of(*variant, "status") == "unstable_everywhere") values.push_back(search.good_end);
        longest = std::max(longest, length_of(shortened(text_of(*variant, "name"), longest_bar_name)));
    }
    const double left = 24 + 7 * static_cast<double>(longest);
    const double bottom = bars_top + bar_pitch * static_cast<double>(variants.size()) + 4;
    const PlotAxis axis(false, values, left, left + bars_width);

    std::string body, grid;
    for (const auto& [pixel, label] : axis.ticks()) {
        grid += fmt::format("M{:.1f} {}V{}", pixel, bars_top, bottom);
        body += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", pixel,
                            bottom + 18, label);
    }
    body += fmt::format("<path d=\"{}\" stroke=\"#d4d4d4\"/>\n", grid);
    std::map<const Json*, PlotStyle> styles;
    for (const VariantGroup& group : grouped(variants, kind_keys(variants))) {
        for (const Json* variant : group.variants) styles[variant] = group.style;
    }
    double y = bars_top + 4;
    for (const Json* variant : variants) {
        const std::string name = text_of(*variant, "name");
        body +=
            fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}<title>{}</title></text>\n", left - 8,
                        y + bar_height / 2 + 4, escaped(shortened(name, longest_bar_name)), escaped(name));
        body += bar(*variant, search, axis, y, colour_of(styles[variant]));
        y += bar_pitch;
    }
    body +=
        fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"13\">{} stable {}</text>\n",
                    left + bars_width / 2, bottom + 42, search.wanted, escaped(search.label));
    return svg_document(text_of(limits, "title"), left + bars_width + 140, bottom + 58, body);
}

std::string table(const Json& limits, const Search& search) {
    HtmlTable table({"#", "variant", fmt::format("{} stable {}", search.wanted, search.label), "status",
                     "unstable at", "why"});
    for (const Json* variant : variants_of(limits)) {
        const std::string status = text_of(*variant, "status");
        table.add({number_cell(number_of(*variant, "number"), 17),
                   {text_of(*variant, "name")},
                   number_cell(number_of(*variant, "limit"), 6),
                   {key_label(status)},
                   number_cell(number_of(*variant, "unstable"), 6),
                   {text_of(*variant, "reason")}},
                  status == "refused" || status == "unstable_everywhere" ? "broken" : "");
    }
    return table.html();
}

std::string criterion(const Json& limits, const Search& search) {
    std::string text = fmt::format("<p>The {} {} from {:g} to {:g}", search.wanted, escaped(search.label),
                                   search.from, search.to);
    if (limits.contains("scene")) text += " of " + escaped(value_label(limits.at("scene")));
    text += " at which the run completes";
    if (limits.contains("stable")) {
        const Json& stable = limits.at("stable");
        text += fmt::format(" with {} below {:.4g}", escaped(text_of(stable, "summary")),
                            stable.value("below", 0.0));
    }
    return text + ".</p>\n";
}

}  // namespace

void write_limits_report(const Json& limits, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const Search search = search_of(limits);
    const std::string picture = bar_plot(limits, search);
    write_text(folder / "limits.svg", picture);
    write_text(
        folder / "limits.html",
        html_page(text_of(limits, "title"), criterion(limits, search) + "<figure>\n" + picture +
                                                "</figure>\n<h2>Variants</h2>\n" + table(limits, search)));
}

}  // namespace matpoint
