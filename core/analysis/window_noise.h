#pragma once

#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/estimators/wave/estimator.h"
#include "core/recording/samples/sample_source.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Length of the short windows that measure the noise of a recording: twelve times the least, about
// nine periods of the carrier, too short for a wave to move in.
std::int64_t noise_window(std::int64_t length, double f0_hz, double rate_hz);

// The noise about a stretch of a recording, and which of its windows hold no steady wave.
//
// Such a window leaves a residual, but the residual alone does not show it: noise, hum and offset
// leave one too. Short windows of the same samples leave those and not the motion, and thus
// show events and a motion that all long windows share. Windows too short to hold others
// are compared with each other: what all of them have alike is no event.
class NoiseLevel {
public:
    // Known noise of windows of noise_window() samples and of the whole band, after a
    // band-pass.
    struct Known {
        EquivalentNoise of_short;
        EquivalentNoise of_long;
        double in_band = 0;  // noise of a sample, sd
        double share = 1;    // of the band in the spectrum, independent samples in one
    };
    // Measures of one window.
    struct Judged {
        double variance = 0;  // of its steady noise
        double apart = 0;     // apart()
    };
    // Windows of `length` samples.
    NoiseLevel(std::int64_t length, double f0_hz, double rate_hz, std::optional<Known> known);

    std::int64_t short_length() const { return short_; }
    // Estimates short windows, one for each place, every `hop` frames from frame `first` of the
    // stretch on; returns the centre of the first, s.
    using EstimateShorts =
        std::function<double(std::int64_t first, std::int64_t hop, std::span<WaveEstimate> into)>;
    // Measures a stretch of `windows` windows every `hop` frames, by short ones.
    void measure(std::int64_t windows, std::int64_t hop, const EstimateShorts& estimate);

    // In windows below three periods offset and hum are not orthogonal to the wave, and errors
    // exceed the deviations. Factor of the variances, at least 1: of the fourth differences in the
    // runs, to which no motion of a wave contributes over so few periods.
    double excess() const { return excess_; }
    // Mean squared distance of the short window at the window's centre from the window's best wave,
    // by its variance: a linear motion has its mean there. NaN for none.
    double apart(const WaveEstimate& window, double centre_s) const;
    // A flag a window of the stretch: whether its residual is far above the level or its short
    // window far from its wave; all of them where they together lie apart from their short windows,
    // a motion that all share and none shows by itself.
    std::vector<char> hold_no_wave(std::span<const Judged> windows) const;

private:
    struct Short {
        double centre_s;
        Phasors phasors;
    };
    // Whether the windows hold short ones.
    bool has_shorts() const { return length_ >= 2 * short_; }
    std::vector<WaveEstimate> in_runs(std::int64_t frames, const EstimateShorts& estimate) const;
    bool all_move(std::span<const Judged> windows) const;
    double excess_of(std::span<const WaveEstimate> shorts) const;

    std::int64_t length_;
    std::int64_t short_;
    std::int64_t run_hop_;
    double rate_hz_;
    std::optional<Known> known_;
    double limit_ = 0;     // of the ratio of two variances
    double variance_ = 0;  // of the noise, per sample and channel; NaN: unknown
    double excess_ = 1;
    bool leaks_ = false;  // below three periods
    std::vector<Short> shorts_;
};

// Gives the windows of a block the noise of their block where their own is poorly known: the median
// of the steady noise counts as 100 degrees of freedom beside those of the window.
void pool_noise(std::span<WaveEstimate> windows, std::int64_t length, double independent);

// After a band-pass the noise is not white: the fitted wave of a window takes up much of it, and
// the residual shows a part only. The uncertainty of a window's estimates follows from the noise's
// density about the carrier, which the filter leaves as it was.

// Noise inside the passband as white noise of the same density, sd per sample and channel,
// recording units: the median of the spectrum from low_hz to high_hz, which the lines of the modes
// do not move, of the longest run without missing samples, up to 2^18 frames, of [first, end) of a
// source after that band-pass. NaN where that is too short to have a frequency inside the band.
// Errors: those of the source; interrupted.
Result<double> noise_in_band(const SampleSource& source, std::int64_t first, std::int64_t end,
                             const Band& band, double rate_hz, const JobControl& job);

// White noise that would move phasors and frequency of a window of n samples at f0 as much as noise
// of density `noise` inside the band-pass does: the density times the band's share of the power
// spectra of the weights, cos w0 u and u sin w0 u, by which a window takes in noise. Both are
// `noise` for long windows and smaller for windows shorter than the inverse of the bandwidth.
EquivalentNoise equivalent_noise(double noise, const Band& band, double f0_hz, std::int64_t n,
                                 double rate_hz);

// Correlation of the errors of f of two windows of n samples after the band-pass, by the hops
// between them, from 1 to where it has died away.
std::vector<double> frequency_correlation(const Band& band, double f0_hz, std::int64_t n,
                                          std::int64_t hop, double rate_hz);

}  // namespace vybeg
