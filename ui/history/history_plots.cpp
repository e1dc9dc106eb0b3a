#include "ui/history/history_plots.h"

#include "core/numerics/control_chart.h"
#include "ui/resonator/parameter_text.h"
#include "ui/words/unit_text.h"

#include <QCoreApplication>

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

HistoryAxis shownAxis(const std::optional<StoredHistory>& history, HistoryAxis chosen) {
    const bool undated = history && !history->points.empty() &&
                         std::ranges::none_of(history->points, [](const HistoryPoint& point) {
                             return std::isfinite(point.time_s);
                         });
    return undated && chosen == HistoryAxis::date ? HistoryAxis::order : chosen;
}

QString parameterTitle(const HistoryParameter& parameter) {
    const auto dot = parameter.name.find('.');
    if (dot == std::string::npos) {
        return shownAs(parameter.name, parameter.unit, {}).title;
    }
    return modeTitle(parameter.name[dot - 2] - '0', parameter.name.substr(dot + 1));
}

QString parameterUnit(const HistoryParameter& parameter, const DisplayUnits& units) {
    return shownAs(parameter.name, parameter.unit, units).unit;
}

double parameterFactor(const HistoryParameter& parameter, const DisplayUnits& units) {
    return shownAs(parameter.name, parameter.unit, units).factor;
}

HistoryPlot valuesPlot(const StoredHistory& history, const HistoryCharts& charts,
                       const HistoryView& view) {
    const double factor = parameterFactor(view.parameter, view.units);
    Placed at = placed(history, charts.values, view.axis);
    HistoryPlot shown{emptyPlot(view, view.axis, parameterTitle(view.parameter),
                                parameterUnit(view.parameter, view.units)),
                      {}};
    if (at.points.empty()) {
        return shown;
    }
    XYSeries values = pointsAt(at, charts.values, factor);
    values.name = withBaseline(HistoryWords::tr("values ± u"), charts, false);
    for (const std::size_t k : at.points) {
        values.sd.push_back(std::isfinite(charts.u[k]) ? std::abs(factor) * charts.u[k] : 0);
    }
    shown.plot.series.push_back(std::move(values));
    addLevel(shown.plot, HistoryWords::tr("centre"), factor * charts.control.centre, Ink::muted,
             false);
    addLimits(shown.plot, at, withBaseline(HistoryWords::tr("limits"), charts, true),
              charts.control.centre, charts.control.individuals.limits, factor);
    shown.points = std::move(at.points);
    if (view.limit) {
        const QString name = HistoryWords::tr("limits of the gyro");
        const auto& [parameter, lower, upper] = *view.limit;
        if (lower) {
            addLevel(shown.plot, name, factor * *lower, Ink::warning, true);
        }
        if (upper) {
            addLevel(shown.plot, lower ? QString() : name, factor * *upper, Ink::warning, true);
        }
    }
    if (charts.one_gyro) {
        addPassport(shown.plot, view, factor);
    }
    addMarks(shown, charts.control.individuals.out, view, HistoryWords::tr("outside"));
    return shown;
}

HistoryPlot rangesPlot(const StoredHistory& history, const HistoryCharts& charts,
                       const HistoryView& view) {
    const double factor = std::abs(parameterFactor(view.parameter, view.units));
    const HistoryAxis axis = sequenceAxis(view.axis);
    HistoryPlot shown{emptyPlot(view, axis, HistoryWords::tr("Change from the one before"),
                                parameterUnit(view.parameter, view.units)),
                      {}};
    shown.plot.empty = HistoryWords::tr("A change needs two results of one gyro in their order.");
    Placed at = placed(history, charts.control.ranges.values, axis);
    if (at.points.empty() || !charts.one_gyro) {
        return shown;
    }
    XYSeries ranges = pointsAt(at, charts.control.ranges.values, factor);
    ranges.name = HistoryWords::tr("moving range");
    shown.plot.series.push_back(std::move(ranges));
    addLimits(shown.plot, at, HistoryWords::tr("limit"), 0, charts.control.ranges.limits, factor,
              false);
    shown.points = std::move(at.points);
    addMarks(shown, charts.control.ranges.out, view);
    return shown;
}

HistoryPlot averagePlot(const StoredHistory& history, const HistoryCharts& charts,
                        const HistoryView& view) {
    const HistoryAxis axis = sequenceAxis(view.axis);
    HistoryPlot shown{
        emptyPlot(view, axis, HistoryWords::tr("Weighted average (EWMA)"), HistoryWords::tr("sd")),
        {}};
    Placed at = placed(history, charts.control.average.values, axis);
    if (at.points.empty() || !charts.one_gyro) {
        shown.plot.empty =
            HistoryWords::tr("This chart needs ten results of one gyro to set its limits.");
        return shown;
    }
    XYSeries average = pointsAt(at, charts.control.average.values, 1);
    average.name = HistoryWords::tr("average");
    shown.plot.series.push_back(std::move(average));
    addLimits(shown.plot, at, HistoryWords::tr("limits"), 0, charts.control.average.limits, 1);
    shown.points = std::move(at.points);
    addMarks(shown, charts.control.average.out, view);
    return shown;
}

XYPlot distributionPlot(const HistoryCharts& charts, const HistoryView& view) {
    XYPlot plot;
    plot.x_name = parameterTitle(view.parameter);
    plot.x_unit = parameterUnit(view.parameter, view.units);
    plot.y_name = HistoryWords::tr("Results in each step");
    plot.empty = HistoryWords::tr("A distribution needs two results with different values.");
    const Histogram& found = charts.histogram;
    if (found.counts.empty()) {
        return plot;
    }
    const double factor = parameterFactor(view.parameter, view.units);
    const auto value = [&](double z) {
        return factor * (charts.moments.mean + z * charts.moments.sd);
    };
    XYSeries steps;
    steps.name = HistoryWords::tr("results");
    steps.steps = true;
    steps.ink = Ink::channel_c;
    const auto add = [&](double bin, double count) {
        steps.x.push_back(value(found.low + (bin + 0.5) * found.width));
        steps.y.push_back(count);
    };
    // The first and last steps fall to zero.
    add(-1, 0);
    for (std::size_t k = 0; k < found.counts.size(); ++k) {
        add(static_cast<double>(k), static_cast<double>(found.counts[k]));
    }
    add(static_cast<double>(found.counts.size()), 0);
    XYSeries normal;
    normal.name = HistoryWords::tr("normal");
    normal.ink = Ink::text;
    normal.dashed = true;
    constexpr int points = 121;
    constexpr double reach = 4;
    const double scale =
        found.width * static_cast<double>(charts.moments.count) / std::sqrt(2 * std::numbers::pi);
    for (int k = 0; k < points; ++k) {
        const double z = reach * (2.0 * k / (points - 1) - 1);
        normal.x.push_back(value(z));
        normal.y.push_back(scale * std::exp(-0.5 * z * z));
    }
    plot.series = {std::move(steps), std::move(normal)};
    return plot;
}

}  // namespace vybeg::ui
