// Finding plugins by the types they have, without opening the others.

#include "registry/catalogue.hpp"
#include "registry_fixture.hpp"

#include <cstdlib>
#include <matpoint/geometry.hpp>

namespace matpoint {

using namespace registry_test;

namespace {

bool is_mapped(const fs::path& library) {
    std::ifstream maps("/proc/self/maps");
    const std::string text{std::istreambuf_iterator<char>(maps), {}};
    return text.find(library.string()) != text.npos;
}

std::vector<std::string> names(const PluginCatalogue& catalogue) {
    std::vector<std::string> names;
    for (const PluginLibrary& library : catalogue.opened()) names.push_back(library.name());
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

class RegistryCatalogue : public TemporaryFolder {
  protected:
    ~RegistryCatalogue() override { unsetenv("MATPOINT_PLUGIN_PATH"); }
};

TEST_F(RegistryCatalogue, OpensOnlyThePluginThatIsAskedFor) {
    PluginCatalogue catalogue(PluginIndex({sound}));
    EXPECT_TRUE(names(catalogue).empty());
    const Schema* schema = catalogue.find("geometry", "alpha_point");
    ASSERT_NE(schema, nullptr);
    EXPECT_EQ(schema->doc(), "The origin");
    EXPECT_EQ(names(catalogue), Names{"alpha"});
    EXPECT_TRUE(is_mapped("alpha.so"));
    EXPECT_FALSE(is_mapped("sleeper.so"));

    EXPECT_EQ(catalogue.find("geometry", "alpha_point"), schema);
    ASSERT_NE(catalogue.find("geometry", "beta_origin"), nullptr);
    ASSERT_NE(catalogue.find("geometry", "beta_point"), nullptr);
    EXPECT_EQ(names(catalogue), (Names{"alpha", "beta"}));
}

TEST_F(RegistryCatalogue, KnowsAllTypesWithoutOpeningAny) {
    const PluginCatalogue catalogue(PluginIndex({sound}));
    EXPECT_EQ(catalogue.types("geometry"),
              (Names{"alpha_point", "beta_origin", "beta_point", "sleeper_point"}));
    EXPECT_TRUE(catalogue.types("material").empty());
    EXPECT_TRUE(catalogue.opened().empty());
}

TEST_F(RegistryCatalogue, HasNoUnknownTypes) {
    PluginCatalogue catalogue(PluginIndex({sound}));
    EXPECT_EQ(catalogue.find("geometry", "alpha"), nullptr);
    EXPECT_EQ(catalogue.find("material", "alpha_point"), nullptr);
    EXPECT_TRUE(catalogue.opened().empty());
}

TEST_F(RegistryCatalogue, ComponentsOutliveIt) {
    std::shared_ptr<Geometry> point;
    {
        PluginCatalogue catalogue(PluginIndex({sound}));
        catalogue.find("geometry", "alpha_point");
        point = catalogue.registry().make<Geometry>("geometry", {{"type", "alpha_point"}}, {});
    }
    EXPECT_TRUE(point->contains(Eigen::Vector3d::Zero()));
    EXPECT_FALSE(point->contains(Eigen::Vector3d::Ones()));
}

TEST_F(RegistryCatalogue, OpensAFileThatHasNoIndex) {
    PluginCatalogue catalogue(PluginIndex({}));
    catalogue.open_file(sound / "alpha.so");
    catalogue.open_file(broken / ".." / "sound" / "alpha.so");  // the same file again
    EXPECT_EQ(names(catalogue), Names{"alpha"});
    EXPECT_EQ(catalogue.types("geometry"), Names{"alpha_point"});
}

TEST_F(RegistryCatalogue, OpensAll) {
    copy("alpha", "one");
    copy("beta", "two");
    PluginCatalogue catalogue(PluginIndex({folder, folder}));
    catalogue.open_all();
    EXPECT_EQ(names(catalogue), (Names{"alpha", "beta"}));
}

TEST_F(RegistryCatalogue, NamesTwoOpenedPluginsWithOneType) {
    PluginCatalogue catalogue(PluginIndex({}));
    catalogue.open_file(sound / "alpha.so");
    const std::string error = error_of([&] { catalogue.open_file(broken / "takes_alpha_type.so"); });
    EXPECT_SAYS(error, "geometry \"alpha_point\" is registered twice");
    EXPECT_SAYS(error, (sound / "alpha.so").string());
    EXPECT_SAYS(error, (broken / "takes_alpha_type.so").string());
    EXPECT_EQ(names(catalogue), Names{"alpha"});
}

TEST_F(RegistryCatalogue, NamesTwoIndexedPluginsWithOneTypeWhenItIsAskedFor) {
    const fs::path twin = copy("alpha", "alpha_copy");
    PluginCatalogue catalogue(PluginIndex({sound, folder}));
    EXPECT_NE(catalogue.find("geometry", "beta_point"), nullptr);
    const std::string error = error_of([&] { catalogue.find("geometry", "alpha_point"); });
    EXPECT_SAYS(error, "is offered by two plugins");
    EXPECT_SAYS(error, (sound / "alpha.so").string());
    EXPECT_SAYS(error, twin.string());
    EXPECT_EQ(names(catalogue), Names{"beta"});

    PluginCatalogue chosen(PluginIndex({sound, folder}));
    chosen.open_file(twin);
    EXPECT_NE(chosen.find("geometry", "alpha_point"), nullptr);
}

TEST_F(RegistryCatalogue, MissesALibraryOnlyWhenItsTypeIsAskedFor) {
    fs::remove(copy("alpha", "gone"));
    copy("beta", "here");
    PluginCatalogue catalogue(PluginIndex({folder}));
    EXPECT_NE(catalogue.find("geometry", "beta_point"), nullptr);
    EXPECT_SAYS(error_of([&] { catalogue.find("geometry", "alpha_point"); }), "gone.so does not exist");
}

TEST_F(RegistryCatalogue, TellsAnIndexThatPromisesTooMuch) {
    copy("alpha", "boaster");
    write("boaster.plugin.json", R"({"plugin": "alpha", "version": "2", "abi": 1,
        "components": [{"kind": "geometry", "type": "moon", "doc": ""}]})");
    PluginCatalogue catalogue(PluginIndex({folder}));
    EXPECT_SAYS(error_of([&] { catalogue.find("geometry", "moon"); }), "rebuild");
}

TEST_F(RegistryCatalogue, TellsAnotherAbiVersionFromTheIndex) {
    write("old.plugin.json", R"({"plugin": "old", "version": "2", "abi": 77,
        "components": [{"kind": "geometry", "type": "moon", "doc": ""}]})");
    PluginCatalogue catalogue(PluginIndex({folder}));
    EXPECT_SAYS(error_of([&] { catalogue.find("geometry", "moon"); }), "ABI version 77");
}

TEST_F(RegistryCatalogue, RefusesALibraryWithoutIndex) {
    fs::remove(copy("alpha", "bare").replace_extension(".plugin.json"));
    const std::string error = error_of([&] { PluginIndex index({folder}); });
    EXPECT_SAYS(error, (folder / "bare.so").string());
    EXPECT_SAYS(error, "bare.plugin.json");
    EXPECT_SAYS(error, "matpoint_add_plugin");
}

TEST_F(RegistryCatalogue, RefusesAnIndexThatCannotBeRead) {
    for (const char* text : {"", "{", "[]", R"({"plugin": "x", "version": 3, "abi": 1, "components": []})"}) {
        const fs::path file = write("odd.plugin.json", text);
        EXPECT_SAYS(error_of([&] { PluginIndex index({folder}); }), file.string());
    }
}

TEST_F(RegistryCatalogue, LooksIntoTheEnvironmentsFoldersFirst) {
    setenv("MATPOINT_PLUGIN_PATH", (sound.string() + "::" + folder.string()).c_str(), 1);
    const std::vector<fs::path> folders = plugin_folders();
    ASSERT_EQ(folders.size(), 3u);
    EXPECT_EQ(folders[0], sound);
    EXPECT_EQ(folders[1], folder);
    EXPECT_EQ(folders[2], fs::path(INSTALLED_PLUGINS));
}

TEST_F(RegistryCatalogue, RefusesAFolderOfTheEnvironmentThatDoesNotExist) {
    setenv("MATPOINT_PLUGIN_PATH", "/nowhere/at/all", 1);
    const std::string error = error_of([] { plugin_folders(); });
    EXPECT_SAYS(error, "MATPOINT_PLUGIN_PATH names the folder /nowhere/at/all");
}

}  // namespace matpoint
