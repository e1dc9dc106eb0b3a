#include "ui/residuals/residual_plots.h"

#include "ui/residuals/residual_text.h"
#include "ui/words/number_label.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vybeg::ui {

namespace {

QString unitName(const char* unit) {
    return QCoreApplication::translate("DisplayUnits", unit);
}

XYSeries channelSeries(const char* name, Ink ink) {
    XYSeries series;
    series.name = QLatin1String(name);
    series.ink = ink;
    return series;
}

XYSeries histogramSeries(const ResidualChannel& channel, const char* name, Ink ink) {
    XYSeries series = histogramSteps(channel.histogram, QLatin1String(name), ink);
    const double whole = channel.histogram.width * static_cast<double>(channel.moments.count);
    for (double& count : series.y) {
        count /= whole;
    }
    return series;
}

XYSeries normalCurve() {
    constexpr int points = 161;
    constexpr double reach = 4;
    XYSeries curve = dashedLine(ResidualWords::tr("normal"), Ink::text);
    for (int k = 0; k < points; ++k) {
        const double z = reach * (2.0 * k / (points - 1) - 1);
        curve.x.push_back(z);
        curve.y.push_back(std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi));
    }
    return curve;
}

XYSeries densitySeries(const Residuals& found, const ResidualChannel& channel, const char* name,
                       Ink ink) {
    XYSeries series = channelSeries(name, ink);
    series.thin = true;
    // Bin 0 has no place on a logarithmic axis, and no density below rounding.
    for (std::size_t k = 1; k < channel.density.size(); ++k) {
        if (channel.density[k] > 0) {
            series.x.push_back(static_cast<double>(k) * found.bin_hz);
            series.y.push_back(channel.amplitude_density(k));
        }
    }
    return series;
}

// The higher of both channels at the nearest bin.
double heightOf(const Residuals& found, const ResidualLine& line) {
    const auto bin = std::min(static_cast<std::size_t>(std::llround(line.f_hz / found.bin_hz)),
                              found.c.density.size() - 1);
    return std::max(found.c.amplitude_density(bin), found.d.amplitude_density(bin));
}

// From below the noise, without the depth of the dip at the carrier, to above the highest line.
AxisRange densityRange(const std::vector<XYSeries>& channels) {
    std::vector<double> all;
    for (const XYSeries& channel : channels) {
        all.insert(all.end(), channel.y.begin(), channel.y.end());
    }
    if (all.empty()) {
        return {0.1, 10};
    }
    const auto low = all.begin() + std::ssize(all) / 100;
    std::ranges::nth_element(all, low);
    const double lowest = *low;
    return {lowest / 3, 2 * *std::ranges::max_element(all)};
}

XYSeries correlationSeries(const Residuals& found, const ResidualChannel& channel, const char* name,
                           Ink ink) {
    XYSeries series = channelSeries(name, ink);
    series.thin = true;
    for (std::size_t lag = 1; lag < channel.autocorrelation.size(); ++lag) {
        series.x.push_back(1e3 * static_cast<double>(lag) / found.rate_hz);
        series.y.push_back(channel.autocorrelation[lag]);
    }
    return series;
}

}  // namespace

XYPlot histogramPlot(const Residuals* found, const QString& empty) {
    XYPlot plot;
    plot.x_name = ResidualWords::tr("Residual");
    plot.x_unit = ResidualWords::tr("sd");
    plot.y_name = ResidualWords::tr("Probability density");
    plot.empty = empty;
    if (found != nullptr && !found->c.histogram.counts.empty() &&
        !found->d.histogram.counts.empty()) {
        plot.series = {histogramSeries(found->c, "C", Ink::channel_c),
                       histogramSeries(found->d, "D", Ink::channel_d), normalCurve()};
    }
    return plot;
}

XYPlot spectrumPlot(const Residuals* found, const QString& unit, std::optional<std::size_t> chosen,
                    const QString& empty) {
    XYPlot plot;
    plot.x_name = QStringLiteral("f");
    plot.x_unit = unitName("Hz");
    plot.x_logarithmic = true;
    plot.y_name = ResidualWords::tr("Amplitude density");
    plot.y_unit =
        (unit.isEmpty() ? QStringLiteral("1") : unit) + QStringLiteral("/√") + unitName("Hz");
    plot.y_logarithmic = true;
    plot.empty = empty;
    if (found == nullptr || found->c.density.size() < 2) {
        return plot;
    }
    XYSeries lines;
    lines.points = true;
    lines.ink = Ink::text;
    for (const ResidualLine& line : found->lines) {
        lines.x.push_back(line.f_hz);
        lines.y.push_back(heightOf(*found, line));
    }
    plot.series = {densitySeries(*found, found->c, "C", Ink::channel_c),
                   densitySeries(*found, found->d, "D", Ink::channel_d), lines};
    plot.y_range = densityRange({plot.series[0], plot.series[1]});
    if (chosen && *chosen < found->lines.size()) {
        plot.series.push_back(markOn(lines, *chosen, Ink::warning));
    }
    return plot;
}

XYPlot correlationPlot(const Residuals* found, const QString& empty) {
    XYPlot plot;
    plot.x_name = ResidualWords::tr("Lag");
    plot.x_unit = ResidualWords::tr("ms");
    plot.y_name = ResidualWords::tr("Autocorrelation");
    plot.empty = empty;
    if (found == nullptr || found->c.autocorrelation.size() < 2 ||
        found->d.autocorrelation.size() < 2) {
        return plot;
    }
    plot.series = {correlationSeries(*found, found->c, "C", Ink::channel_c),
                   correlationSeries(*found, found->d, "D", Ink::channel_d)};
    for (const double side : {1.0, -1.0}) {
        const QString name =
            side > 0 ? QStringLiteral("±%1/√N").arg(numberLabel(1.96, 2)) : QString();
        const std::vector<double>& x = plot.series.front().x;
        const double limit = side * found->correlation_limit;
        plot.series.push_back(dashedLine(name, Ink::text, {x.front(), x.back()}, {limit, limit}));
    }
    return plot;
}

}  // namespace vybeg::ui
