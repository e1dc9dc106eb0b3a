#pragma once

#include <cstdint>

namespace vybeg {

// Position of windows: `count` windows of `length` samples, window k from sample first + k hop.
struct WindowPlan {
    std::int64_t first = 0;
    std::int64_t length = 0;
    std::int64_t hop = 0;
    std::int64_t count = 0;

    std::int64_t start(std::int64_t window) const { return first + window * hop; }
    // Time of a window's centre from the start of the recording, s.
    double centre_s(std::int64_t window, double rate_hz) const {
        return (static_cast<double>(start(window)) + 0.5 * static_cast<double>(length - 1)) /
               rate_hz;
    }
    // Fraction of a window's samples that the next one does not share.
    double independent() const {
        return hop < length ? static_cast<double>(hop) / static_cast<double>(length) : 1.0;
    }

    friend bool operator==(const WindowPlan&, const WindowPlan&) = default;
};

// Frames that are read and estimated at once: 1 MiB of samples, which stays in the processor's
// cache on its way, and about a millisecond of work between two looks at the stop token.
inline constexpr std::int64_t chunk_frames = std::int64_t{1} << 16;

// All windows that fit into the frames [first, end). Precondition: length >= 1, hop >= 1.
WindowPlan plan_windows(std::int64_t first, std::int64_t end, std::int64_t length,
                        std::int64_t hop);

// |<cos 2wt>| over n centred samples at the given frequency: |sin(n w dt) / (n sin(w dt))|, the
// Dirichlet kernel of METHOD section 3, in [0, 1].
double orthogonality_residual(std::int64_t n, double f_hz, double rate_hz);

// Window length of smallest residual within half a period of `n`, samples, at least least_window()
// (METHOD section 3).
std::int64_t snap_window(std::int64_t n, double f_hz, double rate_hz);

// Shortest window accepted, samples: 5 samples and three quarters of a period of the carrier and of
// its distance from half the sample rate. Five parameters need 5 samples of two channels. The
// article's "one period" of 6 samples is 0.95 of a period at 5300 Hz; below about half a period cos
// and sin cannot be distinguished. The same applies near half the rate, where the sampled carrier
// is the image of one at rate/2 - f.
std::int64_t least_window(double f_hz, double rate_hz);

// Number of samples nearest to a number of periods of the carrier.
std::int64_t window_of_periods(double periods, double f_hz, double rate_hz);

}  // namespace vybeg
