#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/numerics/spectral_density.h"
#include "core/recording/samples/recording.h"

#include <array>
#include <optional>
#include <vector>

namespace vybeg {

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

// A line above the noise: amplitude of the sinusoid that has its mean power, recording units. A
// window whose main lobe reaches to the line takes up some of it.
struct ResidualLine {
    double f_hz = 0;
    double amplitude_c = 0;
    double amplitude_d = 0;
    double sd_c = 0;  // of the amplitudes
    double sd_d = 0;
    LineOrigin origin = LineOrigin::unknown;
    int order = 0;
    double base_hz = 0;
    // A band-pass about the carrier that takes the line out; none where no filter can do so.
    std::optional<Band> filter;
};

// The probability of one line or more in the spectrum of white noise.
inline constexpr double false_line_probability = 0.01;

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
// false_line_probability, with their origin; 24 at most, the ones that rise highest, and only the
// first two orders at the rate of the windows. None in spectra of less than 64 bins, and none
// outside a band-pass.
std::vector<ResidualLine> residual_lines(const ResidualSpectrum& spectrum,
                                         const Recording& recording, const Analysis& analysis);

}  // namespace vybeg
