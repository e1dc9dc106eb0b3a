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

// Frames of the shortest constant range that counts: a period of the carrier, 16 at least.
std::int64_t least_still_frames(double f0_hz, double rate_hz);

// Whether no channel moves over so many frames.
bool stand_still(std::span<const double> c, std::span<const double> d, std::int64_t frames);

// Finds the zeros or repeated samples that a recorder or a decoder has put in place of lost ones,
// in one pass: constant ranges, but for the silence before the wave, from the first frame on; and
// shorter ones, frames that repeat the one before, or are zero in both channels, and lie off the
// sinusoid through their neighbours.
class FillCheck {
public:
    FillCheck(double f0_hz, double rate_hz);

    // Adds the next frames of both channels, one at least, in order.
    void add(std::int64_t first_frame, std::span<const double> c, std::span<const double> d);
    // Ends the check: the constant ranges, in order, at most ClippingCheck::most_places.
    std::vector<FrameRange> finish();

    // Of all constant ranges but for the silence.
    std::int64_t still_places() const { return still_places_; }
    std::int64_t still_frames() const { return still_frames_; }
    // Shorter fills, and the frame of the first.
    std::int64_t short_fills() const { return short_fills_; }
    std::int64_t first_short() const { return first_short_; }

    // Samples of a channel in constant ranges and the silence, which do not count for the offset.
    struct Sums {
        double sum = 0;
        double squares = 0;
        std::int64_t count = 0;
    };
    const std::array<Sums, 2>& held() const { return held_; }

private:
    void close();
    // `low`, `high`: values of x, the larger channel.
    void add_short(std::int64_t first_frame, std::span<const double> x, std::span<const double> y,
                   double low, double high);

    std::int64_t least_still_;
    double cos_w_;  // of the carrier from sample to sample
    std::array<double, 2> last_{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN()};  // samples
    std::int64_t opening_ = -1;                                             // the first frame
    FrameRange unmoved_;  // the frames before the next that are like the last
    std::vector<FrameRange> still_;
    std::int64_t still_places_ = 0;
    std::int64_t still_frames_ = 0;
    std::int64_t short_fills_ = 0;
    std::int64_t first_short_ = -1;
    std::array<Sums, 2> held_;
};

}  // namespace vybeg
