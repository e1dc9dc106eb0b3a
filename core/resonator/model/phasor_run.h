#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace vybeg {

// The quantity that is unknown after an instant relative to that before.
enum class BreakKind {
    phase,  // of both channels: samples are lost or doubled
    gain,   // of each channel: an amplifier changes its range
    start,  // the wave itself: a knock
    event,  // nothing: only the windows around the instant are disturbed
};

// Number of the parameters of a break.
constexpr int break_size(BreakKind kind) {
    constexpr int sizes[]{1, 2, 4, 0};
    return sizes[static_cast<int>(kind)];
}

struct RunBreak {
    double time_s = 0;
    BreakKind kind = BreakKind::phase;
};

// Data of one recording for the fit of a resonator: its phasors z = (c, d) of METHOD section 1,
// averaged over windows of one length, relative to one fixed reference frequency:
//     C(t) = Re(c e^{2 pi i f_ref t}), t in seconds from the start of the recording.
// Windows with gaps or faults are excluded; the others are in the order of time and do not overlap,
// but need not be evenly spaced. Beat and offset from f_ref must turn by less than half a turn from
// one window to the next. Some hundred to some thousand windows are enough.
struct PhasorRun {
    double f_ref_hz = 0;
    double window_s = 0;
    std::vector<double> time_s;           // centres of the windows
    std::vector<std::complex<double>> c;  // recording units
    std::vector<std::complex<double>> d;
    std::vector<double> sd;  // of the real and of the imaginary part of c and of d
    // Correlation of the noise of windows 0, 1, 2, ... windows apart; empty for white noise.
    std::vector<double> noise_correlation{};
    std::vector<RunBreak> breaks{};  // in the order of time
    double rate_hz = 0;              // of the recording's samples; 0: unknown
    // Twice the angle of the first electrode, which is subtracted: (c, d) are the channels turned
    // by it, and errors of the channels are those of the channels turned back.
    double two_theta_zero = 0;
    // The phase common to c and d is unknown in each window: it says nothing, nor does f_ref.
    bool phase_lost = false;

    // z_j^H z_k: its angle is the phase from window j to window k.
    std::complex<double> product(std::size_t j, std::size_t k) const {
        return std::conj(c[j]) * c[k] + std::conj(d[j]) * d[k];
    }
    // |z|^2 of a window.
    double power(std::size_t window) const { return std::norm(c[window]) + std::norm(d[window]); }
};

// Covariance of the sums of `count` windows each, `lag` of those sums apart, in units of a window's
// variance. `correlation`: of windows 0, 1, 2, ... windows apart.
inline double covariance_of_sums(const std::vector<double>& correlation, std::ptrdiff_t count,
                                 std::ptrdiff_t lag) {
    double sum = 0;
    for (std::ptrdiff_t difference = 1 - count; difference < count; ++difference) {
        const auto at = static_cast<std::size_t>(std::abs(lag * count + difference));
        sum += at < correlation.size()
                   ? static_cast<double>(count - std::abs(difference)) * correlation[at]
                   : 0;
    }
    return sum;
}

// Turns (c, d) into channels whose first electrode is at the angle of which this is the double.
template <class Value>
void turn_channels(double two_theta_zero, Value& c, Value& d) {
    const Value old = c;
    const double cosine = std::cos(two_theta_zero);
    const double sine = std::sin(two_theta_zero);
    c = cosine * old + sine * d;
    d = cosine * d - sine * old;
}

// The run with only those windows for which keep(index) is true.
template <class Keep>
PhasorRun kept_windows(const PhasorRun& run, const Keep& keep) {
    PhasorRun kept = run;
    kept.time_s.clear();
    kept.c.clear();
    kept.d.clear();
    kept.sd.clear();
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        if (keep(k)) {
            kept.time_s.push_back(run.time_s[k]);
            kept.c.push_back(run.c[k]);
            kept.d.push_back(run.d[k]);
            kept.sd.push_back(run.sd[k]);
        }
    }
    return kept;
}

// That with the windows from `first` up to `end`.
inline PhasorRun kept_windows(const PhasorRun& run, std::size_t first, std::size_t end) {
    return kept_windows(run, [=](std::size_t k) { return k >= first && k < end; });
}

}  // namespace vybeg
