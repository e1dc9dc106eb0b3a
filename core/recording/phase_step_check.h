#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// A place where samples were lost (or doubled): both channels' phase jumps at once.
struct PhaseStep {
    std::int64_t frame = 0;  // the first one after the step
    double angle = 0;        // rad, in (-pi, pi]
    int lost = 0;            // samples that explain the angle: positive lost, negative doubled
};

// Finds phase steps common to both channels, as the samples come by: one lost sample of a 5300 Hz
// carrier at 33333 Hz is a step of 57 degrees. The phase is followed by demodulation at the carrier
// in blocks of 32 frames; a step is where the phase moves between the block before and the block
// after by more than 0.25 rad and eight times the scatter around it. Its frame is then the one at
// which the wave of the blocks before, run on, and that of the blocks after, run back, change over
// with the least squares; what these two waves do not explain (the node of a beat, noise, a strike)
// is no step. Blocks with missing samples are left out.
class PhaseStepCheck {
public:
    PhaseStepCheck(double f0_hz, double rate_hz);

    // The next frames, in order, of both channels. Where frames were passed over, what comes is
    // looked at by itself.
    void add(std::int64_t first_frame, std::span<const double> c, std::span<const double> d);
    // Everything found; ends the check.
    std::vector<PhaseStep> finish();

private:
    struct Block {
        std::complex<double> c;
        std::complex<double> d;
        bool missing = false;
    };

    void close_block();
    void evaluate();
    std::optional<PhaseStep> placed(std::size_t block) const;
    void forget_all();

    double w_;                                 // carrier, radians per sample
    std::vector<std::complex<double>> basis_;  // of one block
    std::int64_t first_frame_ = 0;             // of c_ and d_
    std::vector<double> c_;                    // a segment, and the last blocks of the one before
    std::vector<double> d_;
    std::vector<Block> blocks_;
    std::vector<PhaseStep> found_;
};

}  // namespace vybeg
