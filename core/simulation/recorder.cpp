#include "core/simulation/recorder.h"

#include <cstdlib>
#include <utility>

namespace vybeg {

void Recorder::record(std::vector<double>& samples) {
    if (next_ == lost_.size()) {
        return;
    }
    passed_.clear();
    for (const double sample : samples) {
        const std::int64_t frame = frame_++;
        const bool inside = next_ < lost_.size() && frame >= lost_[next_].frame;
        if (!inside) {
            passed_.push_back(sample);
            continue;
        }
        const LostSamples& fault = lost_[next_];
        if (fault.count < 0) {
            passed_.push_back(sample);
            twice_.push_back(sample);
        }
        if (frame + 1 == fault.frame + std::abs(fault.count)) {
            passed_.insert(passed_.end(), twice_.begin(), twice_.end());
            twice_.clear();
            ++next_;
        }
    }
    std::swap(samples, passed_);
}

}  // namespace vybeg
