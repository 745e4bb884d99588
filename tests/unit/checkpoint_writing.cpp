#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <thread>

#include "checkpoint_fixture.hpp"
#include "run/rotation.hpp"

namespace matpoint {
namespace {

CheckpointData large_data(std::size_t particles) {
    CheckpointData data;
    data.bodies = {{"b",
                    static_cast<std::int64_t>(particles),
                    {{"mass", 0, std::vector<double>(particles, 1.5)}},
                    {},
                    {},
                    {}}};
    return data;
}

TEST_F(CheckpointTest, AFolderThatIsMissingOrAFileIsSaid) {
    EXPECT_SAYS(error_of([&] { write_checkpoint(folder / "no" / "c.h5", {}); }), "No such file or directory");
    put(folder / "plain", "");
    const std::string error = error_of([&] { write_checkpoint(folder / "plain" / "c.h5", {}); });
    EXPECT_SAYS(error, "can't write checkpoint " + (folder / "plain" / "c.h5").string());
    EXPECT_SAYS(error, "Not a directory");
}

TEST_F(CheckpointTest, AFailedWriteLeavesTheOldFileAndTheNextSucceeds) {
    write_checkpoint(file, large_data(10));
    const std::string before = bytes_of(file);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    for (const rlim_t bytes : {0u, 1u, 1000u, 100000u, 1000000u}) {
        rlimit limit = old;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
        const std::string error = error_of([&] { write_checkpoint(file, large_data(200000)); });
        setrlimit(RLIMIT_FSIZE, &old);
        EXPECT_SAYS(error, "File too large");
        EXPECT_EQ(bytes_of(file), before);
        EXPECT_FALSE(fs::exists(file.string() + ".tmp"));
    }
    std::signal(SIGXFSZ, handler);
    write_checkpoint(file, large_data(200000));
    EXPECT_EQ(read_checkpoint(file).bodies[0].size, 200000);
}

/// In a process of its own, whose mounts nobody else sees. 0: as expected, 1: not, 2: can't mount.
int write_to_a_full_disk(const fs::path& folder) {
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=512k") != 0)
        return 2;
    const fs::path file = folder / "c.h5";
    write_checkpoint(file, large_data(10));
    try {
        write_checkpoint(file, large_data(200000));
        return 1;
    } catch (const CheckpointError& error) {
        if (std::string(error.what()).find("No space left on device") == std::string::npos) return 1;
    }
    if (read_checkpoint(file).bodies[0].size != 10) return 1;
    write_checkpoint(file, large_data(20));
    if (read_checkpoint(file).bodies[0].size != 20) return 1;
    if (mount("tmpfs", folder.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) != 0) return 2;
    try {
        write_checkpoint(file, {});
        return 1;
    } catch (const CheckpointError& error) {
        return std::string(error.what()).find("Read-only file system") == std::string::npos ? 1 : 0;
    }
}

TEST_F(CheckpointTest, AFullAndAReadOnlyDiskAreSaid) {
    const pid_t child = fork();
    if (child == 0) _exit(write_to_a_full_disk(folder));
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 2) GTEST_SKIP() << "this user may not mount";
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(CheckpointTest, KilledAtAnyMomentOneOfTheTwoFilesIsThere) {
    write_checkpoint(file, large_data(1));
    for (int k = 0; k < 20; ++k) {
        const pid_t child = fork();
        if (child == 0) {
            for (;;) write_checkpoint(file, large_data(50000));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1 + k));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const std::int64_t size = read_checkpoint(file).bodies.at(0).size;
        EXPECT_TRUE(size == 1 || size == 50000) << size;
    }
}

TEST_F(CheckpointTest, RotationKeepsTheNewestAndOthersFiles) {
    for (const long step : {5L, 100000000L, 20L, 99999999L}) put(checkpoint_path(folder, step), "");
    for (const char* other : {"checkpoint_7.h5", "checkpoint_00000007.h5.bak", "my_checkpoint_00000007.h5"})
        put(folder / other, "");
    put(folder / "checkpoint_00000006.h5.tmp", "");
    prune_checkpoints(folder, 2);
    EXPECT_FALSE(fs::exists(folder / "checkpoint_00000005.h5"));
    EXPECT_FALSE(fs::exists(folder / "checkpoint_00000020.h5"));
    EXPECT_TRUE(fs::exists(folder / "checkpoint_99999999.h5"));
    EXPECT_TRUE(fs::exists(folder / "checkpoint_100000000.h5"));
    EXPECT_FALSE(fs::exists(folder / "checkpoint_00000006.h5.tmp"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 5);
    prune_checkpoints(folder, 9);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 5);
}

TEST_F(CheckpointTest, LaterOnesGoWhenARunStartsAnew) {
    for (const long step : {5L, 6L, 7L}) put(checkpoint_path(folder, step), "");
    remove_checkpoints_after(folder, 6);
    EXPECT_TRUE(fs::exists(checkpoint_path(folder, 6)));
    EXPECT_FALSE(fs::exists(checkpoint_path(folder, 7)));
    remove_checkpoints_after(folder, -1);
    EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace matpoint
