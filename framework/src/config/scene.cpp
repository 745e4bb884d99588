#include "config/scene.hpp"

#include "config/expected.hpp"
#include "config/output_files.hpp"
#include "config/utf8.hpp"
#include "config/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace matpoint {
namespace {

/// Beyond this, the cell is what should be smaller.
constexpr int most_particles_per_axis = 100;

std::filesystem::path folder_of(const Document& document) {
    return std::filesystem::absolute(document.path).parent_path();
}

/// 0 if the scene doesn't say it well; the schema complains then.
int dimension_of(const Json& scene) {
    if (!scene.contains("space") || !scene["space"].is_object() || !scene["space"].contains("dimension"))
        return 0;
    const Json& given = scene["space"]["dimension"];
    for (const int dimension : {1, 2, 3}) {
        if (given == dimension) return dimension;
    }
    return 0;
}

/// Whether a default is to be filled in: `null` takes an optional key back.
bool is_absent(const Json& object, const char* key) {
    return !object.contains(key) || object[key].is_null();
}

/// Modes of a dimension, the default first.
std::vector<std::string> modes(int dimension) {
    if (dimension == 1) return {"bar"};
    if (dimension == 2) return {"plane_strain", "plane_stress", "axisymmetric"};
    return {"solid"};
}

/// A number of particles in a whole cell, as one per axis.
void spread_particles(Json& given, int dimension, const std::string& at, Validator& validator) {
    const double total = given.get<double>();
    const auto power = [&](double root) { return std::pow(root, dimension); };
    const double root = std::max(1.0, std::round(std::pow(total, 1.0 / dimension)));
    if (power(root) == total) {
        given =
            Json(Json::array_t(static_cast<std::size_t>(dimension), static_cast<long>(std::min(root, 1e9))));
        return;
    }
    const double lower = power(root) < total ? root : std::max(1.0, root - 1);
    validator.error(
        at, fmt::format("a single number is the total per cell, in {0} dimensions a whole number to the "
                        "power {0}, such as {1} or {2}; got {3} (a list gives one number per axis)",
                        dimension, power(lower), power(lower + 1), shown(given)));
    given = 1;
}

/// Contacts are called by their bodies, or their type, if they have no name.
void name_contacts(Json& contacts) {
    for (Json& contact : contacts) {
        if (!contact.is_object() || !is_absent(contact, "name") || !contact.contains("type")) continue;
        const Json& bodies = contact.contains("between") ? contact["between"] : contact["type"];
        std::string name;
        for (const Json& body : bodies.is_array() ? bodies : Json::array({bodies}))
            if (body.is_string()) name += (name.empty() ? "" : "-") + body.get<std::string>();
        contact["name"] = name;
    }
}

/// Fills in what depends on other keys of the scene, wherever those are well-formed.
void fill_in_dependents(Json& scene, int dimension, Validator& validator) {
    scene.erase("resolved_with");
    if (dimension == 0) return;
    if (is_absent(scene["space"], "mode")) scene["space"]["mode"] = modes(dimension).front();
    if (scene.contains("time") && scene["time"].is_object() && is_absent(scene["time"], "step") &&
        is_absent(scene["time"], "cfl")) {
        scene["time"]["cfl"] = 0.4;
    }
    if (scene.contains("contacts") && scene["contacts"].is_array()) name_contacts(scene["contacts"]);
    if (!scene.contains("bodies") || !scene["bodies"].is_object()) return;
    for (auto& [name, body] : scene["bodies"].items()) {
        if (!body.is_object() || !body.contains("particles_per_cell")) continue;
        Json& given = body["particles_per_cell"];
        const std::string at = join_pointer("/bodies", name) + "/particles_per_cell";
        if (given.is_number()) spread_particles(given, dimension, at, validator);
    }
}

void check_bodies(Json& resolved, Validator& validator) {
    for (auto& [name, body] : resolved.items()) {
        if (!body.is_object()) continue;
        const std::string at = join_pointer("/bodies", name);
        const auto unfit = [](unsigned char c) { return c < 0x20 || c == '/' || c == '\\'; };
        if (std::any_of(name.begin(), name.end(), unfit))
            validator.error(at, "files are called after a body: its name can't hold slashes or line breaks");
        Json& particles = body["particles_per_cell"];
        for (std::size_t i = 0; i < particles.size(); ++i) {
            if (!particles[i].is_number()) continue;
            const double number = particles[i].get<double>();
            if (number != std::trunc(number)) {
                validator.error(fmt::format("{}/particles_per_cell/{}", at, i),
                                fmt::format("expected a whole number >= 1, got {}", number));
            }
            if (number > most_particles_per_axis) {
                validator.error(
                    fmt::format("{}/particles_per_cell/{}", at, i),
                    fmt::format("expected at most {} per axis, got {}", most_particles_per_axis, number));
            }
            particles[i] = std::lround(std::min(number, double{most_particles_per_axis}));
        }
        for (std::size_t i = 0; i < body["velocity"].size(); ++i) {
            if (body["velocity"][i].is_null()) {
                validator.error(fmt::format("{}/velocity/{}", at, i),
                                "an initial velocity can't be left free");
            }
        }
    }
}

void check_contacts(const Json& resolved, Validator& validator) {
    for (std::size_t k = 0; k < resolved.size(); ++k)
        for (std::size_t other = 0; other < k; ++other)
            if (resolved[k].is_object() && resolved[other].is_object() && resolved[k].contains("name") &&
                resolved[k]["name"] == resolved[other].value("name", Json()))
                validator.error(fmt::format("/contacts/{}/name", k),
                                fmt::format("/contacts/{} is called {} too: give one of them another `name`",
                                            other, shown(resolved[k]["name"])));
}

/// Mistakes that no single parameter shows.
void check_sections(Json& resolved, int dimension, Validator& validator) {
    const Json& space = resolved["space"];
    if (dimension != 0 && space.is_object() && space.value("mode", Json()).is_string()) {
        const std::vector<std::string> allowed = modes(dimension);
        const std::string mode = space["mode"];
        if (std::find(allowed.begin(), allowed.end(), mode) == allowed.end()) {
            validator.error("/space/mode", fmt::format("in {} dimension(s) expected {}, got \"{}\"",
                                                       dimension, fmt::join(allowed, " or "), mode));
        }
        if (mode == "plane_stress" && resolved.contains("exact_solution") &&
            resolved["exact_solution"].is_object())
            validator.error("/exact_solution", "there is none for plane stress");
    }
    if (resolved["bodies"].is_object()) check_bodies(resolved["bodies"], validator);
    if (resolved["contacts"].is_array()) check_contacts(resolved["contacts"], validator);
}

/// Two outputs that write one file would each lose what the other writes.
void check_output_files(const Json& resolved, Catalogue& catalogue, Validator& validator) {
    struct Claim {
        OutputFileNames files;
        std::string owner;
    };
    std::vector<Claim> claims;
    for (const char* file : {"resolved.json", "summary.json"}) claims.push_back({{file}, "every run"});
    const Json& outputs = resolved.at("outputs");
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        const Schema& schema = *catalogue.find("output", outputs[k].at("type").get<std::string>());
        const std::string at = fmt::format("/outputs/{}", k);
        std::vector<Claim> own;
        for (OutputFileNames& files : output_files(outputs[k], resolved, schema)) {
            const auto other = std::find_if(claims.begin(), claims.end(),
                                            [&](const Claim& claim) { return claim.files.meets(files); });
            if (other != claims.end()) {
                validator.error(at + "/name",
                                fmt::format("it would write {}, as {} does: choose another name",
                                            files.example(), other->owner));
                break;
            }
            own.push_back({std::move(files), at});
        }
        claims.insert(claims.end(), own.begin(), own.end());
    }
}

/// Results are JSON, which is UTF-8: a text of other bytes, from a path or the command line, can't go into
/// them.
void check_texts(const Json& value, const std::string& at, Validator& validator) {
    if (value.is_string() && as_utf8(value.get<std::string>()) != value)
        validator.error(at,
                        fmt::format("{} is not UTF-8 (� stands for what isn't), as all that is written into "
                                    "results must be: choose another name",
                                    shown(value)));
    if (!value.is_structured()) return;
    for (const auto& [key, member] : value.items()) {
        if (as_utf8(key) != key) validator.error(at, fmt::format("the key {} is not UTF-8", shown(key)));
        check_texts(member, join_pointer(at, key), validator);
    }
}

SpaceId space_of(const Json& space) {
    const std::string mode = space.at("mode");
    // Plane stress is a matter of materials alone.
    return {.mode = mode == "bar"            ? Mode::bar
                    : mode == "axisymmetric" ? Mode::axisymmetric
                    : mode == "solid"        ? Mode::solid
                                             : Mode::plane_strain,
            .single = space.at("precision") == "single"};
}

}  // namespace

std::vector<std::filesystem::path> plugin_files(const Document& document) {
    std::vector<std::filesystem::path> files;
    if (!document.json.is_object() || !document.json.contains("plugins")) return files;
    const Json& given = document.json["plugins"];
    for (const Json& item : given.is_array() ? given : Json::array({given})) {
        if (item.is_string())
            files.push_back((folder_of(document) / item.get<std::string>()).lexically_normal());
    }
    return files;
}

Scene resolve_scene(Document document, Catalogue& catalogue) {
    Diagnostics diagnostics = document.mistakes;
    const int dimension = dimension_of(document.json);
    Validator validator(document, catalogue, dimension, diagnostics);
    Json filled = document.json;
    if (filled.is_object()) fill_in_dependents(filled, dimension, validator);

    Json resolved = validator.object(scene_schema(), filled, "");
    if (resolved.is_object()) check_sections(resolved, dimension, validator);
    diagnostics.throw_if_errors();

    if (is_absent(resolved, "title")) {
        Json titled = {{"matpoint", resolved["matpoint"]}, {"title", as_utf8(document.path.stem().string())}};
        titled.update(resolved);
        resolved = std::move(titled);
    }
    Json plugins = Json::array();
    for (const auto& file : plugin_files(document)) plugins.push_back(file.string());
    resolved["plugins"] = plugins;
    check_texts(resolved, "", validator);
    validator.check_rules(resolved);
    validator.check_formulas(resolved);
    check_output_files(resolved, catalogue, validator);
    diagnostics.throw_if_errors();

    const SpaceId space = space_of(resolved["space"]);
    const std::filesystem::path folder = folder_of(document);
    return {.resolved = std::move(resolved),
            .document = std::move(document),
            .space = space,
            .warnings = diagnostics.all(),
            .start_only = validator.start_only(),
            .folder = folder};
}

}  // namespace matpoint
