#include "study/progress.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace matpoint {

void StudyProgress::show(std::size_t measured, std::size_t left, int running) {
    const Clock::time_point now = Clock::now();
    if (!shown_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(200);
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const std::string eta = measured == 0
                                ? ""
                                : fmt::format("  ETA {:.0f} s", elapsed / static_cast<double>(measured) *
                                                                    static_cast<double>(left));
    // A terminal that was closed must not end the study as fmt::print would.
    const std::string line = fmt::format("\r\033[K{} of {} done  {} running  {:.0f} s{}", total_ - left,
                                         total_, running, elapsed, eta);
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
    drawn_ = true;
}

StudyProgress::~StudyProgress() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

}  // namespace matpoint
