// Processes side by side: how they end is told, and no more of them run than may.

#include <gtest/gtest.h>
#include <unistd.h>

#include "study/process.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>
#include <utility>

namespace {

using namespace matpoint;
namespace fs = std::filesystem;

class Processes : public testing::Test {
  protected:
    Processes() {
        std::string name = (fs::temp_directory_path() / "matpoint_processes_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~Processes() override { fs::remove_all(folder); }

    /// Runs shell commands, so many at a time.
    bool run(const std::vector<std::string>& commands, int most) {
        std::size_t started = 0;
        return run_side_by_side({.most = most,
                                 .next = [&]() -> std::optional<Job> {
                                     if (started == commands.size()) return {};
                                     const std::size_t i = started++;
                                     return Job{i, {"/bin/sh", "-c", commands[i]}, log(i)};
                                 },
                                 .ended = [&](std::size_t id, ProcessEnd end) { ends[id] = end; },
                                 .waiting =
                                     [&](int running) {
                                         most_running = std::max(most_running, running);
                                         if (when_waiting) when_waiting();
                                     }});
    }
    fs::path log(std::size_t i) const { return folder / (std::to_string(i) + ".txt"); }
    std::string text(std::size_t i) const {
        std::ifstream stream(log(i));
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    fs::path folder;
    std::map<std::size_t, ProcessEnd> ends;
    int most_running = 0;
    std::function<void()> when_waiting;
};

TEST_F(Processes, HowTheyEndIsTold) {
    EXPECT_TRUE(run({"echo out; echo err >&2", "exit 3", "kill -SEGV $$", "cat"}, 2));
    ASSERT_EQ(ends.size(), 4u);
    EXPECT_EQ(ends[0].status, 0);
    EXPECT_EQ(text(0), "out\nerr\n");
    EXPECT_EQ(ends[1].status, 3);
    EXPECT_EQ(ends[1].signal, 0);
    EXPECT_EQ(ends[2].signal, SIGSEGV);
    EXPECT_EQ(ends[3].status, 0) << "standard input is empty";
}

TEST_F(Processes, NoMoreThanMay) {
    EXPECT_TRUE(run({"sleep 0.05", "sleep 0.05", "sleep 0.05", "sleep 0.05", "sleep 0.05"}, 2));
    EXPECT_EQ(ends.size(), 5u);
    EXPECT_EQ(most_running, 2);
}

TEST_F(Processes, AreKilledByASignal) {
    when_waiting = [] { raise(SIGTERM); };
    EXPECT_FALSE(run({"exec sleep 100", "exec sleep 100"}, 2)) << "or it lasts 100 s";
    EXPECT_TRUE(ends.empty());
}

TEST_F(Processes, AProgramThatIsNotThere) {
    std::optional<Job> job = Job{0, {"/no/such/program"}, log(0)};
    EXPECT_THROW(run_side_by_side({.most = 1,
                                   .next = [&] { return std::exchange(job, {}); },
                                   .ended = [](std::size_t, ProcessEnd) {},
                                   .waiting = [](int) {}}),
                 std::system_error);
}

}  // namespace
