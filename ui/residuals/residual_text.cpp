#include "ui/residuals/residual_text.h"

#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/number_label.h"
#include "ui/words/unit_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace vybeg::ui {

namespace {

QString counted(std::int64_t count) {
    return numberLabel(static_cast<double>(count), 0);
}

QString hertz(double f_hz, int decimals = 2) {
    return numberLabel(f_hz, decimals);
}

QString significant(double value, int digits) {
    return std::abs(value) < 10 ? shortNumberText(value, digits) : numberLabel(value, 0);
}

QuantityCell cellOf(double value, double sd, const QColor& alarm = {}) {
    const auto exact = [](double number) { return QLocale().toString(number, 'g', 12); };
    return {valueText(value, sd), {exact(value), exact(sd)}, alarm};
}

bool isHarmonic(LineOrigin origin) {
    return origin == LineOrigin::carrier_harmonic || origin == LineOrigin::folded_harmonic;
}

// What a line is, without its frequency.
QString originText(const ResidualLine& line) {
    const QString base = hertz(line.base_hz, 0);
    switch (line.origin) {
        case LineOrigin::wave:
            return residualsText(QT_TRANSLATE_NOOP("Residuals", "the wave itself"));
        case LineOrigin::window_rate:
            return residualsText(
                QT_TRANSLATE_NOOP("Residuals", "the wave, at the rate of the windows"));
        case LineOrigin::window_image:
            return residualsText(
                       QT_TRANSLATE_NOOP("Residuals", "image of the line at %1 Hz by the windows"))
                .arg(hertz(line.base_hz));
        case LineOrigin::mains:
            return line.order == 1
                       ? residualsText(QT_TRANSLATE_NOOP("Residuals", "supply of %1 Hz")).arg(base)
                       : residualsText(
                             QT_TRANSLATE_NOOP("Residuals", "supply of %1 Hz, harmonic %2"))
                             .arg(base)
                             .arg(line.order);
        case LineOrigin::carrier_by_mains:
            return residualsText(QT_TRANSLATE_NOOP("Residuals", "carrier modulated at %1 Hz"))
                .arg(hertz(line.order * line.base_hz, 0));
        case LineOrigin::carrier_harmonic:
            return residualsText(QT_TRANSLATE_NOOP("Residuals", "harmonic %1 of the carrier"))
                .arg(line.order);
        case LineOrigin::folded_harmonic:
            return residualsText(
                       QT_TRANSLATE_NOOP("Residuals", "harmonic %1 of the carrier, folded"))
                .arg(line.order);
        case LineOrigin::other_mode:
            return residualsText(QT_TRANSLATE_NOOP("Residuals", "another mode"));
        case LineOrigin::unknown: return residualsText(QT_TRANSLATE_NOOP("Residuals", "unknown"));
    }
    return {};
}

// Why the line is what it is called, and what helps.
QString explanation(const ResidualLine& line) {
    switch (line.origin) {
        case LineOrigin::wave:
            return residualsText(QT_TRANSLATE_NOOP(
                "Residuals",
                "This is the wave itself: it changes inside the windows, or another mode lies "
                "beside it. Shorter windows follow a change."));
        case LineOrigin::window_rate:
            return residualsText(QT_TRANSLATE_NOOP(
                "Residuals",
                "The distance from the carrier is a multiple of the rate of the windows: the wave "
                "changes inside them. Shorter windows follow it."));
        case LineOrigin::window_image:
            return residualsText(
                QT_TRANSLATE_NOOP("Residuals",
                                  "Each window takes up a little of that line, which "
                                  "makes images beside the carrier. "
                                  "Without the line they are gone, too."));
        case LineOrigin::mains:
            return residualsText(
                QT_TRANSLATE_NOOP("Residuals", "An electrical supply couples into the pick-offs."));
        case LineOrigin::carrier_by_mains:
            return residualsText(QT_TRANSLATE_NOOP(
                "Residuals",
                "The distance from the carrier is that of the mains: they modulate the wave or its "
                "pick-off."));
        case LineOrigin::carrier_harmonic:
            return residualsText(QT_TRANSLATE_NOOP(
                "Residuals",
                "A pick-off or the suspension is not linear, or samples are clipped."));
        case LineOrigin::folded_harmonic:
            return residualsText(QT_TRANSLATE_NOOP(
                "Residuals",
                "It lies above half the sample rate and appears as an alias. A pick-off is not "
                "linear, or samples are clipped."));
        case LineOrigin::other_mode:
            return residualsText(QT_TRANSLATE_NOOP(
                "Residuals", "It decays in this range as a mode of the resonator does."));
        case LineOrigin::unknown:
            return residualsText(QT_TRANSLATE_NOOP(
                "Residuals",
                "It is no harmonic of the carrier or the mains, and no decay is seen in this "
                "range."));
    }
    return {};
}

}  // namespace

QString residualsText(const char* text) {
    return QCoreApplication::translate("Residuals", text);
}

QString coverageText(const Residuals& found) {
    QStringList sentences;
    sentences << residualsText(QT_TRANSLATE_NOOP("Residuals", "Samples per channel: %1."))
                     .arg(counted(found.used()));
    if (found.examined < found.frames) {
        sentences << residualsText(QT_TRANSLATE_NOOP("Residuals",
                                                     "The range has %1; blocks at even distances "
                                                     "stand for all of them."))
                         .arg(counted(found.frames));
    }
    if (found.without > 0) {
        sentences << residualsText(
                         QT_TRANSLATE_NOOP("Residuals",
                                           "Left out, because no wave was found there: %1."))
                         .arg(counted(found.without));
    }
    constexpr double worth_saying = 0.01;
    if (found.taken_up > worth_saying) {
        sentences << residualsText(
                         QT_TRANSLATE_NOOP("Residuals",
                                           "The windows take up %1 % of the noise, around "
                                           "the carrier."))
                         .arg(significant(100 * found.taken_up, 2));
    }
    return sentences.join(QLatin1Char(' '));
}

std::vector<QuantityRow> residualRows(const Residuals& found, const QString& unit,
                                      const QColor& alarm) {
    constexpr double doubtful = 4;  // standard deviations
    const auto row = [&](const char* name, const QString& of_unit, const char* tip, auto&& cell) {
        return QuantityRow{withUnit(residualsText(name), of_unit),
                           residualsText(tip),
                           {cell(found.c), cell(found.d)}};
    };
    const auto flagged = [&](double value, double sd) {
        return cellOf(value, sd, std::abs(value) > doubtful * sd ? alarm : QColor());
    };
    const auto of_count = [](const ResidualChannel& channel, double factor) {
        return factor / std::sqrt(static_cast<double>(channel.moments.count));
    };
    return {
        row(QT_TRANSLATE_NOOP("Residuals", "sd of the residual"), unit,
            QT_TRANSLATE_NOOP("Residuals", "Standard deviation of the residual about its mean"),
            [&](const ResidualChannel& channel) {
                const double sd = channel.moments.sd;
                return cellOf(sd, sd * of_count(channel, M_SQRT1_2));
            }),
        row(QT_TRANSLATE_NOOP("Residuals", "Noise per sample"), unit,
            QT_TRANSLATE_NOOP("Residuals",
                              "Standard deviation of white noise that leaves this residual: the "
                              "parameters of a window take up a part of it. Unknown after a "
                              "band-pass filter."),
            [&](const ResidualChannel& channel) {
                const double sd = channel.noise_sd;
                return cellOf(sd, sd * of_count(channel, M_SQRT1_2));
            }),
        row(QT_TRANSLATE_NOOP("Residuals", "Mean"), unit,
            QT_TRANSLATE_NOOP("Residuals",
                              "Mean of the residual. Beyond four standard deviations: an offset of "
                              "the channel, or a slow disturbance."),
            [&](const ResidualChannel& channel) {
                return flagged(channel.moments.mean, channel.moments.sd * of_count(channel, 1));
            }),
        row(QT_TRANSLATE_NOOP("Residuals", "Skewness"), {},
            QT_TRANSLATE_NOOP("Residuals",
                              "0 for normal noise, with the standard deviation of so many "
                              "independent samples"),
            [&](const ResidualChannel& channel) {
                return flagged(channel.moments.skewness, channel.moments.sd_skewness);
            }),
        row(QT_TRANSLATE_NOOP("Residuals", "Excess kurtosis"), {},
            QT_TRANSLATE_NOOP("Residuals",
                              "0 for normal noise; below it with a steady line, above it with "
                              "outliers or a noise that changes"),
            [&](const ResidualChannel& channel) {
                return flagged(channel.moments.kurtosis, channel.moments.sd_kurtosis);
            }),
        row(QT_TRANSLATE_NOOP("Residuals", "Largest deviation, in sd"), {},
            QT_TRANSLATE_NOOP("Residuals",
                              "The largest deviation from the mean in standard deviations, and how "
                              "many samples of normal noise lie beyond it on average"),
            [&](const ResidualChannel& channel) {
                const Moments& moments = channel.moments;
                if (std::isnan(moments.largest_z)) {
                    return QuantityCell{QStringLiteral("—"), {QString(), QString()}, {}};
                }
                constexpr double seldom = 1e-3;
                return QuantityCell{
                    residualsText(QT_TRANSLATE_NOOP("Residuals", "%1 (expected beyond: %2)"))
                        .arg(significant(moments.largest_z, 3),
                             significant(moments.expected_beyond, 2)),
                    {QLocale().toString(moments.largest_z, 'g', 12),
                     QLocale().toString(moments.expected_beyond, 'g', 12)},
                    moments.expected_beyond < seldom ? alarm : QColor()};
            }),
    };
}

QString lineName(const ResidualLine& line) {
    return residualsText(QT_TRANSLATE_NOOP("Residuals", "%1 Hz: %2"))
        .arg(hertz(line.f_hz), originText(line));
}

QString bandText(const Band& band) {
    const int decimals = band.high_hz - band.low_hz < 40 ? 2 : 0;
    return residualsText(QT_TRANSLATE_NOOP("Residuals", "%1 … %2 Hz"))
        .arg(hertz(band.low_hz, decimals), hertz(band.high_hz, decimals));
}

QString lineSentence(const ResidualLine& line, const Residuals& found, const QString& unit) {
    const auto amplitude = [&](double value, double sd) {
        return valueText(value, sd) + (unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
    };
    QStringList sentences;
    sentences << QStringLiteral("<b>%1.</b>").arg(lineName(line));
    sentences << residualsText(QT_TRANSLATE_NOOP("Residuals", "Amplitude: C %1, D %2."))
                     .arg(amplitude(line.amplitude_c, line.sd_c),
                          amplitude(line.amplitude_d, line.sd_d));
    if (isHarmonic(line.origin)) {
        sentences << residualsText(QT_TRANSLATE_NOOP("Residuals", "It is %1 times %2 Hz."))
                         .arg(line.order)
                         .arg(hertz(found.f0_hz));
    }
    sentences << explanation(line);
    if (line.filter) {
        sentences << residualsText(
            QT_TRANSLATE_NOOP("Residuals", "A band-pass filter takes it out."));
    }
    return sentences.join(QLatin1Char(' '));
}

}  // namespace vybeg::ui
