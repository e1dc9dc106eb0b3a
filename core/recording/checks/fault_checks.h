#pragma once

#include "core/recording/checks/step_evidence.h"
#include "core/recording/times/uniform_times.h"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace vybeg {

// Finds the samples of one channel at the rail of the converter, in one pass.
//
// Criterion of a rail: the extreme value occurs repeatedly, in clusters, and far more often than
// the levels inward. A clean sinusoid also repeats its top level, but then the next level occurs
// nearly half as often, and the top m levels together sqrt(m) times.
class ClippingCheck {
public:
    // Adds the next samples, in order; first_frame is the frame of x[0]. NaN is ignored.
    void add(std::int64_t first_frame, std::span<const double> x);

    // Whether samples between these values only need counting, without a test of each.
    bool are_inside(double lowest, double highest) const;
    void pass_over(std::size_t count) { count_ += static_cast<std::int64_t>(count); }

    struct Rail {
        double level = 0;
        std::int64_t count = 0;
        std::vector<FrameRange> places;  // in order; neighbours are merged beyond `most_places`
    };
    // Detected rails, none to two: the upper, the lower.
    std::vector<Rail> rails() const;

    // Number of levels of the channel: 1 (constant), 2, or 3 for more; 0 without a sample. One or
    // two are no rail: the signal is below one bit of the converter.
    int levels() const;

    static constexpr std::size_t most_places = 1 << 16;

private:
    // Extreme of one side, as a maximum.
    struct Extreme {
        struct Level {
            double value = std::numeric_limits<double>::lowest();
            std::int64_t count = 0;
        };
        double level = std::numeric_limits<double>::lowest();
        std::int64_t count = 0;
        std::array<Level, 15> below;  // the highest levels below, falling
        std::int64_t last_frame = 0;
        std::int64_t neighbours = 0;  // occurrences soon after the previous one
        std::int64_t common = 0;      // divisor of all distances between occurrences
        std::vector<FrameRange> places;
        std::int64_t drawn_together = 0;  // frames between merged places

        void add(std::int64_t frame, double value);
        void add_below(const Level& more);
        void draw_together();
        bool is_rail() const;
        // Below it a sample changes nothing.
        double least() const { return below.back().value; }
    };

    std::int64_t count_ = 0;  // finite samples
    Extreme upper_;
    Extreme lower_;  // of the negated samples
};

// Finds phase steps common to both channels, in one pass: one lost sample of a 5300 Hz carrier at
// 33333 Hz is a step of 57 degrees.
//
// Two criteria raise a suspicion, in blocks of 32 to 48 frames, two periods at least. (1) The phase
// of the carrier, demodulated in blocks, changes between the block before and the block after by
// more than 0.25 rad and eight times the scatter around it. (2) Where that scatter hides a step
// (neighbouring modes, noise), the error of a linear prediction of the samples exceeds that of the
// other blocks, which no sum of decaying modes causes. A suspicion is confirmed only if
// judge_step() finds a number of lost or doubled samples with which every strong line is
// continuous, while it is not without. Blocks with missing samples are ignored.
class PhaseStepCheck {
public:
    PhaseStepCheck(double f0_hz, double rate_hz);

    // Adds the next frames of both channels, in order. After a gap in the frames the check starts
    // anew.
    void add(std::int64_t first_frame, std::span<const double> c, std::span<const double> d);
    // All steps found; ends the check.
    std::vector<PhaseStep> finish();

private:
    struct Block {
        std::complex<double> c;
        std::complex<double> d;
        bool missing = false;
    };
    // Blocks [first, last] in whose neighbourhood a step is suspected; size relative to the
    // threshold.
    struct Suspect {
        std::size_t first = 0;
        std::size_t last = 0;
        double size = 0;
    };

    void close_block();
    void evaluate(bool is_end);
    std::vector<Suspect> moving_phases(double& threshold) const;
    std::vector<Suspect> unforeseen_blocks() const;
    static void draw_together(std::vector<Suspect>& suspects);
    void judge(const std::vector<Suspect>& suspects, std::size_t suspect);

    double w_;  // carrier, radians per sample
    std::size_t block_frames_;
    std::size_t reach_blocks_;                 // used on each side of a suspicion
    std::size_t segment_frames_;               // and those around it that the next segment repeats
    std::vector<std::complex<double>> basis_;  // of one block
    std::int64_t first_frame_ = 0;             // of c_ and d_
    std::size_t first_block_ = 0;              // not judged yet
    std::vector<double> c_;                    // a segment, and the last blocks of the one before
    std::vector<double> d_;
    std::vector<Block> blocks_;
    std::vector<PhaseStep> found_;
};

}  // namespace vybeg
