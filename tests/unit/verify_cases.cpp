// Finding the cases of the regression suite in files and folders.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "verify/cases.hpp"

namespace {

using namespace matpoint;
namespace fs = std::filesystem;

class Cases : public testing::Test {
  protected:
    Cases() : before(fs::current_path()) {
        std::string name = (fs::temp_directory_path() / "matpoint_cases_XXXXXX").string();
        folder = mkdtemp(name.data());
        fs::current_path(folder);
    }
    ~Cases() override {
        fs::current_path(before);
        fs::remove_all(folder);
    }

    static void write(const fs::path& file, const std::string& text) {
        if (file.has_parent_path()) fs::create_directories(file.parent_path());
        std::ofstream(file) << text;
    }
    std::vector<std::string> ids(const std::vector<fs::path>& paths) {
        mistakes = {};
        std::vector<std::string> found;
        for (const Case& c : find_cases(paths, mistakes)) found.push_back(c.id);
        return found;
    }

    fs::path before, folder;
    Diagnostics mistakes;
};

TEST_F(Cases, AreFoundInFoldersAndCalledByTheirPath) {
    write("suite/b/disk.test.json", R"({"scene": "disk.json", "cases": {"second": {}, "first": {}}})");
    write("suite/a.json", R"({"matpoint": 1, "checks": [{"restart_equals_run": true}]})");
    write("suite/no_checks.json", R"({"matpoint": 1})");
    write("suite/notes.json", "no JSON");
    const std::vector<std::string> expected{"suite/a:checks", "suite/b/disk:first", "suite/b/disk:second"};
    EXPECT_EQ(ids({"suite"}), expected);
    EXPECT_TRUE(mistakes.empty()) << mistakes.text();
    EXPECT_EQ(ids({"suite/b/disk.test.json"}).size(), 2u);
}

TEST_F(Cases, CarryWhatTheFileSays) {
    write("suite/disk.test.json", R"({"scene": "../scenes/disk.json", "cases": {"short": {
        "tags": "slow", "set": {"/time/end": 0.1, "/title": "a b"},
        "checks": [{"summary": "/steps", "below": 5}]}}})");
    const std::vector<Case> cases = find_cases({"suite"}, mistakes);
    ASSERT_EQ(cases.size(), 1u) << mistakes.text();
    EXPECT_EQ(cases[0].scene, "scenes/disk.json");
    EXPECT_EQ(cases[0].tags, std::vector<std::string>{"slow"});
    EXPECT_EQ(cases[0].assignments, (std::vector<std::string>{"/time/end=0.1", "/title=\"a b\""}));
    EXPECT_EQ(cases[0].pointer, "/cases/short");
    EXPECT_EQ(cases[0].checks.size(), 1u);
}

TEST_F(Cases, MistakesAreToldAllAtOnce) {
    write("a.test.json",
          "{\"scene\": \"a.json\",\n\"cases\": {\n\"a\": {\"cheks\": []},\n\"b\": {\"tags\": 3}}}");
    write("b.test.json", R"({"scene": "b.json", "cases": {"x": {"checks": [{"summary": "/a"}]}}})");
    ids({"."});
    const std::string text = mistakes.text();
    EXPECT_NE(text.find("a.test.json:3:"), std::string::npos) << text;
    EXPECT_NE(text.find("did you mean \"checks\""), std::string::npos) << text;
    EXPECT_NE(text.find("a.test.json:4:"), std::string::npos) << text;
    EXPECT_NE(text.find("/cases/x/checks/0"), std::string::npos) << text;
}

TEST_F(Cases, RefuseWhatMakesNoSense) {
    const auto told = [&](const std::string& own) {
        write("a.test.json", R"({"scene": "a.json", "cases": {"x": )" + own + "}}");
        ids({"a.test.json"});
        return mistakes.text();
    };
    EXPECT_EQ(told("{}"), "");
    EXPECT_NE(told(R"({"set": {"time": 1}})").find("/cases/x/set"), std::string::npos);
    EXPECT_NE(told(R"({"set": 1})").find("/cases/x/set"), std::string::npos);
    EXPECT_NE(told(R"({"checks": [{"restart_equals_run": true}], "expect_error": {"at": "/time"}})")
                  .find("/cases/x/checks"),
              std::string::npos);
    EXPECT_NE(
        told(R"({"expect_error": {"at": "/time", "status": "broke_down"}})").find("/cases/x/expect_error"),
        std::string::npos);
    EXPECT_NE(told(R"({"expect_error": {"status": "brok_down"}})").find("broke_down"), std::string::npos);
    ids({"missing.test.json"});
    EXPECT_TRUE(mistakes.has_errors());
    write("scene.json", R"({"matpoint": 1})");
    ids({"scene.json"});
    EXPECT_TRUE(mistakes.has_errors()) << "a scene without checks, named";
}

}  // namespace
