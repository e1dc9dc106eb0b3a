#include "app/cli_interrupt.h"

#include "app/process_guard.h"

#include <csignal>
#include <pthread.h>

namespace vybeg::cli {
namespace {

constexpr int end_of_waiting = SIGUSR1;

sigset_t awaited_signals() {
    sigset_t awaited;
    sigemptyset(&awaited);
    for (const int signal : {SIGINT, SIGTERM, end_of_waiting}) {
        sigaddset(&awaited, signal);
    }
    struct sigaction hang_up {};
    sigaction(SIGHUP, nullptr, &hang_up);
    if (hang_up.sa_handler != SIG_IGN) {  // nohup asks to outlive the terminal
        sigaddset(&awaited, SIGHUP);
    }
    return awaited;
}

}  // namespace

InterruptGuard::InterruptGuard() {
    make_write_signals_errors();
    const sigset_t awaited = awaited_signals();
    pthread_sigmask(SIG_BLOCK, &awaited, nullptr);
    waiter_ = std::thread([this, awaited] {
        int signal = 0;
        sigwait(&awaited, &signal);
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
