#include <sys/resource.h>

#include <csignal>

#include "output_fixture.hpp"

namespace matpoint {
namespace {

/// Files can't grow beyond `bytes` while it lives: the next write fails as on a full disk.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_);
        rlimit limit = old_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit old_{};
    void (*handler_)(int);
};

class FailingOutput : public OutputTest, public testing::WithParamInterface<const char*> {
  protected:
    std::shared_ptr<Output> make_output() {
        Json own{{"type", GetParam()}, {"name", "o"}};
        if (own["type"] == "probe") own["quantity"] = "mass";
        const auto output = make(own);
        output->check(run);
        return output;
    }
};

TEST_P(FailingOutput, SaysWhichFileCouldNotBeWrittenAndWhy) {
    const auto output = make_output();
    output->open(run, folder, -1);
    write_at(*output, 0, 0);
    std::string error;
    {
        const FileSizeLimit limit(4);
        error = error_of([&] { write_at(*output, 1, 1); });
    }
    EXPECT_SAYS(error, "can't write " + folder.string() + "/o");
    EXPECT_SAYS(error, "File too large");
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_P(FailingOutput, SaysThatTheFolderIsMissing) {
    const auto output = make_output();
    const std::string error = error_of([&] {
        output->open(run, folder / "missing", -1);
        write_at(*output, 0, 0);
    });
    EXPECT_SAYS(error, "missing/o");
    EXPECT_SAYS(error, "No such file or directory");
}

INSTANTIATE_TEST_SUITE_P(AllTypes, FailingOutput, testing::Values("vtk", "csv", "probe"));

TEST_F(OutputTest, AFullDiskLeavesTheOldSeriesWhole) {
    const auto vtk = make({{"type", "vtk"}, {"name", "s"}});
    vtk->open(run, folder, -1);
    write_at(*vtk, 0, 0);
    const std::string before = text_of("s.pvd");
    std::filesystem::create_symlink("/dev/full", folder / "s.pvd.tmp");
    EXPECT_SAYS(error_of([&] { write_at(*vtk, 1, 1); }), "s.pvd: No space left on device");
    EXPECT_EQ(text_of("s.pvd"), before);
}

}  // namespace
}  // namespace matpoint
