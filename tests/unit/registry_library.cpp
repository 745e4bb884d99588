// Opening one plugin: what is wrong with a broken one is said in full.

#include "registry/instruction_set.hpp"
#include "registry_fixture.hpp"

#include <matpoint/plugin.hpp>

namespace matpoint {

using namespace registry_test;

namespace {

std::string error_of_opening(const fs::path& file) {
    return error_of([&] { PluginLibrary library(file); });
}

std::string error_of_registering(const fs::path& file) {
    const PluginLibrary library(file);
    return error_of([&] { library.components(); });
}

}  // namespace

TEST(RegistryLibrary, OpensASoundPlugin) {
    const PluginLibrary library(sound / "beta.so");
    EXPECT_EQ(library.name(), "beta");
    EXPECT_EQ(library.version(), "1.2.3");
    const Registry components = library.components();
    ASSERT_EQ(components.entries().size(), 2u);
    const Registry::Entry* entry = components.find("geometry", "beta_point");
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->plugin, "beta");
    EXPECT_EQ(entry->version, "1.2.3");
    EXPECT_EQ(entry->schema.doc(), "The origin");
}

TEST(RegistryLibrary, NamesAMissingFile) {
    const std::string error = error_of_opening("/nowhere/at/all.so");
    EXPECT_SAYS(error, "/nowhere/at/all.so does not exist");
    EXPECT_SAYS(error, "build the plugin");
}

TEST(RegistryLibrary, RefusesAFolder) {
    EXPECT_SAYS(error_of_opening(sound), "is not a file");
}

using RegistryLibraryFile = TemporaryFolder;

TEST_F(RegistryLibraryFile, RefusesAnEmptyFile) {
    const std::string error = error_of_opening(write("empty.so", ""));
    EXPECT_SAYS(error, "empty.so is not a shared library");
    EXPECT_SAYS(error, "matpoint_add_plugin");
}

TEST_F(RegistryLibraryFile, RefusesAText) {
    EXPECT_SAYS(error_of_opening(write("text.so", std::string(5000, 'x'))),
                "text.so is not a shared library");
}

TEST_F(RegistryLibraryFile, RefusesATruncatedLibrary) {
    const fs::path file = copy("alpha", "half");
    fs::resize_file(file, 1000);
    EXPECT_SAYS(error_of_opening(file), "half.so is not a shared library");
}

class RegistryLibraryBuilds : public TemporaryFolder {
  protected:
    /// Another build of a plugin, for an instruction set: a copy of its library.
    fs::path build(const fs::path& plugin, const std::string& set) const {
        fs::create_directory(folder / set);
        fs::copy_file(plugin, folder / set / plugin.filename());
        return folder / set / plugin.filename();
    }
    static bool kernel_is_for(std::string_view set) { return instruction_set() == set; }
};

TEST_F(RegistryLibraryBuilds, OpensTheOneForTheKernelsInstructionSet) {
    const fs::path plugin = copy("alpha", "alpha");
    const fs::path v3 = build(plugin, "x86-64-v3"), v4 = build(plugin, "x86-64-v4");
    EXPECT_EQ(PluginLibrary(plugin).opened_file(), kernel_is_for("x86-64-v4")   ? v4
                                                   : kernel_is_for("x86-64-v3") ? v3
                                                                                : plugin);
    EXPECT_EQ(PluginLibrary(plugin).file(), plugin);
}

TEST_F(RegistryLibraryBuilds, OpensTheNextLowerOneIfThereIsNone) {
    const fs::path plugin = copy("alpha", "alpha");
    EXPECT_EQ(PluginLibrary(plugin).opened_file(), plugin);
    const fs::path v3 = build(plugin, "x86-64-v3");
    EXPECT_EQ(PluginLibrary(plugin).opened_file(),
              kernel_is_for("x86-64-v4") || kernel_is_for("x86-64-v3") ? v3 : plugin);
}

TEST_F(RegistryLibraryBuilds, NamesTheBuildThatIsWrong) {
    if (!kernel_is_for("x86-64-v4") && !kernel_is_for("x86-64-v3"))
        GTEST_SKIP() << "this kernel opens no other builds";
    const fs::path plugin = copy("alpha", "alpha");
    fs::resize_file(build(plugin, "x86-64-v3"), 1000);
    EXPECT_SAYS(error_of_opening(plugin), "x86-64-v3/alpha.so is not a shared library");
}

TEST_F(RegistryLibraryBuilds, MissesThePluginThoughABuildOfItIsThere) {
    const fs::path plugin = copy("alpha", "alpha");
    build(plugin, "x86-64-v3");
    fs::remove(plugin);
    EXPECT_SAYS(error_of_opening(plugin), (folder / "alpha.so").string() + " does not exist");
}

TEST(RegistryLibrary, RefusesALibraryWithoutStamp) {
    const std::string error = error_of_opening(broken / "no_stamp.so");
    EXPECT_SAYS(error, "no_stamp.so is not a Matpoint plugin");
    EXPECT_SAYS(error, "MATPOINT_PLUGIN(");
}

TEST(RegistryLibrary, RefusesAStampOfSomethingElse) {
    EXPECT_SAYS(error_of_opening(broken / "wrong_magic.so"), "wrong_magic.so is not a Matpoint plugin");
}

TEST(RegistryLibrary, NamesBothSidesOfAnotherBinaryInterface) {
    const std::string error = error_of_opening(broken / "wrong_abi.so");
    EXPECT_SAYS(error, "wrong_abi.so was built for another binary interface");
    EXPECT_SAYS(error,
                "ABI version: the kernel has " + std::to_string(MATPOINT_ABI_VERSION) + ", the plugin has 0");
    EXPECT_SAYS(error, "compiler: the kernel has " __VERSION__ ", the plugin has Brand X 9.8");
    EXPECT_SAYS(error, "the plugin has libstdc++ 4 cxx11-abi 0");
    EXPECT_SAYS(error, "Eigen: the kernel has 3.4.");
    EXPECT_SAYS(error, "the plugin has 3.3.99");
    EXPECT_SAYS(error, "alignment in bytes: the kernel has 32, the plugin has 16");
    EXPECT_SAYS(error, "the plugin has 2.1.2");
    EXPECT_SAYS(error, "rebuild the plugin against this installation's SDK");
}

TEST(RegistryLibrary, NamesTheMissingFunction) {
    EXPECT_SAYS(error_of_opening(broken / "missing_register.so"), "has no function matpoint_plugin_register");
}

TEST(RegistryLibrary, NamesTheUndefinedSymbol) {
    const std::string error = error_of_opening(broken / "undefined_symbol.so");
    EXPECT_SAYS(error, "undefined_symbol.so needs \"acme::yield_stress(double)\"");
    EXPECT_SAYS(error, "target_link_libraries");
}

TEST(RegistryLibrary, NamesTheLibraryThatAPluginMisses) {
    const std::string error = error_of_opening(broken / "missing_library.so");
    EXPECT_SAYS(error, "missing on this machine");
    EXPECT_SAYS(error, "libnowhere_to_be_found.so");
}

TEST(RegistryLibrary, QuotesAnExceptionOfThePlugin) {
    const std::string error = error_of_registering(broken / "throws.so");
    EXPECT_SAYS(error, "throws.so");
    EXPECT_SAYS(error, "\"no licence for this Tuesday\"");
}

TEST(RegistryLibrary, RefusesATypeRegisteredTwiceByOnePlugin) {
    const std::string error = error_of_registering(broken / "registers_twice.so");
    EXPECT_SAYS(error, "registers_twice.so");
    EXPECT_SAYS(error, "geometry \"twin\" is registered twice");
}

}  // namespace matpoint
