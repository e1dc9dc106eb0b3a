#pragma once

#include "core/base/guarded.h"
#include "core/recording/checks/recording_check.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <memory>

namespace vybeg {

// The source itself, whose frames a check sees the first time they are read: what an analysis reads
// anyway is looked through on the way. Frames that are never read, or read before others that
// follow them, are not looked at.
class CheckedSource final : public SampleSource {
public:
    CheckedSource(std::shared_ptr<const SampleSource> source, std::shared_ptr<FaultCheck> check);

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }
    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override;

private:
    std::shared_ptr<const SampleSource> source_;
    struct Watch {
        std::shared_ptr<FaultCheck> check;
        std::int64_t next = 0;  // frame that the check has not seen
    };
    Guarded<Watch> watch_;
};

}  // namespace vybeg
