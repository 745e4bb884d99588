// The JSON Schema of all components, read by valijson: every shipped scene is valid, and none is any
// more once one of its keys is misspelt or one of its values is of another type.
#include "../unit/editor.hpp"
#include "config/document.hpp"
#include "registry/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace matpoint::conformance {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> shipped_scenes() {
    std::vector<fs::path> scenes;
    const fs::path plugins = PLUGIN_SOURCES;
    for (const fs::path& root : {plugins, plugins.parent_path() / "configs"})
        for (const auto& entry : fs::recursive_directory_iterator(root)) {
            const std::string name = entry.path().filename().string();
            if (entry.path().extension() == ".json" && name.find(".test.json") == std::string::npos &&
                read_document(entry.path()).json.contains("matpoint"))
                scenes.push_back(entry.path());
        }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

/// Whether the keys of the object at `pointer` are the user's own names.
bool is_free(const std::string& pointer) {
    return pointer == "/materials" || pointer == "/bodies";
}

/// Calls `visit` with the scene broken in one place after the other.
template <class Visit>
void break_everywhere(const Json& scene, const std::string& pointer, const Visit& visit) {
    const Json& here = scene.at(Json::json_pointer(pointer));
    if (here.is_array())
        for (std::size_t i = 0; i < here.size(); ++i)
            break_everywhere(scene, pointer + "/" + std::to_string(i), visit);
    if (!here.is_object()) return;
    for (const auto& [key, value] : here.items()) {
        const std::string at = join_pointer(pointer, key);
        if (at.rfind("/checks", 0) == 0) continue;
        if (!is_free(pointer)) {
            Json misspelt = scene;
            Json& object = misspelt.at(Json::json_pointer(pointer));
            object[key + "x"] = value;
            object.erase(key);
            visit(misspelt, at + " misspelt");
        }
        if (key != "comment") {
            Json other = scene;
            other.at(Json::json_pointer(at)) = value.is_object() ? Json(true) : Json{{"surprise", 1}};
            visit(other, at + " of another type");
        }
        break_everywhere(scene, at, visit);
    }
}

TEST(SceneSchema, AcceptsEveryShippedSceneAndNoneBroken) {
    PluginCatalogue catalogue;
    catalogue.open_all();
    const Editor editor(catalogue);
    const std::vector<fs::path> scenes = shipped_scenes();
    ASSERT_GT(scenes.size(), 30U);
    for (const fs::path& path : scenes) {
        const Json scene = read_document(path).json;
        EXPECT_TRUE(editor.accepts(scene)) << path;
        break_everywhere(scene, "", [&](const Json& broken, const std::string& what) {
            EXPECT_FALSE(editor.accepts(broken)) << path << ": " << what;
        });
    }
}

}  // namespace
}  // namespace matpoint::conformance
