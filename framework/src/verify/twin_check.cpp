#include <matpoint/input_file.hpp>

#include "verify/check.hpp"
#include "verify/load_scene.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace matpoint {
namespace {

/// Where two files differ first; empty if they are the same.
std::string first_difference(const std::filesystem::path& file, const std::filesystem::path& twin) {
    for (const std::filesystem::path& each : {file, twin})
        if (const std::string why = why_unreadable(each); !why.empty())
            throw std::runtime_error(fmt::format("{}: {}", each.string(), why));
    std::ifstream ours(file), theirs(twin);
    for (int line = 1;; ++line) {
        std::string a, b;
        const bool more = static_cast<bool>(std::getline(ours, a));
        if (more != static_cast<bool>(std::getline(theirs, b)))
            return fmt::format("{} and {} have different lengths", file.string(), twin.string());
        if (!more) return {};
        if (a != b)
            return fmt::format("{}:{} is \"{}\", in {} \"{}\"", file.string(), line, a, twin.string(), b);
    }
}

CheckResult evaluate_twin(const Json& check, const FinishedRun& run) {
    const std::filesystem::path file = check.at("twin").get<std::string>();
    const std::string name = file.filename().string();
    const std::filesystem::path folder = run.output / "twin";
    std::vector<std::string> assignments;
    for (const auto& [at, value] : check.at("set").items()) assignments.push_back(at + "=" + value.dump());
    PluginCatalogue catalogue;
    const Scene scene = load_scene(file, assignments, catalogue);
    const RunResult twin = run_scene(scene, catalogue, {.output = folder, .quiet = true});
    if (twin.status != RunStatus::completed) throw std::runtime_error("the other scene: " + twin.reason);

    const std::vector<std::string> files = check.at("files");
    CheckResult result{.holds = true, .measured = fmt::format("{} files as {}: same", files.size(), name)};
    for (const std::string& each : files) {
        const std::string difference = first_difference(run.output / each, folder / each);
        if (!difference.empty())
            return {.holds = false, .measured = fmt::format("{} not as {}", each, name), .where = difference};
    }
    return result;
}

}  // namespace

CheckKind twin_check() {
    Schema schema("Files that the run wrote are the same, to the last bit, as another scene's");
    schema
        .add("twin", ParameterType::file,
             {.doc = "The other scene, relative to the file with the check; it is run too"})
        .add(
            "set", ParameterType::any,
            {.doc = "Values of the other scene to replace, by JSON pointer", .default_value = Json::object()})
        .add("files", ParameterType::texts, {.doc = "Names of files in the folders of results"})
        .text("comment", {.doc = "For readers", .optional = true})
        .refuse("/files", "expected the name of a file at least",
                [](const Json& own, const Json&) { return own.contains("files") && own.at("files").empty(); })
        .refuse(
            "/set", "expected an object of values by JSON pointer, {\"/time/end\": 0.1}",
            [](const Json& own, const Json&) { return own.contains("set") && !own.at("set").is_object(); });
    return {"twin", schema, evaluate_twin};
}

}  // namespace matpoint
