#include "ui/history/history_text.h"

#include "core/numerics/control_chart.h"
#include "ui/words/error_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

constexpr qsizetype most_named = 5;

QString counted(const char* text, std::size_t count) {
    return QCoreApplication::translate("History", text, nullptr, static_cast<int>(count));
}

QString nameOf(const HistoryPoint& point) {
    QStringList parts;
    for (const std::string& part : {point.gyro, point.date.text, point.set}) {
        if (!part.empty() && !parts.contains(QString::fromStdString(part))) {
            parts << QString::fromStdString(part);
        }
    }
    return parts.join(QStringLiteral(", "));
}

// In which charts a point lies outside; empty: in none.
QString outsideText(const HistoryCharts& charts, std::size_t point) {
    QStringList where;
    if (charts.control.individuals.out[point]) {
        where << (charts.values[point] > charts.control.centre
                      ? HistoryWords::tr("above the limit")
                      : HistoryWords::tr("below the limit"));
    }
    if (charts.control.ranges.out[point]) {
        where << HistoryWords::tr("a step from the one before");
    }
    if (charts.control.average.out[point]) {
        where << HistoryWords::tr("the average has moved");
    }
    return where.join(QStringLiteral(", "));
}

std::size_t valuesIn(const HistoryCharts& charts) {
    return static_cast<std::size_t>(
        std::ranges::count_if(charts.values, [](double value) { return std::isfinite(value); }));
}

QString withoutDate(const StoredHistory& history, const HistoryView& view) {
    const auto count = std::ranges::count_if(
        history.points, [](const HistoryPoint& point) { return !std::isfinite(point.time_s); });
    return count == 0 || view.axis != HistoryAxis::date
               ? QString()
               : QLatin1Char(' ') +
                     counted(QT_TRANSLATE_N_NOOP("History",
                                                 "%n result(s) without a date are not shown; by "
                                                 "order they are."),
                             static_cast<std::size_t>(count));
}

// What sets the limits, and what is to be known of it.
QString limitsText(const HistoryCharts& charts, std::size_t baseline) {
    if (charts.control.fault == BaselineFault::too_few) {
        return HistoryWords::tr(
                   "Limits need %1 results of this gyro that differ and have about the same "
                   "uncertainty; the baseline has %2.")
            .arg(least_baseline)
            .arg(charts.control.used);
    }
    QString text = counted(QT_TRANSLATE_N_NOOP("History", "The first %n result(s) set the limits."),
                           std::min(valuesIn(charts), baseline));
    if (charts.control.fault == BaselineFault::trend) {
        text +=
            QLatin1Char(' ') + HistoryWords::tr(
                                   "⚠ They rise or fall (stable ones look so in 1 of 200 cases): "
                                   "the limits hold the trend. Choose a baseline without one.");
    } else if (charts.control.fault == BaselineFault::correlated) {
        text +=
            QLatin1Char(' ') + HistoryWords::tr(
                                   "⚠ Each resembles or opposes the one before (independent ones "
                                   "look so in 1 of 200 cases): alarms are not as rare as stated.");
    }
    return text;
}

}  // namespace

QString pointText(const StoredHistory& history, const HistoryCharts& charts,
                  const HistoryView& view, std::size_t point) {
    const HistoryPoint& at = history.points[point];
    const double factor = parameterFactor(view.parameter, view.units);
    const QString unit = parameterUnit(view.parameter, view.units);
    const auto numbered = [](const QString& text, double value, int digits) {
        return QStringLiteral("; ") + text.arg(QLocale().toString(value, 'g', digits));
    };
    QString text = QStringLiteral("%1: %2").arg(
        nameOf(at),
        std::isfinite(charts.values[point])
            ? valueText(factor * charts.values[point], std::abs(factor) * charts.u[point])
            : reasonText(at.value.reason));
    if (std::isfinite(charts.values[point]) && !unit.isEmpty()) {
        text += QStringLiteral(" ") + unit;
    }
    if (std::isfinite(at.f_mean_hz.value)) {
        text += numbered(HistoryWords::tr("f = %1 Hz"), at.f_mean_hz.value, 9);
    }
    if (std::isfinite(at.temperature_c)) {
        text += numbered(HistoryWords::tr("%1 °C"), at.temperature_c, 4);
    }
    if (std::isfinite(at.bias_v)) {
        text += numbered(HistoryWords::tr("%1 V"), at.bias_v, 4);
    }
    if (!at.warnings.empty()) {
        text +=
            QStringLiteral("; ") + HistoryWords::tr("warnings: %1")
                                       .arg(QString::fromStdString(at.warnings)
                                                .replace(QLatin1Char(';'), QStringLiteral(", ")));
    }
    if (const QString outside = outsideText(charts, point); !outside.isEmpty()) {
        text += QStringLiteral("; ") + outside;
    }
    return text;
}

QString verdictText(const StoredHistory& history, const HistoryCharts& charts,
                    const HistoryView& view, std::size_t baseline) {
    const std::size_t values = valuesIn(charts);
    if (!charts.one_gyro) {
        return counted(QT_TRANSLATE_N_NOOP("History", "%n result(s) of all gyros."), values) +
               QLatin1Char(' ') +
               HistoryWords::tr("Limits belong to one gyro: choose one for its control charts.") +
               withoutDate(history, view);
    }
    if (charts.control.fault == BaselineFault::too_few) {
        return limitsText(charts, baseline) + withoutDate(history, view);
    }
    QStringList named;
    std::size_t outside = 0;
    for (std::size_t k = 0; k < charts.values.size(); ++k) {
        if (charts.control.is_out(k)) {
            ++outside;
            if (named.size() < most_named) {
                named << QStringLiteral("%1 (%2)").arg(nameOf(history.points[k]),
                                                       outsideText(charts, k));
            }
        }
    }
    QString text =
        outside == 0
            ? counted(QT_TRANSLATE_N_NOOP("History", "None of %n result(s) is outside the limits."),
                      values)
            : counted(QT_TRANSLATE_N_NOOP("History", "%n result(s) outside the limits:"), outside) +
                  QLatin1Char(' ') + named.join(QStringLiteral("; ")) +
                  (outside > static_cast<std::size_t>(named.size())
                       ? QStringLiteral("; ") +
                             counted(QT_TRANSLATE_N_NOOP("History", "and %n more"),
                                     outside - static_cast<std::size_t>(named.size()))
                       : QString()) +
                  QLatin1Char('.');
    return text + QLatin1Char(' ') + limitsText(charts, baseline) + withoutDate(history, view);
}

}  // namespace vybeg::ui
