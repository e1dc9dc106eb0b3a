#pragma once

#include "core/residuals/find_residuals.h"
#include "ui/plots/xy_plot.h"

#include <optional>

namespace vybeg::ui {

// Plots of a residual, C and D together. `empty`: the text where there is none.

// Counts as a density over the deviation from the mean in sd, with the normal curve.
XYPlot histogramPlot(const Residuals* found, const QString& empty);

// Amplitude density over frequency, both axes logarithmic, with the lines as points; `chosen`: the
// number of one of them. `unit`: that of the samples.
XYPlot spectrumPlot(const Residuals* found, const QString& unit, std::optional<std::size_t> chosen,
                    const QString& empty);
// The series of the lines, in the order of Residuals::lines.
inline constexpr std::size_t spectrum_lines = 2;

// Autocorrelation over the lag from one sample on, with the limits of white noise.
XYPlot correlationPlot(const Residuals* found, const QString& empty);

}  // namespace vybeg::ui
