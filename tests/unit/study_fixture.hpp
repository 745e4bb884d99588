#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include "study/study_file.hpp"

#include <filesystem>
#include <fstream>
#include <string>

namespace matpoint {

/// A folder with files of studies in it.
class StudyFolder : public testing::Test {
  protected:
    StudyFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "matpoint_study_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~StudyFolder() override { std::filesystem::remove_all(folder); }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
        return folder / name;
    }

    StudyFile study(const std::string& members) const {
        return read_study_file(write("s.json", "{\"scene\": \"scene.json\", " + members + "}"));
    }

    std::filesystem::path folder;
};

}  // namespace matpoint
