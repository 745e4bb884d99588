#pragma once

#include <array>
#include <csignal>

namespace matpoint {

/// While it lives, SIGINT, SIGTERM, SIGHUP and SIGXCPU (processor time is running out) are noted rather than
/// fatal. A second SIGINT or SIGTERM is fatal again. SIGHUP stays ignored if it is (nohup).
class SignalGuard {
  public:
    SignalGuard();
    ~SignalGuard();
    SignalGuard(const SignalGuard&) = delete;
    SignalGuard& operator=(const SignalGuard&) = delete;

  private:
    static constexpr std::array<int, 4> noted{SIGINT, SIGTERM, SIGHUP, SIGXCPU};
    std::array<struct sigaction, 4> old_{};
};

/// Whether one has come since the guard was made.
bool signals_received();

}  // namespace matpoint
