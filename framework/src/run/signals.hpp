#pragma once

#include <csignal>

namespace matpoint {

/// While it lives, SIGINT and SIGTERM are noted rather than fatal; a second one is fatal again.
class SignalGuard {
  public:
    SignalGuard();
    ~SignalGuard();
    SignalGuard(const SignalGuard&) = delete;
    SignalGuard& operator=(const SignalGuard&) = delete;

  private:
    struct sigaction old_interrupt_ {
    }, old_terminate_{};
};

/// Whether one has come since the guard was made.
bool signals_received();

}  // namespace matpoint
