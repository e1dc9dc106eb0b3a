#include "app/cli_interrupt.h"

#include "app/process_guard.h"

#include <csignal>
#include <pthread.h>

namespace vybeg::cli {
namespace {

constexpr int end_of_waiting = SIGUSR1;

sigset_t awaited_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, end_of_waiting}) {
        sigaddset(&signals, signal);
    }
    struct sigaction hang_up {};
    sigaction(SIGHUP, nullptr, &hang_up);
    if (hang_up.sa_handler != SIG_IGN) {  // nohup asks to outlive the terminal
        sigaddset(&signals, SIGHUP);
    }
    return signals;
}

}  // namespace

InterruptGuard::InterruptGuard() {
    make_write_signals_errors();
    const sigset_t signals = awaited_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    waiter_ = std::thread([this, signals] {
        int signal = 0;
        sigwait(&signals, &signal);
        if (signal != end_of_waiting) {
            source_.request_stop();
        }
    });
}

InterruptGuard::~InterruptGuard() {
    // Where the waiter has ended already, its thread still waits to be joined and takes the signal.
    pthread_kill(waiter_.native_handle(), end_of_waiting);
    waiter_.join();
}

}  // namespace vybeg::cli
