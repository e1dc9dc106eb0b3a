#pragma once

#include "core/analysis/settings.h"
#include "core/estimators/wave/estimator.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Length of the short windows that measure the noise of a recording: twelve times the least, about
// nine periods of the carrier, too short for a wave to move in.
std::int64_t noise_window(std::int64_t length, double f0_hz, double rate_hz);

// The noise about a stretch of a recording, from short windows, and what it says of longer ones.
//
// A window that holds no steady wave leaves a residual, but the residual alone does not show it:
// noise, hum and offset leave one too. Short windows of the same samples leave those and not the
// motion. Their median stands against events, and against a motion that all long windows share.
class NoiseLevel {
public:
    // Windows of `length` samples; `noise`: known, of windows of noise_window() samples and of the
    // whole band, behind a band-pass.
    struct Known {
        EquivalentNoise of_short;
        EquivalentNoise of_long;
        double in_band = 0;  // noise of a sample, sd
        double share = 1;    // of the band in the spectrum, independent samples in one
    };
    NoiseLevel(std::int64_t length, double f0_hz, double rate_hz, std::optional<Known> known);

    // Windows from one with a short window at its centre to the next, in a stretch of `frames`.
    std::int64_t stride(std::int64_t windows, std::int64_t frames) const;
    std::int64_t short_length() const { return short_; }
    // Takes the estimates of the short windows, the first one centred at `centre_s`.
    void take(std::span<const WaveEstimate> estimates, double centre_s, std::int64_t hop);

    // Whether the window's residual is far above the level, or the short window at its centre lies
    // far from its wave: a linear motion has its mean there. False where either is unknown.
    bool holds_no_wave(const WaveEstimate& window, double centre_s) const;
    // Mean squared distance of the short windows inside from the window's wave, by its variance;
    // NaN for none.
    double apart(const WaveEstimate& window, double centre_s) const;
    // Whether the windows of the stretch together lie apart from their short windows: a motion that
    // all of them share and none shows by itself.
    bool all_move(std::vector<double> apart) const;

private:
    struct Short {
        double centre_s;
        Phasors phasors;
    };

    std::int64_t length_;
    std::int64_t short_;
    double rate_hz_;
    std::optional<Known> known_;
    double limit_ = 0;     // of the ratio of two variances
    double variance_ = 0;  // of the noise, per sample and channel; NaN: unknown
    std::vector<Short> shorts_;
};

// Gives the windows of a block the noise of their block where their own is poorly known: the median
// of the steady noise counts as 100 degrees of freedom beside those of the window.
void pool_noise(std::span<WaveEstimate> windows, std::int64_t length, double independent);

}  // namespace vybeg
