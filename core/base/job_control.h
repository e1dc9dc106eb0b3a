#pragma once

#include "core/base/result.h"

#include <functional>
#include <stop_token>

namespace vybeg {

// How a long computation learns that it should stop and reports its progress.
// `progress` takes 0..1 and may be called from any thread, never from two at once. `clock` lends
// the caller's monotonic clock, in seconds: core has none of its own, and only reports with it
// where the time went; without one every duration is zero.
class JobControl {
public:
    JobControl() = default;
    explicit JobControl(std::stop_token stop, std::function<void(double)> progress = {},
                        std::function<double()> clock = {})
        : stop_(std::move(stop)), progress_(std::move(progress)), clock_(std::move(clock)) {}

    bool cancelled() const { return stop_.stop_requested(); }
    // interrupted once it is to stop.
    Status go_on() const {
        return cancelled() ? Status(Error{ErrorCode::interrupted, {}, {}}) : Status();
    }
    void report(double fraction) const {
        if (progress_) {
            progress_(fraction);
        }
    }

    std::stop_token stop_token() const { return stop_; }

    // The same job for a part of it that has no progress of its own.
    JobControl silent() const { return JobControl(stop_, {}, clock_); }

    // The same job, with its progress reported to another function.
    JobControl with_progress(std::function<void(double)> progress) const {
        return JobControl(stop_, std::move(progress), clock_);
    }

    double now() const { return clock_ ? clock_() : 0; }

private:
    std::stop_token stop_;
    std::function<void(double)> progress_;
    std::function<double()> clock_;
};

}  // namespace vybeg
