#include "report/svg_plot.hpp"

#include "report/markup.hpp"
#include "report/plot_axis.hpp"
#include "report/slope_guides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace matpoint {
namespace {

// pixels
constexpr double left = 88, right = left + 560, area_height = 380, title_height = 44;
constexpr double strip_height = 18, row_height = 19, radius = 4;
// Beyond these many points marks are small and silent, and marks on a line are thinned.
constexpr std::size_t many_points = 600, many_on_a_line = 60;
constexpr std::size_t longest_name = 38, longest_legend = 60;

/// Every x, every y that the axes have to show.
struct Values {
    std::vector<double> x, y;
    std::size_t points = 0;
    std::size_t rows_of_broken = 0;
    bool some_below_y = false;
};

class Picture {
  public:
    explicit Picture(const Plot& plot)
        : plot_(plot),
          guides_(plot.x.logarithmic && plot.y.logarithmic ? slope_guides(plot.series, plot.slopes)
                                                           : std::vector<SlopeGuide>{}),
          values_(values()),
          row_of_broken_(std::clamp(
              144.0 / static_cast<double>(std::max<std::size_t>(values_.rows_of_broken, 1)), 4.0, 12.0)),
          top_(title_height +
               (values_.rows_of_broken > 0
                    ? row_of_broken_ * static_cast<double>(values_.rows_of_broken) + strip_height - 12
                    : 0)),
          bottom_(top_ + area_height),
          x_(plot.x.logarithmic, values_.x, left, right),
          y_(plot.y.logarithmic, values_.y, bottom_, top_) {}

    std::string text() {
        draw_axes();
        draw_strips();
        draw_target();
        draw_guides();
        draw_front();
        draw_series();
        draw_best();
        draw_legend();
        return svg_document(plot_.title, width_, height_, body_);
    }

  private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(body_), format, std::forward<Args>(args)...);
    }

    Values values() const {
        Values all;
        const PlotAxis any(plot_.y.logarithmic, {}, 0, 1);
        for (const PlotSeries& series : plot_.series) {
            for (const PlotPoint& point : series.points) {
                all.x.push_back(point.x);
                all.y.push_back(point.y);
                all.some_below_y = all.some_below_y || !any.shows(point.y);
            }
            for (const PlotPoint& point : series.broken) all.x.push_back(point.x);
            all.points += series.points.size();
            all.rows_of_broken += series.broken.empty() ? 0 : 1;
        }
        for (const SlopeGuide& guide : guides_) all.y.insert(all.y.end(), {guide.from_y, guide.to_y});
        if (plot_.target && all.points > 0) all.y.push_back(*plot_.target);
        return all;
    }

    double x_pixel(const PlotPoint& point) const { return x_.shows(point.x) ? x_.pixel(point.x) : left; }
    double y_pixel(const PlotPoint& point) const {
        return y_.shows(point.y) ? y_.pixel(point.y) : bottom_ + strip_height / 2;
    }
    bool is_shown(const PlotPoint& point) const { return x_.shows(point.x) && y_.shows(point.y); }
    double lower_edge() const { return bottom_ + (values_.some_below_y ? strip_height : 0); }

    void draw_axes() {
        std::string major, minor, labels;
        for (const auto& [pixel, label] : x_.ticks()) {
            (label.empty() ? minor : major) += fmt::format("M{:.1f} {}V{}", pixel, top_, bottom_);
            if (label.empty()) continue;
            labels += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", pixel,
                                  lower_edge() + 19, label);
        }
        for (const auto& [pixel, label] : y_.ticks()) {
            (label.empty() ? minor : major) += fmt::format("M{} {:.1f}H{}", left, pixel, right);
            if (label.empty()) continue;
            labels += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left - 8,
                                  pixel + 4, label);
        }
        add("<path d=\"{}\" stroke=\"#f0f0f0\"/>\n<path d=\"{}\" stroke=\"#d4d4d4\"/>\n{}", minor, major,
            labels);
        add("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#333\"/>\n", left,
            top_, right - left, area_height);
        add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"13\">{}</text>\n", (left + right) / 2,
            lower_edge() + 42, escaped(shortened(plot_.x.label, 80)));
        const double middle = (top_ + bottom_) / 2;
        add("<text x=\"20\" y=\"{0}\" text-anchor=\"middle\" font-size=\"13\" transform=\"rotate(-90 20 "
            "{0})\">{1}"
            "</text>\n",
            middle, escaped(shortened(plot_.y.label, 54)));
        if (values_.points == 0) {
            add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"#777\">no completed variant to "
                "show</text>\n",
                (left + right) / 2, middle);
        }
    }

    void draw_strip(double from, double to, const char* name) {
        add("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#f3f3f3\" stroke=\"#333\"/>\n", left,
            from, right - left, to - from);
        add("<text x=\"{}\" y=\"{}\" text-anchor=\"end\" font-size=\"11\">{}</text>\n", left - 8,
            (from + to) / 2 + 4, name);
    }

    void draw_strips() {
        if (values_.rows_of_broken > 0) draw_strip(title_height, top_, "broke down");
        if (values_.some_below_y) draw_strip(bottom_, lower_edge(), "≤ 0");
    }

    void draw_target() {
        if (!plot_.target || values_.points == 0 || !y_.shows(*plot_.target)) return;
        add("<path class=\"target\" d=\"M{} {:.1f}H{}\" stroke=\"#a00\" stroke-width=\"1.5\" "
            "stroke-dasharray=\"7 4\"/>\n",
            left, y_.pixel(*plot_.target), right);
    }

    void draw_guides() {
        for (const SlopeGuide& guide : guides_) {
            const double from_x = x_.pixel(guide.from_x), from_y = y_.pixel(guide.from_y);
            const double to_x = x_.pixel(guide.to_x), to_y = y_.pixel(guide.to_y);
            add("<path class=\"slope\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#555\" "
                "stroke-width=\"1.3\" "
                "stroke-dasharray=\"2 3\"/>\n",
                from_x, from_y, to_x, to_y);
            // Below the guide, where it leaves room.
            const bool rises = guide.slope > 0;
            add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"11\" fill=\"#555\">slope "
                "{}</text>\n",
                (from_x + to_x) / 2 + (rises ? 6 : -6), (from_y + to_y) / 2 + 13, rises ? "start" : "end",
                number_markup(guide.slope, 3));
        }
    }

    std::string line_through(const std::vector<PlotPoint>& points) const {
        std::string coordinates;
        for (const PlotPoint& point : points) {
            coordinates += fmt::format("{:.1f},{:.1f} ", x_pixel(point), y_pixel(point));
        }
        if (!coordinates.empty()) coordinates.pop_back();
        return coordinates;
    }

    void draw_front() {
        if (plot_.front.empty()) return;
        add("<polyline class=\"front\" points=\"{}\" fill=\"none\" stroke=\"#000\" stroke-opacity=\".35\" "
            "stroke-width=\"5\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
            line_through(plot_.front));
    }

    /// A mark with its text, or only its path data where there are many.
    void draw_mark(const PlotPoint& point, const std::string& path, const char* attributes,
                   std::string& silent) {
        if (values_.points > many_points || point.text.empty()) {
            silent += path;
        } else {
            add("<path d=\"{}\"{}><title>{}</title></path>\n", path, attributes, escaped(point.text));
        }
    }

    void draw_points(const PlotSeries& series, std::vector<PlotPoint> points, std::size_t number) {
        const auto equal_x = [](const PlotPoint& a, const PlotPoint& b) { return a.x == b.x; };
        std::stable_sort(points.begin(), points.end(),
                         [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
        const bool joined =
            plot_.lines && std::adjacent_find(points.begin(), points.end(), equal_x) == points.end();
        const bool thinned = joined && points.size() > many_on_a_line;
        if (joined) {
            std::vector<PlotPoint> shown;
            std::copy_if(points.begin(), points.end(), std::back_inserter(shown),
                         [this](const PlotPoint& point) { return is_shown(point); });
            add("<polyline points=\"{}\" fill=\"none\" stroke-width=\"{}\" stroke-linejoin=\"round\"/>\n",
                line_through(shown), thinned ? 1.1 : 1.6);
        }
        const bool small = !joined && values_.points > many_points;
        std::string filled, hollow;
        double next = left + 7.0 * static_cast<double>(number % 8);
        for (const PlotPoint& point : points) {
            if (thinned && is_shown(point)) {
                if (x_pixel(point) < next) continue;
                next = x_pixel(point) + 56;
            }
            const std::string path =
                marker_path(series.style, x_pixel(point), y_pixel(point), small ? radius / 2 : radius);
            if (is_shown(point)) {
                draw_mark(point, path, " stroke=\"#fff\" stroke-width=\".6\"", filled);
            } else {
                draw_mark(point, path, " fill=\"#fff\"", hollow);
            }
        }
        if (!filled.empty()) add("<path d=\"{}\" fill-opacity=\".8\" stroke=\"none\"/>\n", filled);
        if (!hollow.empty()) add("<path d=\"{}\" fill=\"#fff\"/>\n", hollow);
    }

    void draw_series() {
        double broken_y = title_height + (strip_height - 12 + row_of_broken_) / 2;
        std::size_t number = 0;
        for (const PlotSeries& series : plot_.series) {
            const std::string colour = colour_of(series.style);
            add("<g class=\"series\" fill=\"{0}\" stroke=\"{0}\" stroke-width=\"1.3\">\n", colour);
            draw_points(series, series.points, number++);
            add("</g>\n");
            if (series.broken.empty()) continue;
            add("<g class=\"broken\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\">\n", colour);
            std::string silent;
            for (const PlotPoint& point : series.broken) {
                draw_mark(point,
                          marker_path(series.style, x_pixel(point), broken_y, 0.38 * row_of_broken_) +
                              cross_path(x_pixel(point), broken_y, 0.18 * row_of_broken_),
                          "", silent);
            }
            if (!silent.empty()) add("<path d=\"{}\"/>\n", silent);
            add("</g>\n");
            broken_y += row_of_broken_;
        }
    }

    void draw_best() {
        if (!plot_.best) return;
        add("<circle class=\"best\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"9\" fill=\"none\" stroke=\"#000\" "
            "stroke-width=\"2\"><title>{}</title></circle>\n",
            x_pixel(*plot_.best), y_pixel(*plot_.best), escaped(plot_.best->text));
    }

    void draw_legend() {
        const double x = right + 22;
        double y = title_height + 8;
        const auto entry = [&](const std::string& sample, const std::string& name) {
            const std::string shown = shortened(name, longest_name);
            add("<g transform=\"translate({} {})\">{}<text x=\"30\" y=\"4\">{}</text>", x, y, sample,
                escaped(shown));
            if (shown != name) add("<title>{}</title>", escaped(name));
            add("</g>\n");
            y += row_height;
            width_ = std::max(width_, x + 30 + 7 * static_cast<double>(length_of(shown)));
        };
        std::size_t left_out = plot_.series.size();
        for (const PlotSeries& series : plot_.series) {
            if (plot_.series.size() - left_out >= longest_legend) break;
            --left_out;
            if (series.name.empty()) continue;
            const std::string line =
                plot_.lines ? fmt::format("<path d=\"M0 0H22\" stroke=\"{}\" stroke-width=\"1.6\"/>",
                                          colour_of(series.style))
                            : "";
            entry(fmt::format("{}<path d=\"{}\" fill=\"{}\"/>", line,
                              marker_path(series.style, 11, 0, radius), colour_of(series.style)),
                  series.name);
        }
        if (left_out > 0) entry("", fmt::format("… and {} more", left_out));
        y += 8;
        if (values_.rows_of_broken > 0)
            entry(fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.7\"/>",
                              cross_path(11, 0, 3)),
                  "broke down");
        if (!plot_.front.empty())
            entry("<path d=\"M0 0H22\" stroke=\"#000\" stroke-opacity=\".35\" stroke-width=\"5\"/>",
                  "Pareto front");
        if (plot_.target && values_.points > 0)
            entry("<path d=\"M0 0H22\" stroke=\"#a00\" stroke-width=\"1.5\" stroke-dasharray=\"7 4\"/>",
                  fmt::format("target {:.4g}", *plot_.target));
        if (plot_.best)
            entry("<circle cx=\"11\" cy=\"0\" r=\"7\" fill=\"none\" stroke=\"#000\" stroke-width=\"2\"/>",
                  "best");
        height_ = std::max(lower_edge() + 58, y + 4);
    }

    const Plot& plot_;
    const std::vector<SlopeGuide> guides_;
    const Values values_;
    const double row_of_broken_;
    const double top_, bottom_;
    const PlotAxis x_, y_;
    std::string body_;
    double width_ = right + 24, height_ = 0;
};

}  // namespace

std::string svg(const Plot& plot) {
    return Picture(plot).text();
}

}  // namespace matpoint
