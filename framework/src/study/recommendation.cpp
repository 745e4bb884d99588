#include "study/recommendation.hpp"

#include <matpoint/input_file.hpp>

#include "registry/plugin_index.hpp"

#include <matpoint/geometry.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace matpoint {
namespace {

namespace fs = std::filesystem;

/// Files of fronts in the order of their names.
std::vector<Json> read_fronts(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Json> fronts;
    for (const fs::path& file : files) fronts.push_back(Json::parse(read_whole(file)));
    return fronts;
}

bool same_space(const Json& scene, const Json& about) {
    return scene.at("space").at("dimension") == about.at("dimension") &&
           scene.at("space").at("mode") == about.at("mode");
}

/// How much a scene has in common with the scene of a study.
int likeness(const Json& scene, const Json& about) {
    int points = about.at("general").get<bool>() ? 1 : 0;
    const bool solved = scene.contains("exact_solution");
    if (solved && scene.at("exact_solution").at("type") == about.at("exact_solution")) points += 8;
    if ((scene.at("bodies").size() > 1) == (about.at("bodies") > 1)) points += 4;
    for (const auto& [name, material] : scene.at("materials").items())
        if (material.at("type") == about.at("material")) return points + 2;
    return points;
}

std::string settings_text(const Json& settings) {
    std::vector<std::string> parts;
    for (const auto& [pointer, value] : settings.items())
        parts.push_back(fmt::format("{} = {}", pointer, value.dump()));
    return fmt::format("{}", fmt::join(parts, ", "));
}

struct Thinnest {
    std::string body;
    double side;  ///< m, the smallest of its geometry's
};

/// Nothing if a geometry can't be made: the scene's own check tells that.
std::optional<Thinnest> thinnest_body(const Scene& scene, const Registry& registry) {
    const Parameters::Context context{scene.space, scene.folder, &registry, &scene.resolved};
    std::optional<Thinnest> thinnest;
    for (const auto& [name, body] : scene.resolved.at("bodies").items()) {
        try {
            const auto bounds = registry.make<Geometry>("geometry", body.at("geometry"), context)->bounds();
            const double side = (bounds.max - bounds.min).head(scene.space.dimension()).minCoeff();
            if (!thinnest || side < thinnest->side) thinnest = {name, side};
        } catch (...) {
            return {};
        }
    }
    return thinnest;
}

/// So many cells in the scene's own terms.
std::string cells_text(double cells, const Scene& scene, const std::optional<Thinnest>& thinnest) {
    std::string text = fmt::format("about {:.3g} cells across the smallest side of a body", cells);
    if (!thinnest) return text;
    text += fmt::format(": /grid/cell_size = {:.3g} for \"{}\", whose smallest side is {:.4g} m",
                        thinnest->side / cells, thinnest->body, thinnest->side);
    const Json& grid = scene.resolved.at("grid");
    if (!grid.contains("cell_size")) return text;
    const double finest = std::ranges::min(grid.at("cell_size").get<std::vector<double>>());
    return text + fmt::format(" and has {:.3g} cells now", thinnest->side / finest);
}

}  // namespace

fs::path fronts_folder() {
    return plugin_folders().back().parent_path() / "fronts";
}

std::optional<std::string> recommendation(const Scene& scene, const Registry& registry,
                                          const fs::path& folder) {
    if (!scene.resolved.contains("accuracy")) return {};
    const double target = scene.resolved.at("accuracy").at("target").get<double>();
    std::vector<Json> fronts = read_fronts(folder);
    std::erase_if(fronts, [&](const Json& front) { return !same_space(scene.resolved, front.at("about")); });
    const std::string says = scene.document.diagnostic("/accuracy/target", "").file + ": /accuracy/target: ";
    if (fronts.empty()) return says + "no shipped study is of such a space: measure with `matpoint study`";
    const Json& nearest = *std::ranges::max_element(
        fronts, {}, [&](const Json& front) { return likeness(scene.resolved, front.at("about")); });

    const Json& rows = nearest.at("front");  // the cheapest first
    const auto found =
        std::ranges::find_if(rows, [&](const Json& r) { return r.at("error").get<double>() <= target; });
    const Json& row = found == rows.end() ? rows.back() : *found;
    const std::string study = nearest.at("title").get<std::string>();
    const std::string settings =
        fmt::format("{}, and {}", settings_text(row.at("settings")),
                    cells_text(row.at("cells").get<double>(), scene, thinnest_body(scene, registry)));
    if (found == rows.end())
        return fmt::format(
            "{}no variant of the shipped study \"{}\", the nearest there is, reaches {:g}: its best error is "
            "{:.2g}, with {}",
            says, study, target, row.at("error").get<double>(), settings);
    return fmt::format(
        "{}the shipped study \"{}\", the nearest there is, recommends for a relative error of {:g}: {}. It "
        "measured an error of {:.2g} with so many, in a scene of its own. This is a recommendation: the "
        "scene "
        "runs as it is written, and `matpoint study` measures it",
        says, study, target, settings, row.at("error").get<double>());
}

}  // namespace matpoint
