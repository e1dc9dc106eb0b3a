#pragma once

#include "core/recording/checks/recording_check.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>
#include <mutex>

namespace vybeg {

// The source itself, whose frames a check sees the first time they are read: what an analysis reads
// anyway is looked through on the way. Frames that are never read, or read before others that
// follow them, are not looked at.
class WatchedSource final : public SampleSource {
public:
    WatchedSource(std::shared_ptr<const SampleSource> source, std::shared_ptr<FaultCheck> check);

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override;

private:
    std::shared_ptr<const SampleSource> source_;
    std::shared_ptr<FaultCheck> check_;
    mutable std::mutex mutex_;  // for what follows, and what check_ points to
    mutable std::int64_t next_ = 0;
};

}  // namespace vybeg
