#pragma once

#include "core/residuals/find_residuals.h"
#include "ui/plots/xy_plot.h"
#include "ui/widgets/quantity_table.h"

#include <QString>

#include <optional>
#include <vector>

namespace vybeg::ui {

// Sentences about the samples of a residual: how many, and which are left out.
QString coverageText(const Residuals& found);

// Rows of numbers with the columns C and D. What white normal noise does not explain, by more than
// four standard deviations, is in the colour `alarm`.
std::vector<QuantityRow> residualRows(const Residuals& found, const QString& unit,
                                      const QColor& alarm);

// E.g. "50.02 Hz: mains, 50 Hz".
QString lineName(const ResidualLine& line);
// Frequency, amplitudes, origin, and what can be done about it.
QString lineSentence(const ResidualLine& line, const Residuals& found, const QString& unit);
// E.g. "2800 … 7800 Hz".
QString bandText(const Band& band);

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
