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
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &old_interrupt_);
    sigaction(SIGTERM, &action, &old_terminate_);
}

SignalGuard::~SignalGuard() {
    sigaction(SIGINT, &old_interrupt_, nullptr);
    sigaction(SIGTERM, &old_terminate_, nullptr);
}

bool signals_received() {
    return received != 0;
}

}  // namespace matpoint
