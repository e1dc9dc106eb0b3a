#include "ui/history/history_view.h"

#include "core/numerics/control_chart.h"
#include "ui/words/error_text.h"
#include "ui/words/unit_text.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace vybeg::ui {

namespace {

// Deviations of the passport's value that its band covers: those of a change of one parameter.
constexpr double passport_deviations = 3;

// Points in the order of an axis, with their places on it.
struct Placed {
    std::vector<std::size_t> points;
    std::vector<double> x;
};

Placed placed(const StoredHistory& history, const std::vector<double>& values, HistoryAxis axis) {
    const auto place = [&](std::size_t k) {
        const HistoryPoint& point = history.points[k];
        return axis == HistoryAxis::date        ? point.time_s
               : axis == HistoryAxis::frequency ? point.f_mean_hz.value
                                                : static_cast<double>(k + 1);
    };
    Placed placed;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (std::isfinite(values[k]) && std::isfinite(place(k))) {
            placed.points.push_back(k);
        }
    }
    std::ranges::stable_sort(placed.points, {}, place);
    for (const std::size_t k : placed.points) {
        placed.x.push_back(place(k));
    }
    return placed;
}

HistoryAxis sequenceAxis(HistoryAxis axis) {
    return axis == HistoryAxis::frequency ? HistoryAxis::order : axis;
}

XYPlot emptyPlot(const HistoryView& view, HistoryAxis axis, const QString& y_name,
                 const QString& y_unit) {
    XYPlot plot;
    plot.x_is_date = axis == HistoryAxis::date;
    plot.x_name = axis == HistoryAxis::date        ? HistoryWords::tr("Date (UTC)")
                  : axis == HistoryAxis::frequency ? HistoryWords::tr("Mean frequency f")
                                                   : HistoryWords::tr("Order of the results");
    plot.x_unit = axis == HistoryAxis::frequency ? unitText("Hz") : QString();
    plot.y_name = y_name;
    plot.y_unit = y_unit;
    plot.empty = axis == HistoryAxis::date && view.axis == HistoryAxis::date
                     ? HistoryWords::tr("No result with a date has a value of this parameter.")
                     : HistoryWords::tr("No result has a value of this parameter.");
    return plot;
}

XYSeries pointsAt(const Placed& at, const std::vector<double>& values, double factor) {
    XYSeries series;
    series.points = true;
    series.ink = Ink::text;
    series.x = at.x;
    for (const std::size_t k : at.points) {
        series.y.push_back(factor * values[k]);
    }
    return series;
}

// Ends of a level below all points; about a single place as wide as shows it.
std::vector<double> acrossAll(const std::vector<double>& x) {
    const auto [least, most] = std::ranges::minmax(x);
    // Of the order of the results half a place; of a date minutes, of a frequency 1e-6.
    const double aside = most > least ? 0 : std::abs(least) < 1000 ? 0.5 : 1e-6 * std::abs(least);
    return {least - aside, most + aside};
}

// A level across the plot.
void addLevel(XYPlot& plot, const QString& name, double level, Ink ink, bool dashed) {
    const std::vector<double>& x = plot.series.front().x;
    if (!std::isfinite(level) || x.empty()) {
        return;
    }
    XYSeries line;
    line.name = name;
    line.ink = ink;
    line.dashed = dashed;
    line.x = acrossAll(x);
    line.y = {level, level};
    plot.series.push_back(std::move(line));
}

// Limits that may differ from point to point, about `centre`.
void addLimits(XYPlot& plot, const Placed& at, const QString& name, double centre,
               const std::vector<double>& limits, double factor, bool both_sides = true) {
    XYSeries upper;
    upper.name = name;
    upper.ink = Ink::muted;
    upper.dashed = true;
    upper.x = at.x;
    XYSeries lower = upper;
    lower.name.clear();
    for (const std::size_t k : at.points) {
        upper.y.push_back(factor * (centre + limits[k]));
        lower.y.push_back(factor * (centre - limits[k]));
    }
    if (at.points.empty() || !std::isfinite(upper.y.front())) {
        return;
    }
    plot.series.push_back(std::move(upper));
    if (both_sides) {
        plot.series.push_back(std::move(lower));
    }
}

// What the baseline has that the limits do not allow for; empty: nothing.
QString baselineText(const HistoryCharts& charts) {
    switch (charts.control.fault) {
        case BaselineFault::none: break;
        case BaselineFault::too_few:
            return HistoryWords::tr("limits need %1 results, there are %2")
                .arg(least_baseline)
                .arg(charts.control.used);
        case BaselineFault::trend: return HistoryWords::tr("the baseline has a trend");
        case BaselineFault::correlated:
            return HistoryWords::tr("neighbours in the baseline are correlated");
    }
    return {};
}

// The name of a series in the legend, with what is to be known of the baseline.
QString withBaseline(const QString& name, const HistoryCharts& charts, bool sets_limits) {
    const bool has_limits = charts.control.fault != BaselineFault::too_few;
    const QString note = charts.one_gyro && has_limits == sets_limits ? baselineText(charts) : "";
    return note.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, note);
}

// Points that lie outside in another colour and shape, and the chosen one.
void addMarks(HistoryPlot& shown, const std::vector<bool>& out, const HistoryView& view,
              const QString& outside_name = {}) {
    const XYSeries& points = shown.plot.series.front();
    XYSeries outside;
    outside.name = outside_name;
    outside.points = true;
    outside.style = 3;
    outside.ink = Ink::warning;
    std::optional<XYSeries> chosen;
    for (std::size_t k = 0; k < shown.points.size(); ++k) {
        if (out[shown.points[k]]) {
            outside.x.push_back(points.x[k]);
            outside.y.push_back(points.y[k]);
        }
        if (view.chosen == shown.points[k]) {
            chosen = markOn(points, k, Ink::accent);
        }
    }
    if (!outside.x.empty()) {
        shown.plot.series.push_back(std::move(outside));
    }
    if (chosen) {
        shown.plot.series.push_back(std::move(*chosen));
    }
}

void addPassport(XYPlot& plot, const HistoryView& view, double factor) {
    const std::vector<double>& x = plot.series.front().x;
    if (!std::isfinite(view.passport.value) || x.empty()) {
        return;
    }
    XYSeries band;
    band.name = HistoryWords::tr("passport ± 3 u");
    band.ink = Ink::channel_c;
    band.x = acrossAll(x);
    band.y = {factor * view.passport.value, factor * view.passport.value};
    const double wide = std::abs(factor) * passport_deviations * view.passport.u;
    if (std::isfinite(wide)) {
        band.sd = {wide, wide};
    }
    plot.series.push_back(std::move(band));
}

}  // namespace

HistoryAxis shownAxis(const StoredHistory& history, HistoryAxis chosen) {
    const bool undated = !history.points.empty() &&
                         std::ranges::none_of(history.points, [](const HistoryPoint& point) {
                             return std::isfinite(point.time_s);
                         });
    return undated && chosen == HistoryAxis::date ? HistoryAxis::order : chosen;
}

Shown shownIn(const HistoryView& view) {
    return shownAs(view.parameter.name, view.parameter.unit, view.units);
}

HistoryPlot valuesPlot(const HistoryView& view) {
    const Shown parameter = shownIn(view);
    const double factor = parameter.factor;
    Placed at = placed(view.history, view.charts.values, view.axis);
    HistoryPlot shown{emptyPlot(view, view.axis, parameter.title, parameter.unit), {}};
    if (at.points.empty()) {
        return shown;
    }
    XYSeries values = pointsAt(at, view.charts.values, factor);
    values.name = withBaseline(HistoryWords::tr("values ± u"), view.charts, false);
    for (const std::size_t k : at.points) {
        values.sd.push_back(std::isfinite(view.charts.u[k]) ? std::abs(factor) * view.charts.u[k]
                                                            : 0);
    }
    shown.plot.series.push_back(std::move(values));
    addLevel(shown.plot, HistoryWords::tr("centre"), factor * view.charts.control.centre,
             Ink::muted, false);
    addLimits(shown.plot, at, withBaseline(HistoryWords::tr("limits"), view.charts, true),
              view.charts.control.centre, view.charts.control.individuals.limits, factor);
    shown.points = std::move(at.points);
    if (view.limit) {
        const QString name = HistoryWords::tr("limits of the gyro");
        const auto& [name_of_it, lower, upper] = *view.limit;
        if (lower) {
            addLevel(shown.plot, name, factor * *lower, Ink::warning, true);
        }
        if (upper) {
            addLevel(shown.plot, lower ? QString() : name, factor * *upper, Ink::warning, true);
        }
    }
    if (view.charts.one_gyro) {
        addPassport(shown.plot, view, factor);
    }
    addMarks(shown, view.charts.control.individuals.out, view, HistoryWords::tr("outside"));
    return shown;
}

HistoryPlot rangesPlot(const HistoryView& view) {
    const Shown parameter = shownIn(view);
    const double factor = std::abs(parameter.factor);
    const HistoryAxis axis = sequenceAxis(view.axis);
    HistoryPlot shown{
        emptyPlot(view, axis, HistoryWords::tr("Change from the one before"), parameter.unit), {}};
    shown.plot.empty = HistoryWords::tr("A change needs two results of one gyro in their order.");
    Placed at = placed(view.history, view.charts.control.ranges.values, axis);
    if (at.points.empty() || !view.charts.one_gyro) {
        return shown;
    }
    XYSeries ranges = pointsAt(at, view.charts.control.ranges.values, factor);
    ranges.name = HistoryWords::tr("moving range");
    shown.plot.series.push_back(std::move(ranges));
    addLimits(shown.plot, at, HistoryWords::tr("limit"), 0, view.charts.control.ranges.limits,
              factor, false);
    shown.points = std::move(at.points);
    addMarks(shown, view.charts.control.ranges.out, view);
    return shown;
}

HistoryPlot averagePlot(const HistoryView& view) {
    const HistoryAxis axis = sequenceAxis(view.axis);
    HistoryPlot shown{
        emptyPlot(view, axis, HistoryWords::tr("Weighted average (EWMA)"), HistoryWords::tr("sd")),
        {}};
    Placed at = placed(view.history, view.charts.control.average.values, axis);
    if (at.points.empty() || !view.charts.one_gyro) {
        shown.plot.empty =
            HistoryWords::tr("This chart needs ten results of one gyro to set its limits.");
        return shown;
    }
    XYSeries average = pointsAt(at, view.charts.control.average.values, 1);
    average.name = HistoryWords::tr("average");
    shown.plot.series.push_back(std::move(average));
    addLimits(shown.plot, at, HistoryWords::tr("limits"), 0, view.charts.control.average.limits, 1);
    shown.points = std::move(at.points);
    addMarks(shown, view.charts.control.average.out, view);
    return shown;
}

XYPlot distributionPlot(const HistoryView& view) {
    XYPlot plot;
    const Shown parameter = shownIn(view);
    plot.x_name = parameter.title;
    plot.x_unit = parameter.unit;
    plot.y_name = HistoryWords::tr("Results in each step");
    plot.empty = HistoryWords::tr("A distribution needs two results with different values.");
    const Histogram& found = view.charts.histogram;
    if (found.counts.empty()) {
        return plot;
    }
    const auto value = [&](double z) {
        return parameter.factor * (view.charts.moments.mean + z * view.charts.moments.sd);
    };
    XYSeries steps = histogramSteps(found, HistoryWords::tr("results"), Ink::channel_c);
    std::ranges::transform(steps.x, steps.x.begin(), value);
    XYSeries normal = dashedLine(HistoryWords::tr("normal"), Ink::text);
    constexpr int points = 121;
    constexpr double reach = 4;
    const double scale = found.width * static_cast<double>(view.charts.moments.count) /
                         std::sqrt(2 * std::numbers::pi);
    for (int k = 0; k < points; ++k) {
        const double z = reach * (2.0 * k / (points - 1) - 1);
        normal.x.push_back(value(z));
        normal.y.push_back(scale * std::exp(-0.5 * z * z));
    }
    plot.series = {std::move(steps), std::move(normal)};
    return plot;
}

namespace {

constexpr qsizetype most_named = 5;

QString counted(const char* text, std::size_t count) {
    return QCoreApplication::translate("History", text, nullptr, static_cast<int>(count));
}

}  // namespace

QString nameOf(const HistoryPoint& point) {
    QStringList parts;
    for (const std::string& part : {point.gyro, point.date.text, point.set}) {
        if (!part.empty() && !parts.contains(QString::fromStdString(part))) {
            parts << QString::fromStdString(part);
        }
    }
    return parts.join(QStringLiteral(", "));
}

namespace {

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

QString withoutDate(const HistoryView& view) {
    const auto count = std::ranges::count_if(view.history.points, [](const HistoryPoint& point) {
        return !std::isfinite(point.time_s);
    });
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

QString pointText(const HistoryView& view, std::size_t point) {
    const HistoryPoint& at = view.history.points[point];
    const Shown parameter = shownIn(view);
    const double factor = parameter.factor;
    const QString& unit = parameter.unit;
    const auto numbered = [](const QString& text, double value, int digits) {
        return QStringLiteral("; ") + text.arg(QLocale().toString(value, 'g', digits));
    };
    QString text = QStringLiteral("%1: %2").arg(
        nameOf(at),
        std::isfinite(view.charts.values[point])
            ? valueText(factor * view.charts.values[point], std::abs(factor) * view.charts.u[point])
            : reasonText(at.value.reason));
    if (std::isfinite(view.charts.values[point]) && !unit.isEmpty()) {
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
    if (const QString outside = outsideText(view.charts, point); !outside.isEmpty()) {
        text += QStringLiteral("; ") + outside;
    }
    return text;
}

QString verdictText(const HistoryView& view) {
    const std::size_t values = valuesIn(view.charts);
    if (!view.charts.one_gyro) {
        return counted(QT_TRANSLATE_N_NOOP("History", "%n result(s) of all gyros."), values) +
               QLatin1Char(' ') +
               HistoryWords::tr("Limits belong to one gyro: choose one for its control charts.") +
               withoutDate(view);
    }
    if (view.charts.control.fault == BaselineFault::too_few) {
        return limitsText(view.charts, view.baseline) + withoutDate(view);
    }
    QStringList named;
    std::size_t outside = 0;
    for (std::size_t k = 0; k < view.charts.values.size(); ++k) {
        if (view.charts.control.is_out(k)) {
            ++outside;
            if (named.size() < most_named) {
                named << QStringLiteral("%1 (%2)").arg(nameOf(view.history.points[k]),
                                                       outsideText(view.charts, k));
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
    return text + QLatin1Char(' ') + limitsText(view.charts, view.baseline) + withoutDate(view);
}

}  // namespace vybeg::ui
