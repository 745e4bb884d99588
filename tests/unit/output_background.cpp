// Files written while the run goes on: the same files, one job at a time, and no failure lost.

#include <matpoint/background_writer.hpp>

#include <atomic>
#include <chrono>
#include <ctime>
#include <future>
#include <thread>

#include "output_fixture.hpp"

namespace matpoint {
namespace {

using namespace std::chrono_literals;

/// Holds a job until it is opened. A test that would hang fails instead.
class Gate {
  public:
    void open() { opened_.set_value(); }
    bool wait() { return future_.wait_for(60s) == std::future_status::ready; }

  private:
    std::promise<void> opened_;
    std::future<void> future_ = opened_.get_future();
};

TEST(BackgroundWriter, WorksWhileItsCallerGoesOn) {
    BackgroundWriter writer;
    Gate gate;
    bool went_on = false;
    writer.submit([&] { went_on = gate.wait(); });
    gate.open();
    writer.wait();
    EXPECT_TRUE(went_on);
}

TEST(BackgroundWriter, TheNextJobWaitsForTheOneAtWork) {
    BackgroundWriter writer;
    Gate gate;
    std::vector<int> ended;
    writer.submit([&] {
        if (gate.wait()) ended.push_back(1);
    });
    auto next = std::async(std::launch::async, [&] { writer.submit([&] { ended.push_back(2); }); });
    EXPECT_EQ(next.wait_for(50ms), std::future_status::timeout);
    gate.open();
    next.get();
    writer.wait();
    EXPECT_EQ(ended, (std::vector<int>{1, 2}));
}

TEST(BackgroundWriter, AFailureIsThrownOnceByTheNextCall) {
    BackgroundWriter writer;
    const auto fail = [] { throw std::runtime_error("no space"); };
    bool began = false;
    writer.submit(fail);
    EXPECT_THROW(writer.submit([&] { began = true; }), std::runtime_error);
    EXPECT_NO_THROW(writer.wait());
    EXPECT_FALSE(began);
    writer.submit(fail);
    EXPECT_THROW(writer.wait(), std::runtime_error);
    EXPECT_NO_THROW(writer.wait());
}

TEST(BackgroundWriter, ItsEndWaitsForTheJob) {
    std::atomic<bool> ended = false;
    {
        BackgroundWriter writer;
        writer.submit([&] {
            std::this_thread::sleep_for(20ms);
            ended = true;
        });
    }
    EXPECT_TRUE(ended);
}

TEST(BackgroundWriter, WhatAJobCarriesGoesWhenItIsDone) {
    BackgroundWriter writer;
    auto carried = std::make_shared<int>(1);
    const std::weak_ptr<int> seen = carried;
    writer.submit([data = std::move(carried)] {});
    for (int k = 0; k < 60000 && !seen.expired(); ++k) std::this_thread::sleep_for(1ms);
    EXPECT_TRUE(seen.expired());
}

TEST(BackgroundWriter, ProcessorTimeIsCountedAtWorkAndAfterwards) {
    constexpr double spent = 0.02;
    const double before = background_cpu_seconds();
    double at_work = 0;
    BackgroundWriter writer;
    writer.submit([&] {
        timespec own{};
        while (own.tv_sec == 0 && own.tv_nsec < static_cast<long>(1e9 * spent))
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &own);
        at_work = background_cpu_seconds();
    });
    writer.wait();
    EXPECT_GE(at_work - before, spent);
    EXPECT_GE(background_cpu_seconds(), at_work);
}

class WritingInBackground : public OutputTest, public testing::WithParamInterface<const char*> {
  protected:
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            all[entry.path().filename().string()] = text_of(entry.path().filename().string());
        return all;
    }
    /// Five writes of particles that move in between.
    std::map<std::string, std::string> series(bool wait_each_time) {
        run = plane_strain_run();
        const auto output = make({{"type", GetParam()}, {"name", "o"}});
        output->open(run, folder, -1);
        for (int k = 0; k < 5; ++k) {
            run.now = 0.1 * k;
            run.steps = k;
            output->write(run);
            if (wait_each_time) output->flush();
            for (auto& [name, fields] : run.data)
                for (auto& column : fields["velocity"])
                    for (double& value : column) value += 1.0 / 3;
        }
        output->flush();
        return files();
    }
};

TEST_P(WritingInBackground, MakesTheSameFilesAsWaitingForEach) {
    const auto waited = series(true);
    EXPECT_GT(waited.size(), 5u);
    for (const auto& [name, text] : waited) std::filesystem::remove(folder / name);
    EXPECT_EQ(series(false), waited);
}

TEST_P(WritingInBackground, AFullDiskIsToldByTheNextWriteAndTheSeriesStaysWhole) {
    const std::string file = GetParam() == std::string("vtk") ? "o_000001.vtp" : "o_disk_000001.csv";
    const std::string list = GetParam() == std::string("vtk") ? "o.pvd" : "o_times.csv";
    const auto output = make({{"type", GetParam()}, {"name", "o"}});
    output->open(run, folder, -1);
    write_at(*output, 0, 0);
    const std::string before = text_of(list);
    std::filesystem::create_symlink("/dev/full", folder / (file + ".tmp"));
    run.now = 1;
    EXPECT_EQ(error_of([&] { output->write(run); }), "");
    run.now = 2;
    EXPECT_SAYS(error_of([&] { output->write(run); }), file + ": No space left on device");
    EXPECT_EQ(error_of([&] { output->flush(); }), "");
    EXPECT_EQ(text_of(list), before);
}

INSTANTIATE_TEST_SUITE_P(OutputsOfParticles, WritingInBackground, testing::Values("vtk", "csv"));

}  // namespace
}  // namespace matpoint
