#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// A place where samples were lost (or doubled): both channels' phase jumps at once.
struct PhaseStep {
    std::int64_t frame = 0;  // to within phase_step_block frames
    double angle = 0;        // rad, in (-pi, pi]
    int lost = 0;            // samples that explain the angle: positive lost, negative doubled
};

inline constexpr std::int64_t phase_step_block = 32;

// Finds phase steps common to both channels, as the samples come by: one lost sample of a 5300 Hz
// carrier at 33333 Hz is a step of 57 degrees. The phase is followed by demodulation at the carrier
// in blocks of 32 frames; a step is reported where the phase moves between the block before and the
// block after by more than 0.25 rad and eight times the scatter around it. Blocks with missing
// samples are left out.
class PhaseStepCheck {
public:
    PhaseStepCheck(double f0_hz, double rate_hz);

    // The next frames, in order, of both channels.
    void add(std::int64_t first_frame, std::span<const double> c, std::span<const double> d);
    // Everything found; ends the check.
    std::vector<PhaseStep> finish();

private:
    struct Block {
        std::int64_t first_frame = 0;
        std::complex<double> c;
        std::complex<double> d;
        bool missing = false;
    };

    void close_block();
    void evaluate(std::size_t blocks);

    double w_;  // carrier, radians per sample
    std::complex<double> step_;
    std::complex<double> rotation_;
    std::optional<Block> open_;
    std::int64_t in_block_ = 0;
    std::vector<Block> blocks_;  // a segment, and the two before it
    std::vector<PhaseStep> found_;
};

}  // namespace vybeg
