#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/numerics/spectral_density.h"
#include "core/numerics/statistics.h"
#include "core/recording/samples/recording.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace vybeg {

// Which samples of an analysis: those of a time range, or those of one window.
struct ResidualRange {
    TimeRange time;
    std::optional<std::int64_t> window;

    friend bool operator==(const ResidualRange&, const ResidualRange&) = default;
};

// Where a line in the spectrum of a residual comes from.
enum class LineOrigin {
    wave,              // at the carrier: the wave that its windows do not follow
    window_rate,       // the carrier plus or minus `order` times the rate of the windows
    window_image,      // of a stronger line, base_hz, by windows that take up a part of it
    mains,             // `order` times base_hz, 50, 60 or 400 Hz
    carrier_by_mains,  // the carrier modulated by that
    carrier_harmonic,  // `order` times the carrier
    folded_harmonic,   // the same above half the sample rate, folded into the spectrum
    other_mode,        // decays in the range, and is none of these
    unknown            // as strong at the end of the range as at its start, or not known
};

struct LineName {
    LineOrigin origin = LineOrigin::unknown;
    int order = 0;
    double base_hz = 0;
};

// A line above the noise: amplitude of the sinusoid that has its mean power, recording units. A
// window whose main lobe reaches to the line takes up some of it.
struct ResidualLine : LineName {
    double f_hz = 0;
    double amplitude_c = 0;
    double amplitude_d = 0;
    double sd_c = 0;  // of the amplitudes
    double sd_d = 0;
    // A band-pass about the carrier that takes the line out; none where no filter can do so.
    std::optional<Band> filter;
};

// The widest band-pass about the carrier, settings.f0_hz, that takes out a line at `line_hz`,
// inside the filter that is in effect. None where the filter takes it out already, or where its
// transients would take more than a tenth of the recording at either end. Precondition: there is a
// carrier.
std::optional<Band> filter_without(double line_hz, const SignalSettings& settings,
                                   const Recording& recording);

// The residual of one channel: samples less the wave of their window, recording units.
struct ResidualChannel {
    Moments moments;
    // sd per sample of white noise that leaves this residual: a window takes up a part of the noise
    // with its parameters. NaN after a band-pass, whose noise is not white.
    double noise_sd = std::numeric_limits<double>::quiet_NaN();
    Histogram histogram;
    // One-sided power spectral density, squared units per Hz, bin k at k * bin_hz; the mean of the
    // residual is taken off. Empty where no part of the samples is long enough.
    std::vector<double> density;
    std::vector<double> autocorrelation;  // by lags of one sample, 1 at lag 0

    double amplitude_density(std::size_t bin) const { return std::sqrt(density[bin]); }
};

struct ResidualFrames {
    std::int64_t frames = 0;    // of the range
    std::int64_t examined = 0;  // of these, where the range is too long for all
    std::int64_t without = 0;   // examined, but without a wave: gaps, circular waves, no window

    std::int64_t used() const { return examined - without; }
};

// The residual of an analysis, and its expected form for white normal noise.
struct Residuals : ResidualFrames {
    double rate_hz = 0;
    double f0_hz = 0;
    double taken_up = 0;  // the share of white noise that the windows' parameters take up
    ResidualChannel c;
    ResidualChannel d;
    double bin_hz = 0;
    int segments = 0;                 // averaged in the spectrum
    double correlation_limit = 0;     // 1.96 / sqrt(N): 95 % of the lags of white noise lie within
    std::vector<ResidualLine> lines;  // in the order of frequency
};

// The residual of an analysis in a range, its distribution, spectrum and autocorrelation.
// Precondition and errors as of residual_samples().
Result<Residuals> find_residuals(const Recording& recording, const Analysis& analysis,
                                 const ResidualRange& range, const JobControl& job);

// Residuals of both channels, part after part of consecutive frames.
struct ResidualSamples : ResidualFrames {
    std::vector<double> c;
    std::vector<double> d;
    std::vector<std::size_t> part_begins;  // in c and d

    std::size_t parts() const { return part_begins.size(); }
    std::span<const double> c_of(std::size_t part) const { return cut(c, part); }
    std::span<const double> d_of(std::size_t part) const { return cut(d, part); }

private:
    std::span<const double> cut(const std::vector<double>& all, std::size_t part) const {
        const std::size_t end = part + 1 < parts() ? part_begins[part + 1] : all.size();
        return std::span(all).subspan(part_begins[part], end - part_begins[part]);
    }
};

// The samples of a range, conditioned as the analysis conditions them, less the wave (6) of the
// window whose centre is nearest, the later one of two; of a single window, less its own wave. Of
// more than 2^20 frames 16 blocks at even distances are read. Precondition: the analysis is one of
// this recording and has all rows of its plan. Errors: those of prepare(); interrupted.
Result<ResidualSamples> residual_samples(const Recording& recording, const Analysis& analysis,
                                         const ResidualRange& range, const JobControl& job);

// Mean densities of the residuals of both channels, and those of both halves of the range, whose
// difference shows what decays.
struct ResidualSpectrum {
    double bin_hz = 0;
    int segments = 0;
    Densities mean;
    std::array<Densities, 2> halves;
    std::array<int, 2> segments_of_half{};
};

// Peaks that rise above the noise around them by more than white noise does in either channel with
// a probability of 0.01, with their origin; 24 at most, the ones that rise highest, and only the
// first two orders at the rate of the windows. None in spectra of less than 64 bins, and none
// outside a band-pass.
std::vector<ResidualLine> residual_lines(const ResidualSpectrum& spectrum,
                                         const Recording& recording, const Analysis& analysis);

}  // namespace vybeg
