#pragma once

#include "core/base/diagnostic.h"
#include "core/base/guarded.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/checks/clipping_check.h"
#include "core/recording/checks/lost_samples_check.h"
#include "core/recording/samples/sample_source.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Faults of the samples in the file, before calibration and filter.
struct SampleFaults {
    std::vector<Diagnostic> findings;  // missing samples, clipping, lost and doubled samples
    std::vector<FrameRange> clipped;   // ranges at a rail in either channel, in order
    std::vector<PhaseStep> steps;      // lost and doubled samples, in order
};

// Finds missing samples, clipping and lost samples in one pass.
class FaultCheck {
public:
    // Without a carrier it does not search for lost samples.
    FaultCheck(std::optional<double> f0_hz, double rate_hz);

    // Adds the next frames, in order.
    void add(std::int64_t first_frame, std::span<const double> c, std::span<const double> d);
    // Ends the check.
    SampleFaults finish();
    // Channels with a mean above 0.5 % of the amplitude so far.
    std::vector<Diagnostic> offsets() const;

private:
    struct ChannelSums {
        double sum = 0;
        double squares = 0;
        std::int64_t valid = 0;

        void add(std::span<const double> x);
        double mean() const;
    };

    void add_portion(std::int64_t first_frame, std::span<const double> c,
                     std::span<const double> d);

    double rate_hz_;
    std::array<ChannelSums, 2> sums_;
    std::int64_t missing_ = 0;  // samples of both channels
    std::int64_t frames_with_missing_ = 0;
    std::int64_t first_missing_ = -1;
    std::array<ClippingCheck, 2> clipping_;
    std::optional<PhaseStepCheck> steps_;
};

// Finds the faults only. Reads the source once, front to back. Errors: those of the source,
// interrupted.
Result<SampleFaults> find_faults(const SampleSource& source, double rate_hz,
                                 std::optional<double> f0_hz, const JobControl& job);

// Findings of the first four seconds: lines of the mains, and a start with another decay than the
// rest. Errors: those of the source.
Result<std::vector<Diagnostic>> start_findings(const SampleSource& source, double rate_hz,
                                               std::optional<double> f0_hz);

// Recording check (METHOD section 7): faults of the samples, offsets above 0.5 % of the amplitude,
// lines of the mains and a start with another decay than the rest. Reads the source once, front to
// back; repairs nothing. Errors: those of the source, interrupted.
Result<SampleFaults> check_recording(const SampleSource& source, double rate_hz,
                                     std::optional<double> f0_hz, const JobControl& job);

// Adds findings to diagnostics, but for missing samples of which these tell already.
void add_findings(const std::vector<Diagnostic>& findings, std::vector<Diagnostic>& diagnostics);

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
