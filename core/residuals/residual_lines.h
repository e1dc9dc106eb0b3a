#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/settings.h"
#include "core/numerics/spectral_density.h"
#include "core/recording/samples/recording.h"
#include "core/residuals/residuals.h"

#include <array>
#include <optional>
#include <vector>

namespace vybeg {

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
