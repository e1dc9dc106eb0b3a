#pragma once

#include <stop_token>
#include <thread>

namespace vybeg::cli {

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
