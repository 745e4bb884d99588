#include "run/signals.hpp"

namespace matpoint {

namespace {
volatile std::sig_atomic_t received = 0;
}

extern "C" {
static void note_signal(int) {
    received = 1;
}
}

SignalGuard::SignalGuard() {
    received = 0;
    for (std::size_t i = 0; i < noted.size(); ++i) {
        struct sigaction action {};
        action.sa_handler = note_signal;
        // The others come more than once: a terminal that is closed says so by itself and by its shell.
        if (noted[i] == SIGINT || noted[i] == SIGTERM) action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(noted[i], nullptr, &old_[i]);
        if (old_[i].sa_handler != SIG_IGN || noted[i] != SIGHUP) sigaction(noted[i], &action, nullptr);
    }
}

SignalGuard::~SignalGuard() {
    for (std::size_t i = 0; i < noted.size(); ++i) sigaction(noted[i], &old_[i], nullptr);
}

bool signals_received() {
    return received != 0;
}

}  // namespace matpoint
