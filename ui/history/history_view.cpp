#include "ui/history/history_view.h"

#include "core/resonator/results/resonator_parameters.h"
#include "ui/words/error_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

const std::vector<HistoryParameter>& historyParameters() {
    static const std::vector<HistoryParameter> all = [] {
        std::vector<HistoryParameter> parameters;
        parameters.reserve(resonator_parameters.size() + 2 * mode_parameters.size());
        for (const ResonatorParameter& each : resonator_parameters) {
            parameters.push_back({each.name, each.unit, each.period,
                                  [member = each.member](const Passport& passport) {
                                      return &(passport.resonator.*member);
                                  }});
        }
        for (std::size_t mode = 0; mode < 2; ++mode) {
            for (const ModeParameter& each : mode_parameters) {
                parameters.push_back({"modes[" + std::to_string(mode) + "]." + each.name, each.unit,
                                      0, [mode, member = each.member](const Passport& passport) {
                                          return mode < passport.modes.size()
                                                     ? &(passport.modes[mode].*member)
                                                     : nullptr;
                                      }});
            }
        }
        return parameters;
    }();
    return all;
}

HistoryCharts historyCharts(const std::vector<HistoryPoint>& points,
                            const HistoryParameter& parameter, bool one_gyro,
                            std::size_t baseline) {
    HistoryCharts charts;
    charts.one_gyro = one_gyro;
    std::vector<double> finite;
    for (const HistoryPoint& point : points) {
        charts.values.push_back(point.value.value);
        charts.u.push_back(point.value.uncertainty());
    }
    if (one_gyro) {
        charts.values = beside_first(charts.values, parameter.period);
    }
    for (const double value : charts.values) {
        if (std::isfinite(value)) {
            finite.push_back(value);
        }
    }
    charts.control = control_charts(charts.values, charts.u, one_gyro ? baseline : 0);
    charts.moments = moments_of(finite);
    charts.histogram = histogram_of(finite, charts.moments);
    return charts;
}

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
    XYSeries series{.ink = Ink::text, .points = true, .x = at.x};
    for (const std::size_t k : at.points) {
        series.y.push_back(factor * values[k]);
    }
    return series;
}

// Ends of a level below all points; about a single place as wide as shows it.
std::vector<double> acrossAll(const XYPlot& plot) {
    const auto [least, most] = std::ranges::minmax(plot.series.front().x);
    // Of the order of the results half a place; of a date days, of a frequency 1e-6.
    constexpr double days_s = 3 * 86400.0;
    const double aside = most > least               ? 0
                         : plot.x_is_date           ? days_s
                         : std::abs(least) < 1000.0 ? 0.5
                                                    : 1e-6 * std::abs(least);
    return {least - aside, most + aside};
}

// A level across the plot.
void addLevel(XYPlot& plot, const QString& name, double level, Ink ink, bool dashed) {
    if (!std::isfinite(level) || plot.series.front().x.empty()) {
        return;
    }
    plot.series.push_back(dashedLine(name, ink, acrossAll(plot), {level, level}));
    plot.series.back().dashed = dashed;
}

// Limits that may differ from point to point, about `centre`.
void addLimits(XYPlot& plot, const Placed& at, const QString& name, double centre,
               const std::vector<double>& limits, double factor, bool both_sides = true) {
    XYSeries upper = dashedLine(name, Ink::muted, at.x);
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

// The name of a series in the legend, with the note about the baseline.
QString withBaseline(const QString& name, const HistoryCharts& charts, bool sets_limits) {
    const bool has_limits = charts.control.fault != BaselineFault::too_few;
    const QString note = charts.one_gyro && has_limits == sets_limits ? baselineText(charts) : "";
    return note.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, note);
}

// Points that lie outside in another colour and shape, and the chosen one.
void addMarks(HistoryPlot& shown, const std::vector<bool>& out, const HistoryView& view,
              const QString& outside_name = {}) {
    const XYSeries& points = shown.plot.series.front();
    XYSeries outside{.name = outside_name, .style = 3, .ink = Ink::warning, .points = true};
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

struct SequenceTexts {
    QString name;  // of the axis
    QString unit;
    QString empty;
    QString points;
    QString limits;
};

// A chart about zero of the results of one gyro in their sequence.
HistoryPlot sequencePlot(const HistoryView& view, const ControlChart& chart, double factor,
                         bool both_sides, const SequenceTexts& texts) {
    const HistoryAxis axis = view.axis == HistoryAxis::frequency ? HistoryAxis::order : view.axis;
    HistoryPlot shown{emptyPlot(view, axis, texts.name, texts.unit), {}};
    shown.plot.empty = texts.empty;
    Placed at = placed(view.history, chart.values, axis);
    if (at.points.empty() || !view.charts.one_gyro) {
        return shown;
    }
    XYSeries points = pointsAt(at, chart.values, factor);
    points.name = texts.points;
    shown.plot.series.push_back(std::move(points));
    addLimits(shown.plot, at, texts.limits, 0, chart.limits, factor, both_sides);
    shown.points = std::move(at.points);
    addMarks(shown, chart.out, view);
    return shown;
}

void addPassport(XYPlot& plot, const HistoryView& view, double factor) {
    if (!view.passport || !std::isfinite(view.passport->value) || plot.series.front().x.empty()) {
        return;
    }
    const double value = factor * view.passport->value;
    XYSeries band{.name = HistoryWords::tr("passport ± 3 u"),
                  .ink = Ink::channel_c,
                  .x = acrossAll(plot),
                  .y = {value, value}};
    const double wide = std::abs(factor) * passport_deviations * view.passport->u;
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
    return sequencePlot(view, view.charts.control.ranges, std::abs(parameter.factor), false,
                        {HistoryWords::tr("Change from the one before"), parameter.unit,
                         HistoryWords::tr("A change needs two results of one gyro in their order."),
                         HistoryWords::tr("moving range"), HistoryWords::tr("limit")});
}

HistoryPlot averagePlot(const HistoryView& view) {
    return sequencePlot(
        view, view.charts.control.average, 1, true,
        {HistoryWords::tr("Weighted average (EWMA)"), HistoryWords::tr("sd"),
         HistoryWords::tr("This chart needs ten results of one gyro to set its limits."),
         HistoryWords::tr("average"), HistoryWords::tr("limits")});
}

XYPlot distributionPlot(const HistoryView& view) {
    const Shown parameter = shownIn(view);
    XYPlot plot{
        .x_name = parameter.title,
        .x_unit = parameter.unit,
        .y_name = HistoryWords::tr("Results in each step"),
        .empty = HistoryWords::tr("A distribution needs two results with different values.")};
    const Histogram& found = view.charts.histogram;
    if (found.counts.empty()) {
        return plot;
    }
    const auto value = [&](double z) {
        return parameter.factor * (view.charts.moments.mean + z * view.charts.moments.sd);
    };
    XYSeries steps = histogramSteps(found, HistoryWords::tr("results"), Ink::channel_c);
    std::ranges::transform(steps.x, steps.x.begin(), value);
    const double area = found.width * static_cast<double>(view.charts.moments.count);
    XYSeries normal = normalCurve(HistoryWords::tr("normal"), area, 121);
    std::ranges::transform(normal.x, normal.x.begin(), value);
    plot.series = {std::move(steps), std::move(normal)};
    return plot;
}

AxisRange wholeRange(const HistoryView& view, const XYPlot& values) {
    AxisRange range = shownValues(values);
    const Histogram& found = view.charts.histogram;
    if (found.counts.empty()) {
        return range;
    }
    constexpr double normal_reach = 3;  // beyond, the curve is on the axis
    const auto is_filled = [](std::int64_t count) { return count > 0; };
    const auto bins = static_cast<double>(found.counts.size());
    const auto before =
        static_cast<double>(std::ranges::find_if(found.counts, is_filled) - found.counts.begin());
    const auto behind =
        static_cast<double>(std::find_if(found.counts.rbegin(), found.counts.rend(), is_filled) -
                            found.counts.rbegin());
    const double low = std::min(found.low + before * found.width, -normal_reach);
    const double high = std::max(found.low + (bins - behind) * found.width, normal_reach);
    const double factor = shownIn(view).factor;
    const double a = factor * (view.charts.moments.mean + low * view.charts.moments.sd);
    const double b = factor * (view.charts.moments.mean + high * view.charts.moments.sd);
    const double spare = 0.02 * std::abs(b - a);
    range.lower = std::min({range.lower, a - spare, b - spare});
    range.upper = std::max({range.upper, a + spare, b + spare});
    return range;
}

XYPlot besideValues(XYPlot distribution, const XYPlot& values) {
    distribution.turned = true;
    distribution.x_range = shownValues(values);
    for (XYSeries& series : distribution.series) {
        series.name.clear();
    }
    return distribution;
}

namespace {

constexpr qsizetype most_named = 5;

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

int valuesIn(const HistoryCharts& charts) {
    return static_cast<int>(
        std::ranges::count_if(charts.values, [](double value) { return std::isfinite(value); }));
}

QString withoutDate(const HistoryView& view) {
    const auto count = std::ranges::count_if(view.history.points, [](const HistoryPoint& point) {
        return !std::isfinite(point.time_s);
    });
    return count == 0 || view.axis != HistoryAxis::date
               ? QString()
               : QLatin1Char(' ') + HistoryWords::tr(
                                        "%n result(s) without a date are not shown; by "
                                        "order they are.",
                                        nullptr, static_cast<int>(count));
}

// The results that break the limits of the gyro, which matter more than those of the charts.
QString brokenText(const HistoryView& view) {
    const auto breaks = [&view](const HistoryPoint& point) {
        return conformity(point.value, *view.limit) == Conformity::outside;
    };
    const auto broken = view.limit ? std::ranges::count_if(view.history.points, breaks) : 0;
    return broken == 0 ? QString()
                       : HistoryWords::tr("⚠ %n result(s) break the limits of the gyro.", nullptr,
                                          static_cast<int>(broken)) +
                             QLatin1Char(' ');
}

// The origin of the limits, and the note about it.
QString limitsText(const HistoryCharts& charts, std::size_t baseline) {
    if (charts.control.fault == BaselineFault::too_few) {
        return HistoryWords::tr(
                   "Limits need %1 results of this gyro that differ and have about the same "
                   "uncertainty; the baseline has %2.")
            .arg(least_baseline)
            .arg(charts.control.used);
    }
    QString text = HistoryWords::tr("The first %n result(s) set the limits.", nullptr,
                                    std::min(valuesIn(charts), static_cast<int>(baseline)));
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
        return QStringLiteral("; ") + text.arg(shortNumberText(value, digits));
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
        text += QStringLiteral("; ") +
                HistoryWords::tr("f = %1 Hz")
                    .arg(valueText(at.f_mean_hz.value, at.f_mean_hz.uncertainty()));
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
    const int values = valuesIn(view.charts);
    if (!view.charts.one_gyro) {
        return HistoryWords::tr("%n result(s) of all gyros.", nullptr, values) + QLatin1Char(' ') +
               HistoryWords::tr("Limits belong to one gyro: choose one for its control charts.") +
               withoutDate(view);
    }
    if (view.charts.control.fault == BaselineFault::too_few) {
        return brokenText(view) + limitsText(view.charts, view.baseline) + withoutDate(view);
    }
    QStringList named;
    int outside = 0;
    for (std::size_t k = 0; k < view.charts.values.size(); ++k) {
        if (view.charts.control.is_out(k)) {
            ++outside;
            if (named.size() < most_named) {
                named << QStringLiteral("%1 (%2)").arg(nameOf(view.history.points[k]),
                                                       outsideText(view.charts, k));
            }
        }
    }
    const int more = outside - static_cast<int>(named.size());
    const QString text =
        outside == 0
            ? HistoryWords::tr("None of %n result(s) is outside the control limits.", nullptr,
                               values)
            : HistoryWords::tr("%n result(s) outside the control limits:", nullptr, outside) +
                  QLatin1Char(' ') + named.join(QStringLiteral("; ")) +
                  (more > 0 ? QStringLiteral("; ") + HistoryWords::tr("and %n more", nullptr, more)
                            : QString()) +
                  QLatin1Char('.');
    return brokenText(view) + text + QLatin1Char(' ') + limitsText(view.charts, view.baseline) +
           withoutDate(view);
}

}  // namespace vybeg::ui
