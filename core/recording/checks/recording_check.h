#pragma once

#include "core/base/diagnostic.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/checks/fault_checks.h"
#include "core/recording/samples/sample_source.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Findings of the first seconds of a recording besides the wave (METHOD section 7).

// Supplies whose lines are looked for: the mains, and an aircraft's.
inline constexpr std::array<double, 3> supplies_hz{50, 60, 400};

struct MainsLine {
    double f_hz = 0;
    double ratio = 0;  // its amplitude relative to the largest line above 200 Hz, the carrier, the
                       // powers of both channels summed
};

// Lines at 50, 100, 150, 60, 120, 180 and, of an aircraft's supply, 400 and 800 Hz in up to four
// seconds of samples, eight times above the median around them and above 1e-3 of the carrier; those
// above 200 Hz at least 20 Hz from it. A missing sample counts as zero. Empty if the samples are
// too short for a resolution of 5 Hz.
std::vector<MainsLine> mains_lines(std::span<const double> c, std::span<const double> d,
                                   double rate_hz);

// Faults of the samples in the file, before calibration and filter.
struct SampleFaults {
    std::vector<Diagnostic> findings;  // channels without a signal of their own, missing samples,
                                       // clipping, constant ranges, lost and doubled
                                       // samples
    std::vector<FrameRange> clipped;   // ranges at a rail in either channel, in order
    std::vector<FrameRange> still;     // ranges in which no channel moves, in order
    std::vector<PhaseStep> steps;      // lost and doubled samples, in order
};

// Finds missing, clipped, lost and filled samples in one pass.
class FaultCheck {
public:
    // Without a carrier it does not search for lost or still samples.
    FaultCheck(std::optional<double> f0_hz, double rate_hz);

    // Adds the next frames, in order.
    void add(std::int64_t first_frame, std::span<const double> c, std::span<const double> d);
    // Ends the check.
    SampleFaults finish();
    // Variance of the samples so far, of both channels; zero where that is rounding.
    double power() const;
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

    void report_fills(FillCheck& fills, SampleFaults& faults) const;
    // The sums without constant ranges.
    std::array<ChannelSums, 2> moving() const;

    double rate_hz_;
    std::array<ChannelSums, 2> sums_;
    std::int64_t missing_ = 0;  // samples of both channels
    std::int64_t frames_with_missing_ = 0;
    std::int64_t first_missing_ = -1;
    std::array<ClippingCheck, 2> clipping_;
    bool alike_ = true;  // channels, sample by sample
    std::optional<FillCheck> fills_;
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

// Adds findings to diagnostics, but for missing samples that are already among these.
void add_findings(const std::vector<Diagnostic>& findings, std::vector<Diagnostic>& diagnostics);

// The source itself, whose frames a check sees the first time they are read: what an analysis reads
// anyway is looked through on the way. Frames that are never read, or read before others that
// follow them, are not looked at.
std::shared_ptr<const SampleSource> checked_source(std::shared_ptr<const SampleSource> source,
                                                   std::shared_ptr<FaultCheck> check);

}  // namespace vybeg
