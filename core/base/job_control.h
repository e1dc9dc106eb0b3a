#pragma once

#include <functional>
#include <stop_token>

namespace vybeg {

// How a long computation hears that it should stop and tells how far it has come.
// `progress` takes 0..1 and may be called from any thread, never from two at once.
class JobControl {
public:
    JobControl() = default;
    explicit JobControl(std::stop_token stop, std::function<void(double)> progress = {})
        : stop_(std::move(stop)), progress_(std::move(progress)) {}

    bool cancelled() const { return stop_.stop_requested(); }
    void report(double fraction) const {
        if (progress_) {
            progress_(fraction);
        }
    }

private:
    std::stop_token stop_;
    std::function<void(double)> progress_;
};

}  // namespace vybeg
