#pragma once

#include "core/base/result.h"

#include <stop_token>
#include <thread>

namespace vybeg::cli {

// What both programs do around their work, so that whatever happens has a sentence and a status.

// Puts something that refuses to be written to (or, for standard input, read from) in the place of
// standard descriptors that are closed: else the next file that is opened takes the number, and
// warnings land in it. To be called before anything is opened.
void open_missing_descriptors();

// SIGPIPE and SIGXFSZ become errors of write().
void make_write_signals_errors();

// Whether the stack of the process and of its threads is large enough (ulimit -s): setting_invalid.
// A smaller one ends the program by a signal in the midst of its work.
Status check_stack();

// Where such an exception meets no handler: its sentence and exit status instead of an abort.
void end_with_a_sentence();

// Turns SIGINT, SIGTERM and SIGHUP into a stop request. The signals are blocked in every thread
// and fetched by one that waits for nothing else, so that no code runs inside a signal handler.
// To be made before any other thread. SIGPIPE and SIGXFSZ (a full disk by quota) become errors of
// write(), which cleans up after itself.
class InterruptGuard {
public:
    InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    ~InterruptGuard();

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::thread waiter_;
};

}  // namespace vybeg::cli
