#include "app/process_guard.h"

#include "core/base/error.h"
#include "core/base/read_value.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <pthread.h>
#include <string_view>
#include <sys/resource.h>
#include <unistd.h>

namespace vybeg::cli {
namespace {

void say(std::string_view text) {
    // Nothing can be done about a standard error that takes no more.
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

[[noreturn]] void on_terminate() {
    ErrorCode code = ErrorCode::out_of_memory;
    if (const auto exception = std::current_exception()) {
        code = error_of(exception).code;
    }
    if (code == ErrorCode::program_fault) {
        std::abort();  // its core file says more than a sentence
    }
    say(program_invocation_short_name);
    say(": ");
    pass_sentence(message_row(code).sentence, false, say);
    say("\n");
    std::_Exit(exit_status(code));
}

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

void open_missing_descriptors() {
    const std::array modes{O_WRONLY, O_RDONLY, O_RDONLY};
    for (int descriptor = 0; descriptor < 3; ++descriptor) {
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
            // The lowest free number is this one: those below it are open.
            open("/dev/null", modes[static_cast<std::size_t>(descriptor)]);
        }
    }
}

void make_write_signals_errors() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

Status check_stack() {
    constexpr rlim_t least_kb = 512;  // an analysis takes up to 200 kB
    rlimit stack{};
    if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= least_kb << 10) {
        return {};
    }
    const auto kb = [](rlim_t count) { return count_arg(static_cast<std::int64_t>(count)); };
    return refused_value(Phrase::tr("the limit of the stack (ulimit -s)"),
                         Phrase::tr("%1 kB", {kb(stack.rlim_cur >> 10)}),
                         Phrase::tr("the program needs %1 kB or more", {kb(least_kb)}));
}

void end_with_a_sentence() {
    std::set_terminate(on_terminate);
}

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
