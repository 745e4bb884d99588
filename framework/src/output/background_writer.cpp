#include <matpoint/background_writer.hpp>

#include <pthread.h>

#include <algorithm>
#include <ctime>
#include <mutex>
#include <utility>
#include <vector>

namespace matpoint {

namespace {

std::mutex clocks_mutex;              // of the two below
double seconds_of_ended_jobs = 0;     // processor time
std::vector<clockid_t> jobs_at_work;  // the clocks of their threads

double seconds_on(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Counts the processor time of the thread that it lives on.
class JobClock {
  public:
    JobClock() {
        pthread_getcpuclockid(pthread_self(), &clock_);
        const std::lock_guard lock(clocks_mutex);
        jobs_at_work.push_back(clock_);
    }
    ~JobClock() {
        const std::lock_guard lock(clocks_mutex);
        seconds_of_ended_jobs += seconds_on(clock_);
        jobs_at_work.erase(std::find(jobs_at_work.begin(), jobs_at_work.end(), clock_));
    }
    JobClock(const JobClock&) = delete;
    JobClock& operator=(const JobClock&) = delete;

  private:
    clockid_t clock_{};
};

}  // namespace

void BackgroundWriter::submit(std::function<void()> job) {
    wait();
    job_ = std::async(std::launch::async, [given = std::move(job)]() mutable {
        const JobClock clock;
        // The future keeps what was given until somebody waits: what the job carries goes when it is done.
        const std::function<void()> work = std::exchange(given, nullptr);
        work();
    });
}

void BackgroundWriter::wait() {
    if (job_.valid()) job_.get();
}

double background_cpu_seconds() {
    const std::lock_guard lock(clocks_mutex);
    double sum = seconds_of_ended_jobs;
    for (const clockid_t clock : jobs_at_work) sum += seconds_on(clock);
    return sum;
}

}  // namespace matpoint
