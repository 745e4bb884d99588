#pragma once

#include "registry/plugin_library.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace registry_test {

namespace fs = std::filesystem;

inline const fs::path sound = fs::path(TEST_PLUGINS) / "sound";
inline const fs::path broken = fs::path(TEST_PLUGINS) / "broken";

/// The text of the PluginError that `call` throws; empty if it throws none.
inline std::string error_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const matpoint::PluginError& error) {
        return error.what();
    }
    return "";
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << "in: " << (text)

/// A folder of the test's own, removed at its end.
class TemporaryFolder : public testing::Test {
  protected:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "matpoint_registry_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~TemporaryFolder() override { fs::remove_all(folder); }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
        return folder / name;
    }
    /// A copy of a sound plugin and its index, under another name.
    fs::path copy(const std::string& plugin, const std::string& name) const {
        fs::copy_file(sound / (plugin + ".plugin.json"), folder / (name + ".plugin.json"));
        fs::copy_file(sound / (plugin + ".so"), folder / (name + ".so"));
        return folder / (name + ".so");
    }

    fs::path folder;
};

}  // namespace registry_test
