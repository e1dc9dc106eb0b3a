#include "ui/residuals/shown_residuals.h"

#include "ui/words/display_units.h"
#include "ui/words/error_text.h"

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

struct ResidualWords {
    Q_DECLARE_TR_FUNCTIONS(Residuals)
};

QString significant(double value, int digits) {
    return std::abs(value) < 10 ? shortNumberText(value, digits) : numberLabel(value, 0);
}

struct OriginText {
    QString name;  // what a line is, without its frequency
    QString why;   // it is called so, and what helps
};

OriginText originText(const ResidualLine& line) {
    const QString base = numberLabel(line.base_hz, 0);
    switch (line.origin) {
        case LineOrigin::wave:
            return {ResidualWords::tr("the wave itself"),
                    ResidualWords::tr(
                        "This is the wave itself: it changes inside the windows, or another mode "
                        "lies beside it. Shorter windows follow a change.")};
        case LineOrigin::window_rate:
            return {ResidualWords::tr("the wave, at the rate of the windows"),
                    ResidualWords::tr(
                        "The distance from the carrier is a multiple of the rate of the windows: "
                        "the wave changes inside them. Shorter windows follow it.")};
        case LineOrigin::window_image:
            return {ResidualWords::tr("image of the line at %1 Hz by the windows")
                        .arg(numberLabel(line.base_hz, 2)),
                    ResidualWords::tr(
                        "Each window takes up a little of that line, which makes images beside the "
                        "carrier. Without the line they are gone, too.")};
        case LineOrigin::mains:
            return {
                line.order == 1
                    ? ResidualWords::tr("supply of %1 Hz").arg(base)
                    : ResidualWords::tr("supply of %1 Hz, harmonic %2").arg(base).arg(line.order),
                ResidualWords::tr("An electrical supply couples into the pick-offs.")};
        case LineOrigin::carrier_by_mains:
            return {ResidualWords::tr("carrier modulated at %1 Hz")
                        .arg(numberLabel(line.order * line.base_hz, 0)),
                    ResidualWords::tr(
                        "The distance from the carrier is that of the mains: they modulate the "
                        "wave or its pick-off.")};
        case LineOrigin::carrier_harmonic:
            return {ResidualWords::tr("harmonic %1 of the carrier").arg(line.order),
                    ResidualWords::tr(
                        "A pick-off or the suspension is not linear, or samples are clipped.")};
        case LineOrigin::folded_harmonic:
            return {ResidualWords::tr("harmonic %1 of the carrier, folded").arg(line.order),
                    ResidualWords::tr(
                        "It lies above half the sample rate and appears as an alias. A pick-off is "
                        "not linear, or samples are clipped.")};
        case LineOrigin::other_mode:
            return {ResidualWords::tr("another mode"),
                    ResidualWords::tr("It decays in this range as a mode of the resonator does.")};
        case LineOrigin::unknown: break;
    }
    return {ResidualWords::tr("unknown"),
            ResidualWords::tr("It is no harmonic of the carrier or the mains, and no decay is seen "
                              "in this range.")};
}

// A thin curve for each channel, whose points `add` finds.
template <class Add>
std::vector<XYSeries> channelCurves(const Residuals& found, const Add& add) {
    std::vector<XYSeries> curves{
        {.name = QStringLiteral("C"), .ink = Ink::channel_c, .thin = true},
        {.name = QStringLiteral("D"), .ink = Ink::channel_d, .thin = true}};
    add(found.c, curves[0]);
    add(found.d, curves[1]);
    return curves;
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

}  // namespace

QString coverageText(const Residuals& found) {
    QStringList sentences;
    sentences << ResidualWords::tr("Samples per channel: %1.").arg(countLabel(found.used()));
    if (found.examined < found.frames) {
        sentences << ResidualWords::tr(
                         "The range has %1; blocks at even distances stand for all of them.")
                         .arg(countLabel(found.frames));
    }
    if (found.without > 0) {
        sentences << ResidualWords::tr("Left out, because no wave was found there: %1.")
                         .arg(countLabel(found.without));
    }
    constexpr double worth_saying = 0.01;
    if (found.taken_up > worth_saying) {
        sentences << ResidualWords::tr("The windows take up %1 % of the noise, around the carrier.")
                         .arg(significant(100 * found.taken_up, 2));
    }
    return sentences.join(QLatin1Char(' '));
}

std::vector<QuantityRow> residualRows(const Residuals& found, const QString& unit,
                                      const QColor& alarm) {
    constexpr double doubtful = 4;  // standard deviations
    const auto row = [&](const QString& name, const QString& of_unit, const QString& tip,
                         auto&& cell) {
        return QuantityRow{withUnit(name, of_unit), tip, {cell(found.c), cell(found.d)}};
    };
    const auto flagged = [&](double value, double sd) {
        return measuredCell(value, sd, std::abs(value) > doubtful * sd ? alarm : QColor());
    };
    const auto of_count = [](const ResidualChannel& channel, double factor) {
        return factor / std::sqrt(static_cast<double>(channel.moments.count));
    };
    return {
        row(ResidualWords::tr("sd of the residual"), unit,
            ResidualWords::tr("Standard deviation of the residual about its mean"),
            [&](const ResidualChannel& channel) {
                const double sd = channel.moments.sd;
                return measuredCell(sd, sd * of_count(channel, M_SQRT1_2));
            }),
        row(ResidualWords::tr("Noise per sample"), unit,
            ResidualWords::tr(
                "Standard deviation of white noise that leaves this residual: the parameters of a "
                "window take up a part of it. Unknown after a band-pass filter."),
            [&](const ResidualChannel& channel) {
                const double sd = channel.noise_sd;
                return measuredCell(sd, sd * of_count(channel, M_SQRT1_2));
            }),
        row(ResidualWords::tr("Mean"), unit,
            ResidualWords::tr("Mean of the residual. Beyond four standard deviations: an offset of "
                              "the channel, or a slow disturbance."),
            [&](const ResidualChannel& channel) {
                return flagged(channel.moments.mean, channel.moments.sd * of_count(channel, 1));
            }),
        row(ResidualWords::tr("Skewness"), {},
            ResidualWords::tr(
                "0 for normal noise, with the standard deviation of so many independent samples"),
            [&](const ResidualChannel& channel) {
                return flagged(channel.moments.skewness, channel.moments.sd_skewness);
            }),
        row(ResidualWords::tr("Excess kurtosis"), {},
            ResidualWords::tr("0 for normal noise; below it with a steady line, above it with "
                              "outliers or a noise that changes"),
            [&](const ResidualChannel& channel) {
                return flagged(channel.moments.kurtosis, channel.moments.sd_kurtosis);
            }),
        row(ResidualWords::tr("Largest deviation, in sd"), {},
            ResidualWords::tr("The largest deviation from the mean in standard deviations, and how "
                              "many samples of normal noise lie beyond it on average"),
            [&](const ResidualChannel& channel) {
                const Moments& moments = channel.moments;
                if (std::isnan(moments.largest_z)) {
                    return QuantityCell{QStringLiteral("—"), {QString(), QString()}, {}};
                }
                constexpr double seldom = 1e-3;
                return QuantityCell{
                    ResidualWords::tr("%1 (expected beyond it: %2 samples)")
                        .arg(significant(moments.largest_z, 3),
                             significant(moments.expected_beyond, 2)),
                    {cellNumber(moments.largest_z), cellNumber(moments.expected_beyond)},
                    moments.expected_beyond < seldom ? alarm : QColor()};
            }),
    };
}

QString lineName(const ResidualLine& line) {
    return ResidualWords::tr("%1 Hz: %2").arg(numberLabel(line.f_hz, 2), originText(line).name);
}

QString bandText(const Band& band) {
    const int decimals = band.high_hz - band.low_hz < 40 ? 2 : 0;
    return ResidualWords::tr("%1 … %2 Hz")
        .arg(numberLabel(band.low_hz, decimals), numberLabel(band.high_hz, decimals));
}

QString lineSentence(const ResidualLine& line, const Residuals& found, const QString& unit) {
    const auto amplitude = [&](double value, double sd) {
        return valueText(value, sd) +
               (unit.isEmpty() ? QString() : QLatin1Char(' ') + unit.toHtmlEscaped());
    };
    QStringList sentences;
    sentences << QStringLiteral("<b>%1.</b>").arg(lineName(line));
    sentences << ResidualWords::tr("Amplitude: C %1, D %2.")
                     .arg(amplitude(line.amplitude_c, line.sd_c),
                          amplitude(line.amplitude_d, line.sd_d));
    if (line.origin == LineOrigin::carrier_harmonic || line.origin == LineOrigin::folded_harmonic) {
        sentences << ResidualWords::tr("It is %1 times %2 Hz.")
                         .arg(line.order)
                         .arg(numberLabel(found.f0_hz, 2));
    }
    sentences << originText(line).why;
    if (line.filter) {
        sentences << ResidualWords::tr("A band-pass filter removes it.");
    }
    return sentences.join(QLatin1Char(' '));
}

XYPlot histogramPlot(const Residuals* found, const QString& empty) {
    XYPlot plot{.x_name = ResidualWords::tr("Residual"),
                .x_unit = ResidualWords::tr("sd"),
                .y_name = ResidualWords::tr("Probability density"),
                .empty = empty};
    if (found != nullptr && !found->c.histogram.counts.empty() &&
        !found->d.histogram.counts.empty()) {
        plot.series = {histogramSteps(found->c.histogram, QStringLiteral("C"), Ink::channel_c),
                       histogramSteps(found->d.histogram, QStringLiteral("D"), Ink::channel_d),
                       normalCurve(ResidualWords::tr("normal"), 1, 161)};
        for (const auto& [channel, steps] :
             {std::pair{&found->c, &plot.series[0]}, std::pair{&found->d, &plot.series[1]}}) {
            const double whole =
                channel->histogram.width * static_cast<double>(channel->moments.count);
            std::ranges::for_each(steps->y, [whole](double& count) { count /= whole; });
        }
    }
    return plot;
}

XYPlot spectrumPlot(const Residuals* found, const QString& unit, std::optional<std::size_t> chosen,
                    const QString& empty) {
    XYPlot plot;
    plot.x_name = QStringLiteral("f");
    plot.x_unit = unitText("Hz");
    plot.x_logarithmic = true;
    plot.y_name = ResidualWords::tr("Amplitude density");
    plot.y_unit =
        (unit.isEmpty() ? QStringLiteral("1") : unit) + QStringLiteral("/√") + unitText("Hz");
    plot.y_logarithmic = true;
    plot.empty = empty;
    if (found == nullptr || found->c.density.size() < 2) {
        return plot;
    }
    XYSeries lines{.ink = Ink::text, .points = true};
    for (const ResidualLine& line : found->lines) {
        lines.x.push_back(line.f_hz);
        lines.y.push_back(heightOf(*found, line));
    }
    plot.series = channelCurves(*found, [found](const ResidualChannel& channel, XYSeries& curve) {
        // Bin 0 has no place on a logarithmic axis, and no density below rounding.
        for (std::size_t k = 1; k < channel.density.size(); ++k) {
            if (channel.density[k] > 0) {
                curve.x.push_back(static_cast<double>(k) * found->bin_hz);
                curve.y.push_back(channel.amplitude_density(k));
            }
        }
    });
    plot.y_range = densityRange(plot.series);
    plot.series.push_back(lines);
    if (chosen && *chosen < found->lines.size()) {
        plot.series.push_back(markOn(lines, *chosen, Ink::warning));
    }
    return plot;
}

XYPlot correlationPlot(const Residuals* found, const QString& empty) {
    XYPlot plot{.x_name = ResidualWords::tr("Lag"),
                .x_unit = ResidualWords::tr("ms"),
                .y_name = ResidualWords::tr("Autocorrelation"),
                .empty = empty};
    if (found == nullptr || found->c.autocorrelation.size() < 2 ||
        found->d.autocorrelation.size() < 2) {
        return plot;
    }
    plot.series = channelCurves(*found, [found](const ResidualChannel& channel, XYSeries& curve) {
        for (std::size_t lag = 1; lag < channel.autocorrelation.size(); ++lag) {
            curve.x.push_back(1e3 * static_cast<double>(lag) / found->rate_hz);
            curve.y.push_back(channel.autocorrelation[lag]);
        }
    });
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
