#include "report/report.hpp"

#include "report/html_page.hpp"
#include "report/markup.hpp"
#include "report/report_rows.hpp"
#include "report/study_plots.hpp"
#include "report/text_file.hpp"

#include <matpoint/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matpoint {
namespace {

HtmlCell memory_cell(const Json& variant) {
    const auto bytes = number_of(variant, "peak_memory_bytes");
    return bytes ? HtmlCell{fmt::format("{:.1f} MiB", *bytes / (1 << 20)), bytes} : HtmlCell{};
}

std::string status_text(const Json& variant) {
    std::string status = text_of(variant, "status");
    std::replace(status.begin(), status.end(), '_', ' ');
    const std::string reason = text_of(variant, "reason");
    return reason.empty() ? status : status + ": " + reason;
}

std::string error_and_cost(const Json& study, const Json& variant) {
    std::string text;
    for (const std::string key : {"error", "cost"}) {
        const auto number = number_of(variant, key);
        if (!number) continue;
        text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", measure_label(study, key), *number);
    }
    return escaped(text);
}

std::string best_sentence(const Json& study) {
    const auto target = number_of(study, "target");
    if (study.contains("best")) {
        const Json& best = study.at("best");
        const std::string scene = escaped(text_of(best, "scene"));
        return fmt::format("<p>{} is <strong>{}</strong>: {}.{}</p>\n",
                           target ? fmt::format("The cheapest variant that meets the target {:.4g}", *target)
                                  : "The best variant",
                           escaped(text_of(best, "name")), error_and_cost(study, best),
                           scene.empty() ? "" : fmt::format(" It runs as <a href=\"{0}\">{0}</a>.", scene));
    }
    if (!target) return "";
    const Json* most_accurate = nullptr;
    for (const Json* variant : variants_of(study)) {
        const auto error = number_of(*variant, "error");
        if (!error || value_of(*variant, "status") != "completed") continue;
        if (!most_accurate || *error < *number_of(*most_accurate, "error")) most_accurate = variant;
    }
    std::string text = fmt::format("<p>No variant meets the target {:.4g}.", *target);
    if (most_accurate) {
        text += fmt::format(" The most accurate is <strong>{}</strong>: {}.",
                            escaped(text_of(*most_accurate, "name")), error_and_cost(study, *most_accurate));
    }
    return text + "</p>\n";
}

std::string count_sentence(const Json& study) {
    const std::vector<const Json*> variants = variants_of(study);
    std::string text = fmt::format("<p>{} variants", variants.size());
    if (study.contains("scene")) text += " of " + escaped(study.at("scene").get<std::string>());
    const char* before = ": ";
    for (const std::string status : {"completed", "broke_down", "crashed", "refused"}) {
        const auto count = std::count_if(variants.begin(), variants.end(), [&](const Json* variant) {
            return value_of(*variant, "status") == status;
        });
        if (count == 0) continue;
        text += fmt::format("{}{} {}", before, count, key_label(status));
        before = ", ";
    }
    return text + ".</p>\n";
}

std::string table(const Json& study) {
    HtmlTable table({"#", "variant", measure_label(study, "error"), "order", measure_label(study, "cost"),
                     "particle steps", "memory", "front", "status"});
    const Json best = study.contains("best") ? value_of(study.at("best"), "number") : Json();
    for (const Json* variant : variants_of(study)) {
        const bool front = value_of(*variant, "front") == true;
        const Json number = value_of(*variant, "number");
        const bool completed = value_of(*variant, "status") == "completed";
        const std::string mark = !completed                          ? "broken"
                                 : !best.is_null() && number == best ? "best"
                                 : front                             ? "front"
                                                                     : "";
        table.add({number_cell(number_of(*variant, "number"), 17),
                   {text_of(*variant, "name")},
                   number_cell(number_of(*variant, "error"), 4),
                   number_cell(number_of(*variant, "order"), 3),
                   number_cell(number_of(*variant, "cost"), 4),
                   number_cell(number_of(*variant, "particle_steps"), 4),
                   memory_cell(*variant),
                   {front ? "●" : ""},
                   {status_text(*variant)}},
                  mark);
    }
    return table.html();
}

std::string machine(const Json& study) {
    if (!study.contains("machine")) return "";
    std::string text;
    for (const auto& [name, value] : study.at("machine").items()) {
        text += fmt::format("{}{}: {}", text.empty() ? "" : " · ", key_label(name), value_label(value));
    }
    return "<footer>" + escaped(text) + "</footer>\n";
}

}  // namespace

void write_report(const Json& study, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    std::string body = count_sentence(study) + best_sentence(study);
    const auto add_picture = [&](const std::string& name, const Plot& plot) {
        const std::string picture = svg(plot);
        write_text(folder / (name + ".svg"), picture);
        body += fmt::format("<figure id=\"{}\">\n{}</figure>\n", escaped(name), picture);
    };
    add_picture("study", trade_plot(study));
    for (const Json& entry : study.value("plots", Json::array())) {
        add_picture(entry.at("name").get<std::string>(), study_plot(study, entry));
    }
    body += "<h2>Variants</h2>\n" + table(study) + machine(study);
    write_text(folder / "study.html", html_page(text_of(study, "title"), body));
}

}  // namespace matpoint
